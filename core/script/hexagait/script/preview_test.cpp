// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/script/preview.hpp>
#include <testing/action_words.hpp>
#include <testing/argos.hpp>

namespace hexagait::preview_test {
namespace {

using testing::argos;
using testing::base_target;
using testing::foot_target;
using testing::footstep;
using ::testing::HasSubstr;
using testing::step;
using testing::steps;
using testing::wait;

Vector3 foot(LegId leg) {
  Vector3 p = argos().legs[leg].p_BC;
  p.z() = argos().foot_radius;
  return p;
}
Pose base() {
  return {Matrix3::Identity(), {0, 0, argos().foot_radius - argos().legs[0].p_BC.z()}};
}

Preview play(const action::Action& action, const PreviewParams& params = {}) {
  return preview(argos(), nominal_joints(argos()), action, params);
}

int count(const Preview& preview, Finding::Kind kind) {
  int n = 0;
  for (const Finding& finding : preview.findings) n += finding.kind == kind;
  return n;
}

// 0.49 s of a footstep and its load transfer, some to find the ground and to be sure of it; 0.2 s.
TEST(Preview, TellsHowLongAnActionTakesAndHowNarrowItGets) {
  int ticks = 0;
  const Preview result =
      preview(argos(), nominal_joints(argos()),
              steps({step({{footstep(0, foot(0) + Vector3(0.05, 0, 0)), {}}}), wait(0.2)}), {},
              [&ticks](const ActionRecord&) { ++ticks; });
  EXPECT_EQ(result.result.outcome, Outcome::succeeded);
  EXPECT_TRUE(result.findings.empty());
  EXPECT_NEAR(result.seconds, 0.72, 0.03);
  EXPECT_NEAR(result.seconds, 0.002 * ticks, 1e-9);
  EXPECT_GT(result.least_margin, 0.05);
  EXPECT_LT(result.least_margin, 0.3);
  EXPECT_EQ(result.least_margin_step, 1);
}

// The foot is to go 3 m outwards; a leg of 0.74 m that stands 0.36 m out reaches some 0.38 m of it.
TEST(Preview, FindsAFootOutOfReachAndSaysWhereAndByHowMuch) {
  action::Step bad = step({{footstep(2, foot(2) + Vector3(0, 3, 0)), {}}});
  bad.legs[0].mark = {12, 5};
  const Preview result = play(steps({wait(0.1), bad}));
  ASSERT_GE(count(result, Finding::Kind::out_of_reach), 1);
  const Finding& finding = result.findings.front();
  EXPECT_TRUE(finding.is_error);
  EXPECT_EQ(finding.step, 2);
  EXPECT_THAT(in_words(finding, "walk.yaml"), HasSubstr("walk.yaml:12:5: error: step 2, LM"));
  EXPECT_THAT(finding.text, ::testing::ContainsRegex("2[56][0-9][0-9].* mm beyond where the leg"));
}

TEST(Preview, FindsAJointBeyondItsLimit) {
  action::JointTarget target;
  target.leg = 1;
  target.ignore_contact = true;
  target.target.q = nominal_joints(argos())[1];
  target.target.q[0] = argos().legs[1].limits[0].upper + 0.3;
  EXPECT_GE(count(play(steps({step({{target, {}}})})), Finding::Kind::out_of_reach), 1);
}

// All of the left side in the air; the steps after it are looked at all the same.
TEST(Preview, FindsAStepThatTipsTheRobotAndGoesOn) {
  const Vector3 up(0, 0, 0.05);
  const Preview result = play(steps({step({{foot_target(0, foot(0) + up), {}},
                                           {foot_target(2, foot(2) + up), {}},
                                           {foot_target(4, foot(4) + up), {}}}),
                                     step({{footstep(1, foot(1) + Vector3(5, 0, 0)), {}}})}));
  EXPECT_GE(count(result, Finding::Kind::unstable), 1);
  EXPECT_GE(count(result, Finding::Kind::out_of_reach), 1);
  EXPECT_LT(result.least_margin, 0.0);
}

// The base over the edge of its own feet, by a target: nothing refuses that, the preview says so.
TEST(Preview, FindsACentreOfMassThatLeavesTheFeet) {
  Pose X = base();
  X.p.y() += 0.25;
  const Vector3 up(0, 0, 0.05);
  const Preview result =
      play(steps({step({{foot_target(2, foot(2) + up), {}}}),
                  step({{foot_target(0, foot(0) + up), {}}}), step(base_target(X))}));
  EXPECT_GE(count(result, Finding::Kind::unstable) + count(result, Finding::Kind::narrow), 1);
}

TEST(Preview, WarnsOfWhatIsTooFast) {
  action::EndEffectorTarget fast = foot_target(0, foot(0) + Vector3(0.05, 0.1, 0.1));
  fast.average_velocity = 100.0;
  const Preview result = play(steps({step({{fast, {}}})}));
  ASSERT_EQ(count(result, Finding::Kind::too_fast), 1);
  EXPECT_FALSE(result.findings[0].is_error);
}

// Made in C++: the loader reads no such number. A robot would refuse it, and so does the preview.
TEST(Preview, EndsAtANumberThatIsNone) {
  const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  const Preview found = play(steps({wait(0.1), step({{footstep(1, nowhere), {}}}), wait(0.1)}));
  EXPECT_EQ(found.result.cause, Cause::not_finite);
  ASSERT_EQ(found.findings.size(), 1U);
  EXPECT_EQ(found.findings[0].kind, Finding::Kind::not_finite);
  EXPECT_THAT(found.findings[0].text, ::testing::StartsWith("step 2, RF: a number is not finite"));
}

TEST(Preview, EndsAlsoWithoutAResult) {
  PreviewParams params;
  params.most_seconds = 1.0;
  EXPECT_EQ(count(play(steps({wait(50.0)}), params), Finding::Kind::no_result), 1);
}

TEST(NominalJoints, PutTheFeetAtTheirWorkspaceCentres) {
  const LegArray<LegJoints> q = nominal_joints(argos());
  for (LegId i = 0; i < 6; ++i)
    EXPECT_LT((foot_position(argos().legs[i], q[i]) - argos().legs[i].p_BC).norm(), 1e-9);
}

}  // namespace
}  // namespace hexagait::preview_test
