// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <testing/poisoned_actions.hpp>
#include <testing/scripted_robot.hpp>

/// What is read must not only look right: a robot can do it.
namespace hexagait::fuzz {

inline bool finite(const JointTargets& targets) {
  bool finite = true;
  for (LegId i = 0; i < targets.q.size(); ++i)
    finite = finite && targets.q[i].allFinite() && targets.qd[i].allFinite() &&
             targets.effort[i].allFinite();
  return finite;
}

/// Targets stay finite, and nobody had to see to that: for some seconds, at the longest period.
inline bool is_played(const action::Action& action, const RobotModel& model, int most_ticks = 200) {
  RunnerParams params;
  params.control_dt = 0.020;
  testing::ScriptedRobot robot(model, params);
  robot.runner.submit(action);
  for (int k = 0; k < most_ticks && !robot.runner.idle(); ++k)
    if (!finite(robot.tick().desired.targets)) return false;
  return robot.record().fault == Fault::none && robot.record().result.cause != Cause::not_finite;
}

/// The largest number of all is that of a position. What is not given is NaN.
inline bool is_bounded(action::Action action) {
  const testing::NumbersOf numbers(action);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (std::abs(numbers[i]) > 1e7) return false;
  return true;
}

}  // namespace hexagait::fuzz
