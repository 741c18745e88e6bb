// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/model/leg_solution.hpp>
#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// Acceleration of gravity [m/s²].
inline constexpr double kStandardGravity = 9.81;

/// The measures of a robot in its stance from which all its parameters follow. With the workspace
/// centres c_i and radii R_i:
///
///     L = ½ (max x − min x + max y − min y of c_i)                       size
///     ℓ = λ min(min R_i, 0.22 L, 0.45 min |c_i − c_j|)                   reach of a step
///     T = s √(L / g)                                                     time
///
/// λ ≤ 1 is the largest share for which the whole volume of a swing is within the legs' reach: discs
/// of radius 0.55 · stroke about the centres, from below the ground up to the apex; and for which a leg
/// carries its standing_load() all over the disc on the ground within its joints' efforts. s ≥ 1 is the
/// least factor at which the joints, at 0.9 of their greatest speeds, move the foot throughout this
/// volume as fast as a whole stroke in the time of a transfer asks, and the descent: |q̇| = |J⁺ v|.
/// What a swing does faster than that, as its rise, is bounded by v→ and v↑, and takes longer by
/// itself: the rest of the step does not wait for slow joints.
struct RobotScale {
  double size = 0.0;        ///< L [m]
  double room = 0.0;        ///< λ
  double reach = 0.0;       ///< ℓ [m]
  double time = 0.0;        ///< T [s]
  double free_time = 0.0;   ///< √(L/g), T of joints that are fast enough [s]
  double outer = 0.0;       ///< the farthest workspace centre from the body's origin [m]
  double hip_height = 0.0;  ///< of the body's origin above the feet [m]
  double weight = 0.0;      ///< m g [N]
  double gravity = 0.0;     ///< [m/s²]
  int legs = 0;
  double sideways = 0.0;  ///< speed of the feet that the joints allow throughout the volume [m/s]
  double upwards = 0.0;   ///< the same, up and down [m/s]
  double crossing = 0.0;  ///< v⇒: sideways over the workspaces' centres [m/s]
};

/// @pre the robot is in a stance: p_BC, workspace_radius and q_nominal of its legs are set
[[nodiscard]] RobotScale scale_of(const RobotModel& model, double gravity = kStandardGravity);

/// ℓ/T of a step no part of which would wait for slow joints, the rise neither: the measure by which
/// stances are compared [m/s].
[[nodiscard]] double pace_of(const RobotScale& scale);

/// The load of a foot while the robot stands on the feet of every other leg, and one of them carries as
/// much as the middle one of three: half of the weight, of 2k legs 1/(k − 1) [N].
[[nodiscard]] double standing_load(const RobotModel& model, double gravity = kStandardGravity);

/// The joint efforts of a leg that carries this load [N], and its own links [N m].
[[nodiscard]] LegJoints standing_effort(const LegModel& leg, const LegSolution& solution,
                                        double load, double gravity = kStandardGravity);

/// What a parameter is proportional to.
enum class ScaleOf : std::uint8_t {
  none,          ///< a number, or a time of the sensors
  size,          ///< L
  height,        ///< h, of the body's origin above the feet
  reach,         ///< ℓ
  time,          ///< T
  speed,         ///< ℓ / T
  acceleration,  ///< ℓ / T²
  rate,          ///< 1 / T
  tipping,       ///< g L / hip height: what moves the zero-moment point by a share of L
  outer,         ///< farthest foot: of the workspace centres, and half a reach
  step_time,     ///< √(L/g)
  step_rate,     ///< √(g/L)
  foot_load,     ///< m g / n
  stiffness,     ///< m g L
  damping,       ///< m g L √(L/g)
  mobility,      ///< √(g L) / (m g)
  free_speed,    ///< √(g L)
  joint_rise,    ///< speed of the feet upwards that the joints allow
  swing_speed,   ///< over the ground, that the joints allow and a swing needs
  hasty_speed,   ///< the same of a hasty swing
};

/// The measure itself, such as ℓ/T for a speed.
[[nodiscard]] double measure(ScaleOf of, const RobotScale& scale);
/// "ℓ/T"
[[nodiscard]] const char* symbol(ScaleOf of);

}  // namespace hexagait
