// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <hexagait/math/geometry.hpp>

/// Box2D works in 32 bits and is tuned for bodies of 0.1 to 10 units: one unit is 10 cm here, and
/// kilogram and second are kept.
namespace hexagait::sim2d::detail {

inline constexpr double kUnits = 10.0;  ///< per metre, and so per newton

[[nodiscard]] inline float units(double metres) { return static_cast<float>(kUnits * metres); }
[[nodiscard]] inline double metres(float units) { return static_cast<double>(units) / kUnits; }

[[nodiscard]] inline b2Vec2 units(const Vector2& p) { return {units(p.x()), units(p.y())}; }
[[nodiscard]] inline Vector2 metres(const b2Vec2& p) { return {metres(p.x), metres(p.y)}; }

[[nodiscard]] inline float force_units(double newtons) { return units(newtons); }
[[nodiscard]] inline float torque_units(double newton_metres) {
  return static_cast<float>(kUnits * kUnits * newton_metres);
}
[[nodiscard]] inline double newtons(float units) { return metres(units); }

/// Who collides with what: feet with the ground of their side, the body with both.
enum Category : std::uint16_t {
  kLeftGround = 1,
  kRightGround = 2,
  kLeftFoot = 4,
  kRightFoot = 8,
  kBody = 16,
};

}  // namespace hexagait::sim2d::detail
