// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/executor/base_lane.hpp>
#include <hexagait/executor/tick_motion.hpp>

namespace hexagait {
namespace {

double clamped(double value, double bound) { return std::clamp(value, -bound, bound); }

PlanarTwist wanted_velocity(const BaseAutoCommand& command, const BaseGoal& goal, double dt,
                            const BaseParams& params) {
  const double advance = std::max(std::min(goal.advance, command.max_advance), command.min_advance);
  const double rate = decay_share(params.correction_rate * dt) / dt;
  Vector2 v = rate * command.correction.v;
  if (v.norm() > params.correction_speed) v *= params.correction_speed / v.norm();
  const double w = clamped(rate * command.correction.w, params.correction_turn);
  if (const double way = command.sway.norm(); way > 0.0)
    v +=
        command.sway *
        (approach_speed(way, params.acceleration, params.advance_rate, params.max_speed, dt) / way);
  // What a correction moves the base ahead, its path need not.
  const double ahead = std::max(0.0, v.dot(command.path.v));
  const double most = std::min(params.max_speed, std::max(0.0, command.max_speed - ahead));
  const double speed = approach_speed(advance, params.acceleration, params.advance_rate, most, dt);
  return {speed * command.path.v + v, speed * command.path.w + w};
}

// A change of velocity that is bounded at the outermost foot.
void approach(BaseLane& lane, const PlanarTwist& wanted, double dt, const BaseParams& params) {
  const Vector2 dv = wanted.v - lane.planar.v;
  const double dw = wanted.w - lane.planar.w;
  const double change = dv.norm() + params.outer_radius * std::abs(dw);
  const double share = change > params.acceleration * dt ? params.acceleration * dt / change : 1.0;
  lane.planar.v += share * dv;
  lane.planar.w += share * dw;
}

// (base 2). @returns whether the base does nothing else in this tick
bool brake_off_path(BaseLane& lane, const BaseAutoCommand& command, double dt,
                    const BaseParams& params) {
  const PlanarTwist off = off_path(lane, command.path, params.outer_radius);
  const double turn = params.outer_radius * off.w;
  const double speed = std::sqrt(off.v.squaredNorm() + turn * turn);
  // The exact solution over a tick of dv/dt = −v²/(2 s).
  const double needed = 0.5 * speed * speed / (params.braking_distance + 0.5 * speed * dt);
  const double braking = std::min(needed, command.max_braking);
  if (!(braking > params.acceleration)) return false;
  const double share = std::min(1.0, braking * dt / speed);
  lane.planar.v -= share * off.v;
  lane.planar.w -= share * off.w;
  return true;
}

}  // namespace

PlanarTwist off_path(const BaseLane& lane, const PlanarTwist& path, double arm) noexcept {
  const PlanarTwist& V = lane.planar;
  const double length2 = path.v.squaredNorm() + arm * arm * path.w * path.w;
  if (!(length2 > 0.0)) return V;
  const double product = V.v.dot(path.v) + arm * arm * V.w * path.w;
  const double along = std::max(0.0, product) / length2;
  return {V.v - along * path.v, V.w - along * path.w};
}

void scale(BaseLane& lane, double share) noexcept {
  const Twist V = lane.twist();
  lane = {
      {share * V.v.head<2>(), share * V.w.z()}, share * V.v.z(), share * V.w.x(), share * V.w.y()};
}

void advance(BaseLane& lane, const BaseAutoCommand& command, const BaseGoal& goal, double dt,
             const BaseParams& params) noexcept {
  if (!brake_off_path(lane, command, dt, params))
    approach(lane, wanted_velocity(command, goal, dt, params), dt, params);

  const auto slew = [dt, &params](double& velocity, double error, double bound, double arm) {
    const double most = params.acceleration / arm;
    const double wish = approach_speed(error, most, params.posture_rate, bound, dt);
    velocity += clamped(wish - velocity, most * dt);
  };
  slew(lane.vertical, goal.height, params.height_speed, 1.0);
  slew(lane.roll, goal.roll, params.tilt_speed, params.outer_radius);
  slew(lane.pitch, goal.pitch, params.tilt_speed, params.outer_radius);
}

void brake(BaseLane& lane, double dt, const BaseParams& params) noexcept {
  // Bounded at the outermost foot; all components fall alike, so that the path stays the same.
  const Twist V = lane.twist();
  const double speed = V.v.norm() + params.outer_radius * V.w.norm();
  const double share =
      speed > params.acceleration * dt ? 1.0 - params.acceleration * dt / speed : 0.0;
  scale(lane, share);
}

}  // namespace hexagait
