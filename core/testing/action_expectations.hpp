// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <testing/scripted_robot.hpp>

/// What tests of sequences expect of actions.
namespace hexagait::testing {

inline constexpr double kUnload = 0.04;  // SwingParams::unload_time

inline Vector3 forward(double x) { return {x, 0.0, 0.0}; }

inline void expect_result(const ActionResult& result, Outcome outcome, Cause cause, int step,
                          LegId leg) {
  EXPECT_STREQ(to_string(result.outcome), to_string(outcome));
  EXPECT_STREQ(to_string(result.cause), to_string(cause));
  EXPECT_EQ(result.step, step);
  EXPECT_EQ(result.leg, leg);
}

// After an end, however it came: nothing moves any more.
inline void expect_at_rest(ScriptedRobot& robot) {
  const LegArray<LegJoints> q = robot.record().desired.targets.q;
  robot.run(0.1);
  for (LegId i = 0; i < q.size(); ++i)
    EXPECT_LT((robot.record().desired.targets.q[i] - q[i]).norm(), 1e-6) << "leg " << i;
}

}  // namespace hexagait::testing
