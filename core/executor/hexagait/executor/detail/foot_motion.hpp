// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/leg_lane.hpp>

/// The motion of a foot over the ground in one tick. What is called `way_O` is its displacement in the tick,
/// axes of odom [m], to which these add; the lane keeps velocity and acceleration.
namespace hexagait {

/// So many times a speed, but no more than the joints allow.
[[nodiscard]] double faster(double speed, double times, double most) noexcept;

/// Height of the foot's set point, odom [m].
[[nodiscard]] double height_of(const LegLane& lane, const Pose& X_OB) noexcept;

/// Height of the foot itself, odom [m].
[[nodiscard]] double foot_height(const LegLane& lane, const LegSensed& sensed,
                                 const Pose& X_OB) noexcept;

/// Horizontal displacement from the foot to the foothold that is tried [m].
[[nodiscard]] Vector2 way_to_go(const LegLane& lane, const Pose& X_OB) noexcept;

/// Time left for the sideways motion over a way [s].
[[nodiscard]] double time_to_go(const LegLane& lane, const Vector2& way,
                                const SwingParams& params) noexcept;

/// Least time left for a foot that moves in another direction than to its foothold, (swing 7) [s].
[[nodiscard]] double time_to_turn(const LegLane& lane, const Vector2& way,
                                  const SwingParams& params) noexcept;

/// Way left to the apex [m]. An apex out of reach is where the leg ends.
[[nodiscard]] double rise_left(LegLane& lane, const LegSensed& sensed, double height) noexcept;

/// Duration of the rise to the apex: minimum jerk over h in T has the peak speed 1.875 h/T [s].
[[nodiscard]] double rise_time(const LegLane& lane, const SwingParams& params) noexcept;

/// One axis of a minimum-jerk motion, (swing 1).
void move_to(LegLane& lane, int axis, double error, double time_left, double dt,
             Vector3& way_O) noexcept;

/// To the foothold, along both horizontal axes, in no less than `turn` [s].
void move_sideways(LegLane& lane, const Vector2& way, double turn, double dt,
                   const SwingParams& params, Vector3& way_O) noexcept;

/// Brakes along both horizontal axes, (swing 2).
void stop_sideways(LegLane& lane, double dt, Vector3& way_O) noexcept;

/// Brakes along all axes, (swing 2).
void stop(LegLane& lane, double dt, Vector3& way_O) noexcept;

/// Down to the ground where it is expected, and deeper in search of it, (swing 3).
void move_down(LegLane& lane, double height, double dt, const SwingParams& params,
               Vector3& way_O) noexcept;

}  // namespace hexagait
