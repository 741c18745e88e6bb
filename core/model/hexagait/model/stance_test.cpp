// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/stance.hpp>
#include <hexagait/model/workspace.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/source_path.hpp>

namespace hexagait::stance_test {
namespace {

RobotModel robot(const std::string& name, const UrdfOptions& options = {}) {
  return load_urdf(testing::source_path("robots/" + name + ".urdf"), options);
}

double outwards(const LegModel& leg) { return (leg.X_BH.inverse() * leg.p_BC).head<2>().norm(); }

// Of every kind of leg: closed form, serial, of two joints.
class AnyStance : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Robots, AnyStance,
                         ::testing::Values("argos", "hexapod_4dof", "quadruped_rpp", "genghis"));

TEST_P(AnyStance, OfItsOwnChangesNothing) {
  const RobotModel model = robot(GetParam());
  const Stance own = nominal_stance(model), asked = stance_at(model, {});
  const RobotModel same = in_stance(model, own);
  for (LegId i = 0; i < model.num_legs(); ++i) {
    EXPECT_LT((asked.p_BC[i] - own.p_BC[i]).norm(), 1e-9);
    EXPECT_EQ(same.legs[i].p_BC, model.legs[i].p_BC);
    EXPECT_EQ(same.legs[i].workspace_radius, model.legs[i].workspace_radius);
  }
  EXPECT_LT((same.p_BM - model.p_BM).norm(), 1e-12);
}

TEST_P(AnyStance, StandsAsHighAsAsked) {
  const RobotModel model = robot(GetParam());
  const double own = model.foot_radius - model.legs[0].p_BC.z(), height = 0.9 * own;
  const RobotModel lower = in_stance(model, stance_at(model, {.height = height}));
  for (const LegModel& leg : lower.legs) {
    EXPECT_NEAR(model.foot_radius - leg.p_BC.z(), height, 1e-9);
    EXPECT_LT((foot_position(leg, inverse_kinematics(leg, leg.p_BC).q) - leg.p_BC).norm(), 1e-9);
    EXPECT_EQ(leg.workspace_radius, reachable_radius(leg));
  }
  // The legs' masses are farther up in the body's frame, the body's own is where it was.
  EXPECT_GT(lower.p_BM.z(), model.p_BM.z());
}

TEST(Stance, SplaysTheFeetOutwardsFromTheirHips) {
  const RobotModel model = robot("argos");
  const RobotModel wide = in_stance(model, stance_at(model, {.splay = 0.04}));
  for (LegId i = 0; i < model.num_legs(); ++i) {
    EXPECT_NEAR(outwards(wide.legs[i]) - outwards(model.legs[i]), 0.04, 1e-12);
    EXPECT_EQ(wide.legs[i].p_BC.z(), model.legs[i].p_BC.z());
  }
}

TEST(Stance, ThatALegCantTakeIsRefusedWithItsPlace) {
  const RobotModel model = robot("argos");
  try {
    (void)stance_at(model, {.height = 2.0});
    FAIL();
  } catch (const InvalidInput& problem) {
    const std::string text = problem.what();
    EXPECT_NE(text.find("leg LF: can't stand and step with its foot"), std::string::npos) << text;
    EXPECT_NE(text.find("leg RR"), std::string::npos) << text;
  }
  EXPECT_THROW((void)stance_at(robot("genghis"), {.splay = 0.01}), InvalidInput);

  Stance stance = nominal_stance(model);
  stance.radius[2] = 0.0;
  EXPECT_THROW(check_stance(model, stance), InvalidInput);
  stance = nominal_stance(model);
  stance.p_BC[1].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check_stance(model, stance), InvalidInput);
  EXPECT_THROW(check_stance(model, {LegArray<Vector3>(4), LegArray<double>(4)}), InvalidInput);
}

TEST(Stance, IsAnOptionOfTheLoader) {
  const RobotModel lower = robot("argos", {.stance = {.height = 0.25, .splay = 0.02}});
  EXPECT_NEAR(lower.foot_radius - lower.legs[3].p_BC.z(), 0.25, 1e-12);
  ASSERT_FALSE(lower.substitutions.empty());
  EXPECT_EQ(lower.substitutions.back().option, "--body-height, --splay");
  EXPECT_EQ(lower.substitutions.back().origin, Origin::given);
}

}  // namespace
}  // namespace hexagait::stance_test
