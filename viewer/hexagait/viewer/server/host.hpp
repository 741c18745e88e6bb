// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <hexagait/viewer/steering/wheel.hpp>
#include <string>
#include <string_view>

namespace hexagait::viewer {

/// What a server puts on a port: a walk that goes on (Session), or a replay (ReplayHost). All functions
/// may be called from any thread.
class Host {
 public:
  enum class Mail : std::uint8_t { scene, ground, setup, action, notice, frame };
  static constexpr int kMailKinds = 6;
  /// What a client has seen of each kind of mail.
  struct Seen {
    std::uint64_t number[kMailKinds] = {};
  };
  struct Letter {
    Mail kind = Mail::frame;
    std::string content;
  };

  Host() = default;
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
  virtual ~Host() = default;

  /// @param news  called when there is mail; empty: nobody is called
  virtual void on_news(std::function<void()> news) = 0;

  [[nodiscard]] virtual ClientId enter() = 0;
  virtual void leave(ClientId client) = 0;

  /// Takes a message of a client. @returns what to answer: nothing, or an error_json()
  [[nodiscard]] virtual std::string receive(ClientId client, std::string_view message) = 0;

  /// The next thing that this client has not seen. @returns false if there is none
  [[nodiscard]] virtual bool newer_than(Seen& seen, Letter& letter) const = 0;
};

}  // namespace hexagait::viewer
