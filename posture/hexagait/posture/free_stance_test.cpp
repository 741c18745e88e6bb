// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/posture/free_stance.hpp>
#include <hexagait/script/action_runner.hpp>
#include <hexagait/script/preview.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/argos.hpp>

namespace hexagait::posture {
namespace {

using hexagait::testing::argos;

/// The nominal stance at a height, under a base at X_OB.
StanceProblem nominal(const Pose& X_OB, double height) {
  StanceProblem problem;
  problem.p_OF = LegArray<Vector3>(6, Vector3::Zero());
  for (LegId i = 0; i < 6; ++i) {
    const Vector3& p_BC = argos().legs[i].p_BC;
    problem.p_OF[i] = X_OB * Vector3(p_BC.x(), p_BC.y(), -height);
  }
  problem.reach = problem.support = LegSet::all(6);
  problem.height = height;
  return problem;
}

double sum_of_squares(const StanceProblem& problem, const Pose& X_OB) {
  double sum = 0.0;
  for (LegId i = 0; i < 6; ++i) {
    const Vector3& c = argos().legs[i].p_BC;
    sum +=
        (X_OB.inverse() * problem.p_OF[i] - Vector3(c.x(), c.y(), -problem.height)).squaredNorm();
  }
  return sum;
}

// Feet in the nominal stance of some pose: that pose, from wherever the base is.
TEST(FreeStance, IsTheBaseUnderWhichTheFeetAreNominal) {
  RandomSequence random{.seed = 1};
  const auto draw = [&](double width) { return random.uniform(-width, width); };
  for (int trial = 0; trial < 200; ++trial) {
    const Pose X_OB{rotation({draw(0.2), draw(0.2), draw(1.5)}), {draw(1), draw(1), draw(1)}};
    StanceProblem problem = nominal(X_OB, random.uniform(0.25, 0.35));
    problem.X_OB = {rotation({draw(0.2), draw(0.2), draw(1.5)}), {draw(1), draw(1), draw(1)}};
    const StancePose stance = free_stance(argos(), problem);
    ASSERT_LT((stance.X_OB.p - X_OB.p).norm() + (stance.X_OB.R - X_OB.R).norm(), 1e-9) << trial;
    ASSERT_TRUE(stance.reachable());
  }
}

// Any small motion of the base makes the sum of squares larger.
TEST(FreeStance, IsAMinimumForScatteredFeet) {
  RandomSequence random{.seed = 2};
  const auto draw = [&](double width) { return random.uniform(-width, width); };
  for (int trial = 0; trial < 100; ++trial) {
    StanceProblem problem = nominal({}, 0.3);
    for (Vector3& p : problem.p_OF) p += Vector3(draw(0.1), draw(0.1), draw(0.05));
    const StancePose stance = free_stance(argos(), problem);
    ASSERT_NEAR(stance.objective, sum_of_squares(problem, stance.X_OB), 1e-12);
    const Pose nudge{rotation({draw(0.01), draw(0.01), draw(0.01)}),
                     {draw(0.01), draw(0.01), draw(0.01)}};
    ASSERT_GT(sum_of_squares(problem, stance.X_OB * nudge), stance.objective) << trial;
  }
}

// The front legs gone, the rear ones carry a centre of mass outside their rectangle: it says so.
TEST(FreeStance, ReportsAMarginThatItDoesNotKeep) {
  StanceProblem problem = nominal({}, 0.3);
  problem.support = LegSet(0b111100);
  problem.margin = 0.04;
  const StancePose stance = free_stance(argos(), problem);
  EXPECT_TRUE(stance.margin_shrunk);
  EXPECT_LT(stance.margin, 0.04);
}

// A script's BaseAuto by this strategy: back to where the feet are nominal, 3 cm back and 2 up.
TEST(FreeStance, LeadsTheBaseOfAScript) {
  action::Action action;
  action.steps.resize(1);
  action.steps[0].base = action::BaseCommand{action::BaseAuto{.height = 0.30}, {}};
  LegArray<LegJoints> q(6);
  for (LegId i = 0; i < 6; ++i)
    q[i] = inverse_kinematics(argos().legs[i], argos().legs[i].p_BC + Vector3(-0.03, 0.0, 0.02)).q;
  PreviewParams params;
  params.runner.sequencer.planner.stance = free_stance;
  Pose X_OB;
  const Preview played = preview(argos(), q, action, params,
                                 [&](const ActionRecord& record) { X_OB = record.state.X_OB; });
  EXPECT_EQ(played.result.outcome, Outcome::succeeded);
  EXPECT_NEAR(X_OB.p.x(), -0.03, 1e-3);
  EXPECT_NEAR(X_OB.p.z(), 0.30 + argos().foot_radius, 1e-3);
}

}  // namespace
}  // namespace hexagait::posture
