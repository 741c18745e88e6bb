// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/executor/base_lane.hpp>

namespace hexagait {
namespace {

double clamped(double value, double bound) { return std::clamp(value, -bound, bound); }

// (base 1): the speed from which the base can stop at the goal; near it, proportional to the rest.
double approach_speed(double remaining, double max_speed, const BaseParams& params) {
  const double distance = std::abs(remaining);
  const double speed = std::min({std::sqrt(2.0 * params.acceleration * distance),
                                 params.advance_rate * distance, params.max_speed, max_speed});
  return std::copysign(speed, remaining);
}

PlanarTwist wanted_velocity(const BaseAutoCommand& command, const BaseGoal& goal,
                            const BaseParams& params) {
  const double advance = std::min(goal.advance, command.max_advance);
  const double speed = approach_speed(advance, command.max_speed, params);

  Vector2 v = params.correction_rate * command.correction.v;
  if (v.norm() > params.correction_speed) v *= params.correction_speed / v.norm();
  const double w = clamped(params.correction_rate * command.correction.w, params.correction_turn);
  return {speed * command.path.v + v, speed * command.path.w + w};
}

}  // namespace

void advance(BaseLane& lane, const BaseAutoCommand& command, const BaseGoal& goal, double dt,
             const BaseParams& params) noexcept {
  const PlanarTwist wanted = wanted_velocity(command, goal, params);

  // Bounded change of velocity, measured at the outermost foot.
  const Vector2 dv = wanted.v - lane.planar.v;
  const double dw = wanted.w - lane.planar.w;
  const double change = dv.norm() + params.outer_radius * std::abs(dw);
  const double share = change > params.acceleration * dt ? params.acceleration * dt / change : 1.0;
  lane.planar.v += share * dv;
  lane.planar.w += share * dw;

  const auto slew = [dt, &params](double& velocity, double error, double bound, double arm) {
    const double wish = clamped(params.posture_rate * error, bound);
    velocity += clamped(wish - velocity, params.acceleration * dt / arm);
  };
  slew(lane.vertical, goal.height, params.height_speed, 1.0);
  slew(lane.roll, goal.roll, params.tilt_speed, params.outer_radius);
  slew(lane.pitch, goal.pitch, params.tilt_speed, params.outer_radius);
}

}  // namespace hexagait
