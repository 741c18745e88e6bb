// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/math/planar.hpp>
#include <hexagait/params/params_for.hpp>
#include <limits>

/// Senses of what is around a robot, beside those of its legs, and reactions to them: [PC04] 5.2, the
/// simple navigation of Genghis. The controller of the legs knows nothing of them.
namespace hexagait::navigation {

inline constexpr std::size_t kWhiskers = 2;  ///< left, right
inline constexpr std::size_t kBeams = 4;     ///< from left to right

/// A thin straight feeler, in the body frame [m].
struct Whisker {
  Vector3 root_B = Vector3::Zero();
  Vector3 tip_B = Vector3::Zero();
};

/// An infrared sensor of distance, in the body frame. On level ground it sees the floor ahead: what
/// is nearer is a wall, what is farther a cliff.
struct Beam {
  Vector3 from_B = Vector3::Zero();                                ///< [m]
  Vector3 direction_B = Vector3::UnitX();                          ///< of length 1
  double to_floor = 0.0;                                           ///< distance to level ground [m]
  [[nodiscard]] double longest() const { return 3.0 * to_floor; }  ///< that it measures [m]
};

/// Where the sensors are. The four infrared sensors are those of [PC04] 5 in number; where Genghis II
/// had them, it does not say.
///
/// With R the distance from the body's origin that no foot exceeds, outer + ℓ/2,
///
///     beams     from a mast above the foremost hips to the floor at (1¾ R, ±1¼ R) and (1¾ R, ±5/12 R)
///     whiskers  from the foremost hips to (1.3 R, ±1.1 R), at the height of the body's origin
///
/// So what is wider than 5/6 R and in the way of a robot that walks straight ahead is seen before it
/// is within R, and a robot that has walked straight ahead has seen all ground within R to its sides:
/// there it may turn in place, and go back.
struct SenseLayout {
  std::array<Whisker, kWhiskers> whiskers;
  std::array<Beam, kBeams> beams;
  double foot_circle = 0.0;  ///< R [m]
};

/// @pre the robot is in a stance: see scale_of()
[[nodiscard]] SenseLayout sense_layout_for(const RobotModel& model);

/// What a robot with them senses at one instant.
struct Senses {
  double time = 0.0;                         ///< [s]
  PlanarPose odometry;                       ///< of the base, by its legs: it may drift
  std::array<bool, kWhiskers> touches = {};  ///< a whisker bends
  /// Distance that each beam measures [m]; ∞: it sees nothing.
  std::array<double, kBeams> range = {};
  double pitch = 0.0;  ///< by the inclinometer, > 0: nose down [rad]
};

/// The senses on an endless level floor.
[[nodiscard]] Senses on_the_floor(const SenseLayout& layout);

}  // namespace hexagait::navigation
