// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/executor/detail/foot_motion.hpp>
#include <hexagait/executor/tick_motion.hpp>

namespace hexagait {
namespace {

// Moves the foot along one axis of odom.
void move(LegLane& lane, int axis, const AxisMotion& motion, Vector3& way_O) {
  way_O[axis] += motion.way;
  lane.v_O[axis] = motion.v;
  lane.a_O[axis] = motion.a;
}

// Speed of the descent at the end of the tick, u₁ > 0. Around the expected ground it is slow;
// towards that zone it falls, and below it rises, with the height h off its edge:
//
//     u₁² = u_t² + a h₁,   h₁ = h₀ ∓ ½ (u₀ + u₁) dt                                      (swing 3)
//
// of which u₁ is solved for. So the foot has this speed at this height, whatever the period.
double descent_speed(double off, double u0, double sign, double slow, double bound, double dt,
                     const SwingParams& params) {
  const double a = params.vertical_acceleration;
  if (off + sign * 0.5 * (u0 + slow) * dt <= 0.0) return slow;
  const double half = 0.25 * a * dt, h = off + sign * 0.5 * u0 * dt;
  return std::min(bound, sign * half + std::sqrt(half * half + slow * slow + a * h));
}

}  // namespace

double faster(double speed, double times, double most) noexcept {
  return std::min(times * speed, std::max(speed, most));
}

double height_of(const LegLane& lane, const Pose& X_OB) noexcept {
  return X_OB.R.row(2).dot(lane.p_BF) + X_OB.p.z();
}

double foot_height(const LegLane& lane, const LegSensed& sensed, const Pose& X_OB) noexcept {
  return height_of(lane, X_OB) + X_OB.R.row(2).dot(sensed.off);
}

double time_to_go(const LegLane& lane, const Vector2& way, const SwingParams& params) noexcept {
  return std::max(params.transfer_time - lane.transfer_clock,
                  kMinimumJerkPeak * way.norm() / params.max_speed);
}

double time_to_turn(const LegLane& lane, const Vector2& way, const SwingParams& params) noexcept {
  constexpr double kNaturalPeak = 6.0, kBrakingPeak = 3.94, kPeakAcceleration = 5.774;
  const double distance = way.norm();
  Vector2 off = lane.v_O.head<2>();
  if (distance > 0.0) {
    const double T = std::max(time_to_go(lane, way, params), kMinTimeToGo);
    const double along = std::clamp(off.dot(way) / distance, 0.0, kNaturalPeak * distance / T);
    off -= along / distance * way;
  }
  const double hardest =
      kPeakAcceleration * params.max_speed / (kMinimumJerkPeak * params.transfer_time);
  return kBrakingPeak * off.norm() / hardest;
}

Vector2 way_to_go(const LegLane& lane, const Pose& X_OB) noexcept {
  const Vector3 p_OF = X_OB * lane.p_BF;
  const Vector3 step = lane.step.p_OT - lane.p_OL;
  Vector2 target = (lane.p_OL + lane.reach_fraction * step).head<2>();
  const double length = step.head<2>().norm();
  if (lane.beside != 0.0 && length > 0.0)
    target += lane.beside / length * Vector2(-step.y(), step.x());
  return target - p_OF.head<2>();
}

void move_to(LegLane& lane, int axis, double error, double time_left, double dt,
             Vector3& way_O) noexcept {
  move(lane, axis, minimum_jerk_tick(error, lane.v_O[axis], lane.a_O[axis], time_left, dt), way_O);
}

void move_sideways(LegLane& lane, const Vector2& way, double turn, double dt,
                   const SwingParams& params, Vector3& way_O) noexcept {
  lane.transfer_clock = std::min(lane.transfer_clock, params.transfer_time - turn);
  const double T = std::max(time_to_go(lane, way, params), turn);
  for (int k = 0; k < 2; ++k) move_to(lane, k, way[k], T, dt, way_O);
  lane.transfer_clock += dt;
}

void stop_sideways(LegLane& lane, double dt, Vector3& way_O) noexcept {
  for (int k = 0; k < 2; ++k) move(lane, k, braking_tick(lane.v_O[k], lane.a_O[k], dt), way_O);
}

void stop(LegLane& lane, double dt, Vector3& way_O) noexcept {
  stop_sideways(lane, dt, way_O);
  move(lane, 2, braking_tick(lane.v_O.z(), lane.a_O.z(), dt), way_O);
}

void move_down(LegLane& lane, double height, double dt, const SwingParams& params,
               Vector3& way_O) noexcept {
  const double above = height - lane.step.p_OT.z();
  const double off = std::abs(above) - lane.step.slow_way * params.touchdown_margin;
  const double u0 = std::max(0.0, -lane.v_O.z());
  const double most_down = params.descent_speed;
  const double slow = faster(params.touchdown_speed, lane.step.touchdown, most_down);
  // Deeper the body has to come down as well, and a leg that is ahead of it seems to be over a hole.
  const bool deep = -above > lane.step.profile_height;
  const double times = deep ? 1.0 : lane.step.touchdown;
  const double search = faster(params.search_speed, times, most_down);
  const double speed = above > 0.0 ? descent_speed(off, u0, -1.0, slow, most_down, dt, params)
                                   : descent_speed(off, u0, 1.0, slow, search, dt, params);
  const double most = params.vertical_acceleration * dt;
  const double v = lane.v_O.z(), change = std::clamp(-speed - v, -most, most);
  move(lane, 2, {(v + 0.5 * change) * dt, v + change, change / dt}, way_O);
}

double rise_left(LegLane& lane, const LegSensed& sensed, double height) noexcept {
  const bool above = height > std::max(lane.p_OL.z(), lane.step.p_OT.z());
  if (!sensed.reachable && above) lane.apex_z = std::min(lane.apex_z, height);
  return lane.apex_z - height;
}

double rise_time(const LegLane& lane, const SwingParams& params) noexcept {
  return std::max(params.lift_time,
                  kMinimumJerkPeak * (lane.apex_z - lane.rises_from) / params.max_rise);
}

}  // namespace hexagait
