// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/path_following/pursuit.hpp>

namespace hexagait::path_following {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr double kLookAhead = 1.25;  // of the stroke
constexpr double kAtStart = 0.25;    // of the look-ahead
constexpr double kLeastWay = 0.5;    // of the look-ahead, for turns

// The goal, the direction of the path there and where the robot is, and where to face there.
struct Goal {
  Vector2 p_P;
  double direction, direction_here, facing;
};

// Just before a place, where a corner may be.
double before(double s, const PathTask& task) { return s - 1e-6 * task.look_ahead; }

Goal goal_of(const PathProgress& progress, const PathTask& task, const PlanarPose& X_PB) {
  if (!progress.on_path) {
    const double direct = angle_of(task.path.at(0.0) - X_PB.shift);
    return {task.path.at(0.0), direct, direct, facing_at(task, 0.0)};
  }
  const double end = task.end(), ahead = progress.s + task.look_ahead;
  const double direction_here = task.path.direction(std::min(progress.s, before(end, task)));
  if (ahead < end)
    return {task.path.at(ahead), task.path.direction(ahead), direction_here,
            facing_at(task, ahead)};
  // Beyond the end it would go on straight, also of a closed path.
  const double direction = task.path.direction(before(end, task));
  return {task.path.at(before(end, task)) + (ahead - end) * unit_vector(direction), direction,
          direction_here, facing_at(task, before(end, task))};
}

// (path 2), (path 3)
Heading by_crabbing(const Goal& goal, const PlanarPose& X_PB, double look_ahead) {
  const Vector2 chord = goal.p_P - X_PB.shift;
  const double off = wrap_angle(angle_of(chord) - goal.direction);
  const double most =
      std::max(0.5 * std::numbers::pi, std::abs(wrap_angle(goal.direction_here - goal.direction)));
  const double setting_off =
      goal.direction + (std::abs(off) > most ? off : std::clamp(2.0 * off, -most, most));

  // Of a circle through both, as long as its chord times bend / sin(bend).
  const double bend = std::abs(wrap_angle(setting_off - goal.direction - off));
  const double arc = bend > 1e-3 ? bend / portable::sin(bend) : 1.0;
  const double way = std::max(chord.norm() * arc, kLeastWay * look_ahead);
  return Heading::along(unit_vector(setting_off - X_PB.angle),
                        wrap_angle(goal.facing - X_PB.angle) / way);
}

// Coulter 1992.
Heading as_a_car(const Goal& goal, const PlanarPose& X_PB) {
  const Vector2 g = X_PB.inverse() * goal.p_P;
  if (!(g.x() > 0.0)) return Heading::spin(g.y() < 0.0 ? Turn::cw : Turn::ccw);
  return Heading::along({1.0, 0.0}, 2.0 * g.y() / g.squaredNorm());
}

}  // namespace

double look_ahead_for(const StepParams& step) noexcept { return kLookAhead * step.stroke; }

double facing_at(const PathTask& task, double s) noexcept {
  switch (task.facing.kind) {
    case Facing::fixed:
      return wrap_angle(task.facing.angle);
    case Facing::points:
      return task.path.facing(s);
    case Facing::along:
    case Facing::car:
      break;
  }
  return wrap_angle(task.path.direction(s) + task.facing.angle);
}

Pursuit pursue(const PathProgress& before, const PathTask& task, const PlanarPose& X_PB,
               double coast) noexcept {
  Pursuit now{{before.heading.stopped(), 0.0}, before, X_PB.shift};
  if (!std::isfinite(X_PB.angle) || !X_PB.shift.allFinite() || before.arrived) return now;
  PathProgress& progress = now.progress;
  const double L = task.look_ahead, end = task.end();
  progress.on_path |= (task.path.at(0.0) - X_PB.shift).norm() <= kAtStart * L;
  if (progress.on_path)
    progress.s = task.path.nearest(X_PB.shift, progress.s, std::min(end, progress.s + L));
  progress.arrived = progress.on_path && end - progress.s <= std::max(0.0, coast);

  const Goal goal = goal_of(progress, task, X_PB);
  const Heading heading =
      task.facing.kind == Facing::car ? as_a_car(goal, X_PB) : by_crabbing(goal, X_PB, L);
  progress.heading = progress.arrived ? heading.stopped() : heading;
  now.goal_P = goal.p_P;
  now.command = {progress.heading, progress.arrived ? 0.0 : task.path.speed(progress.s)};
  return now;
}

}  // namespace hexagait::path_following
