// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/heading_control/heading.hpp>
#include <optional>
#include <string>

/// Steering by the keys of the page, from a terminal: bytes ─▶ keys ─▶ messages of command.hpp.
namespace hexagait::viewer {

enum class Key : std::uint8_t {
  ahead,                   ///< W
  backwards,               ///< S
  left,                    ///< A: curves more to the left
  right,                   ///< D
  crab_left,               ///< Q
  crab_right,              ///< E
  stop,                    ///< X
  go,                      ///< ↑: on along the path that was stopped
  pause,                   ///< Space
  tick,                    ///< →: one control period
  push,                    ///< P
  scramble,                ///< R
  reset,                   ///< Backspace
  emergency_stop,          ///< Esc
  release_emergency_stop,  ///< !
};

/// Reads keys from the bytes that a terminal sends for them.
class KeyDecoder {
 public:
  /// @returns the key that this byte completes; none if it is no key, or in the middle of one
  std::optional<Key> take(char byte);
  /// Nothing came for a while: an Escape that came last was a key of its own.
  std::optional<Key> rest();

 private:
  enum class State : std::uint8_t { plain, escape, sequence };
  State state_ = State::plain;
};

/// What the keys make of the path: curvature in notches of a wheel, crab angle in steps of 15°. The
/// page does the same in steering.js and panels.js.
class KeySteering {
 public:
  /// @param heading  at the start, and after Key::reset
  explicit KeySteering(const heading_control::Heading& heading);

  /// @returns the message for Session::receive()
  [[nodiscard]] std::string message(Key key);

  [[nodiscard]] double curvature() const { return curvature_; }  ///< 1/r, left > 0 [1/m]
  [[nodiscard]] double crab() const { return crab_; }            ///< [°], in [−180, 180)

 private:
  void begin();
  void bend(int way);
  void turn(int way);
  [[nodiscard]] std::string drive() const;

  heading_control::Heading heading_;
  double curvature_ = 0.0, crab_ = 0.0;
  bool paused_ = false;
};

}  // namespace hexagait::viewer
