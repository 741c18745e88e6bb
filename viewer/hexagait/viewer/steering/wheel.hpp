// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <map>

namespace hexagait::viewer {

using Clock = std::chrono::steady_clock;

/// A client's number, from 1 on; 0: none.
using ClientId = std::uint32_t;

/// Who steers. The first client that steers holds the wheel until it lets go, leaves, or has been
/// silent for so long that it must be gone; the others watch. Time comes in as an argument.
class Wheel {
 public:
  /// Silence of the holder after which the robot is stopped.
  static constexpr auto kSilence = std::chrono::milliseconds(500);
  /// Silence of the holder after which another client may take the wheel.
  static constexpr auto kGone = std::chrono::seconds(3);
  /// Messages of a client per second, on average and at once.
  static constexpr double kRate = 120.0, kBurst = 240.0;

  void enter(ClientId client, Clock::time_point now);
  /// @returns true if it held the wheel
  bool leave(ClientId client);

  /// A client has sent something. @returns false if it sends too much: it is not to be read
  [[nodiscard]] bool hear(ClientId client, Clock::time_point now);
  /// It wants to steer. @returns false if another client does
  [[nodiscard]] bool take(ClientId client, Clock::time_point now);
  void release(ClientId client);

  [[nodiscard]] ClientId holder() const { return holder_; }
  /// There is a holder, and it has been silent for too long to go on.
  [[nodiscard]] bool is_silent(Clock::time_point now) const;

 private:
  struct Client {
    Clock::time_point heard;
    double allowed = kBurst;  ///< messages at once
  };
  std::map<ClientId, Client> clients_;
  ClientId holder_ = 0;
};

}  // namespace hexagait::viewer
