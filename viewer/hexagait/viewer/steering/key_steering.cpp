// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/viewer/steering/key_steering.hpp>
#include <numbers>

namespace hexagait::viewer {
namespace {

// Of the wheel: curvature grows with the square of its angle.
constexpr double kMostCurvature = 2.0;  // at its stops [1/m]
constexpr double kStop = 150.0;         // its angle there [°]
constexpr double kNotch = 12.0;         // [°]
constexpr double kCrabStep = 15.0;      // [°]
constexpr double kDegree = std::numbers::pi / 180.0;

double curvature_at(double angle) {
  return std::copysign(kMostCurvature * (angle / kStop) * (angle / kStop), angle);
}

double angle_of(double curvature) {
  const double share = std::min(1.0, std::abs(curvature) / kMostCurvature);
  return std::copysign(kStop * std::sqrt(share), curvature);
}

double wrapped(double degrees) { return degrees - 360.0 * std::floor((degrees + 180.0) / 360.0); }

std::optional<Key> letter(char byte) {
  switch (byte) {
    case 'w':
    case 'W':
      return Key::ahead;
    case 's':
    case 'S':
      return Key::backwards;
    case 'a':
    case 'A':
      return Key::left;
    case 'd':
    case 'D':
      return Key::right;
    case 'q':
    case 'Q':
      return Key::crab_left;
    case 'e':
    case 'E':
      return Key::crab_right;
    case 'x':
    case 'X':
      return Key::stop;
    case 'p':
    case 'P':
      return Key::push;
    case 'r':
    case 'R':
      return Key::scramble;
    case ' ':
      return Key::pause;
    case '!':
      return Key::release_emergency_stop;
    case '\b':
    case '\x7f':
      return Key::reset;
    default:
      return {};
  }
}

}  // namespace

std::optional<Key> KeyDecoder::take(char byte) {
  if (state_ == State::escape) {
    // Anything else came after Esc, which a hand in a hurry may press more than once.
    const bool sequence = byte == '[' || byte == 'O';
    state_ = sequence ? State::sequence : State::plain;
    return sequence ? std::nullopt : std::optional(Key::emergency_stop);
  }
  if (byte == '\x1b') {
    state_ = State::escape;
    return {};
  }
  if (state_ == State::sequence) {
    if ('@' <= byte && byte <= '~') state_ = State::plain;  // ends with a letter or ~
    if (byte == 'A') return Key::go;
    if (byte == 'C') return Key::tick;
    return {};
  }
  return letter(byte);
}

std::optional<Key> KeyDecoder::rest() {
  const bool escape = state_ == State::escape;
  state_ = State::plain;
  return escape ? std::optional(Key::emergency_stop) : std::nullopt;
}

KeySteering::KeySteering(const heading_control::Heading& heading) : heading_(heading) { begin(); }

void KeySteering::begin() {
  // A turn in place is at a stop of the wheel.
  curvature_ = std::clamp(heading_.curvature(), -kMostCurvature, kMostCurvature);
  crab_ = wrapped(heading_.crab_angle() / kDegree);
  paused_ = false;
}

std::string KeySteering::message(Key key) {
  switch (key) {
    case Key::ahead:
      crab_ = 0.0;
      return drive();
    case Key::backwards:
      crab_ = -180.0;
      return drive();
    case Key::left:
      bend(1);
      return drive();
    case Key::right:
      bend(-1);
      return drive();
    case Key::crab_left:
      turn(1);
      return drive();
    case Key::crab_right:
      turn(-1);
      return drive();
    case Key::go:
      return drive();
    case Key::stop:
      return R"({"type":"stop"})";
    case Key::pause:
      paused_ = !paused_;
      return fmt::format(R"({{"type":"pause","on":{}}})", paused_);
    case Key::tick:
      paused_ = true;
      return R"({"type":"step","ticks":1})";
    case Key::push:
      return fmt::format(R"({{"type":"push","angle":{}}})", 90.0 * kDegree);
    case Key::scramble:
      return R"({"type":"scramble"})";
    case Key::reset:
      begin();
      return R"({"type":"reset"})";
    case Key::emergency_stop:
      return R"({"type":"estop"})";
    case Key::release_emergency_stop:
      return R"({"type":"release_estop"})";
  }
  return {};
}

void KeySteering::bend(int way) {
  curvature_ = curvature_at(std::clamp(angle_of(curvature_) + kNotch * way, -kStop, kStop));
  if (std::abs(curvature_) < 1e-9) curvature_ = 0.0;
}

void KeySteering::turn(int way) {
  crab_ = wrapped(kCrabStep * (std::round(crab_ / kCrabStep) + way));
}

std::string KeySteering::drive() const {
  return fmt::format(R"({{"type":"drive","curvature":{},"crab":{}}})", curvature_, crab_ * kDegree);
}

}  // namespace hexagait::viewer
