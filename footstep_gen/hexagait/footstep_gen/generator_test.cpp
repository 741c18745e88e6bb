// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <hexagait/footstep_gen/generator.hpp>
#include <limits>
#include <numbers>
#include <testing/standing_robot.hpp>

namespace hexagait::footstep_gen {
namespace {

using heading_control::Heading;
using heading_control::PathArc;
using testing::Offsets;
using testing::round_step;
using testing::shift_of_all;
using testing::shifted;
using testing::StandingRobot;

// Straight on, a foot 5 cm behind its centre lags by 5 cm of path; one 5 cm ahead by −5 cm. A leg
// is urgent from 80 % of its radius on, 0.8 · 0.22 = 0.176 m, behind only.
TEST(GaitInput, SaysHowFarFeetLagAndWhichOnesMustGo) {
  Offsets offset = shift_of_all(Vector3::Zero());
  offset[0].x() = -0.05, offset[1].x() = 0.05, offset[2].x() = -0.170, offset[3].x() = -0.181;
  offset[4].x() = 0.19;
  StandingRobot stance(offset);
  stance.lift({5});
  const auto input = gait_input(stance.arc(Heading::straight(0.0)), stance.executor, {});
  for (LegId i = 0; i < 6; ++i)
    EXPECT_NEAR(input.lag[i], -offset[static_cast<std::size_t>(i)].x(), 1e-12);
  EXPECT_EQ(input.urgent, LegSet(0b001000));
  EXPECT_EQ(input.airborne, LegSet(0b100000)) << "from the command to lift on";
  const auto back =
      gait_input(stance.arc(Heading::straight(std::numbers::pi)), stance.executor, {});
  EXPECT_EQ(back.urgent, LegSet(0b010000));
}

// [PC04] 3 straight on, all feet at their centres: nothing to come while they stand. With a tripod
// in the air bound for its AEP, h ahead, Σ lag = −3 h over 3 support legs: the body advances by h.
TEST(PathToCome, IsTheAdvanceThatTheFeetInTheAirWillAskFor) {
  StandingRobot stance;
  const PathArc arc = stance.arc(Heading::straight(0.3));
  EXPECT_NEAR(path_to_come(arc, stance.executor, 0.1), 0.0, 1e-12);
  stance.lift({0, 3, 4});
  EXPECT_NEAR(path_to_come(arc, stance.executor, 0.1), 0.1, 1e-12);
  EXPECT_NEAR(path_to_come(arc, stance.executor, 0.0), 0.0, 1e-12) << "stopped";
}

// One leg in the air, five behind by b: Σ lag = 5 b − h, over 5: never backwards.
TEST(PathToCome, IsNeverNegative) {
  StandingRobot stance = shifted({-0.05, 0.0, 0.0});
  stance.lift({2});
  const PathArc arc = stance.arc(Heading::straight(0.0));
  EXPECT_EQ(path_to_come(arc, stance.executor, 0.1), 0.0);
  StandingRobot ahead = shifted({0.05, 0.0, 0.0});
  ahead.lift({2});
  EXPECT_NEAR(path_to_come(arc, ahead.executor, 0.1), (0.25 + 0.1) / 5.0, 1e-12);
}

// AEP = M(s) c, s the half step and what is still to come, in odom; the height is that of the last
// footprint. Half a step is no more than half of the leg's radius.
TEST(FootstepOf, IsTheAnteriorExtremePositionTakenAlong) {
  StandingRobot stance;
  stance.state.print_O[1].z() = 0.07;
  for (const Heading& heading : {Heading::straight(0.5), Heading::arc(0.9, -0.4),
                                 Heading::spin(heading_control::Turn::cw)}) {
    const PathArc arc = stance.arc(heading);
    const FootstepCommand step =
        footstep(stance.robot, nominal_stance(stance.robot), arc, stance.state, 1, 0.1, 0.03, {});
    const PlanarPose M = exponential(arc.per_metre, 0.13);
    const Vector3& c = stance.robot.legs[1].p_BC;
    const Vector2 aep = M * Vector2(c.head<2>());
    const Vector3 expected = stance.state.X_OB * Vector3(aep.x(), aep.y(), c.z());
    EXPECT_EQ(step.leg, 1);
    EXPECT_LT((step.p_OT - expected).head<2>().norm(), 1e-12);
    EXPECT_EQ(step.p_OT.z(), 0.07);
  }
  const PathArc arc = stance.arc(Heading::straight(0.0));
  const FootstepCommand longest =
      footstep(stance.robot, nominal_stance(stance.robot), arc, stance.state, 1, 9.0, 0.0, {});
  const Vector3 centre = stance.state.X_OB * stance.robot.legs[1].p_BC;
  EXPECT_NEAR((longest.p_OT - centre).head<2>().norm(), 0.5 * stance.robot.legs[1].workspace_radius,
              1e-12);
}

// (step 10) With a workspace of 0.3 m and half a step of 0.1, 0.2 m of the advance to come are inside.
TEST(ComingDown, CountsOnTheAdvanceInsideTheWorkspaceAndAShareOfTheRest) {
  const Stance stance{LegArray<Vector3>(6, Vector3::Zero()), LegArray<double>(6, 0.3)};
  const auto to_come = [&stance](double half_step, double asked, double overreach) {
    StepParams params;
    params.overreach = overreach;
    return to_come_coming_down(stance, 1, half_step, asked, params);
  };
  for (const double overreach : {0.0, 0.4, 1.0}) EXPECT_EQ(to_come(0.1, 0.15, overreach), 0.15);
  EXPECT_NEAR(to_come(0.1, 0.25, 0.0), 0.2, 1e-12);
  EXPECT_NEAR(to_come(0.1, 0.25, 0.4), 0.22, 1e-12);
  EXPECT_EQ(to_come(0.1, 0.25, 1.0), 0.25);
  EXPECT_NEAR(to_come(9.0, 0.25, 0.0), 0.15, 1e-12) << "half a step is half the radius at most";
}

// Clearance 10 cm on the flat, also for the leg that stands highest; 0.7 more per metre by which
// the highest footprint is above its own: 0.1 + 0.7 · 0.08 = 0.156; at most 0.22.
TEST(FootstepOf, GoesHigherWhereAnotherFootStandsHigher) {
  StandingRobot stance;
  const StepParams params{.height = 0.1, .roughness_gain = 0.7, .max_height = 0.22};
  const auto clearance = [&](LegId leg) {
    const PathArc arc = stance.arc(Heading::straight(0.0));
    return footstep(stance.robot, nominal_stance(stance.robot), arc, stance.state, leg, 0.1, 0.0,
                    params)
        .profile_height;
  };
  EXPECT_NEAR(clearance(2), 0.1, 1e-12);
  const double ground = stance.state.print_O[2].z();
  stance.state.print_O[5].z() = ground + 0.08;
  EXPECT_NEAR(clearance(2), 0.156, 1e-12);
  EXPECT_NEAR(clearance(5), 0.1, 1e-12);
  stance.state.print_O[5].z() = ground + 0.5;
  EXPECT_NEAR(clearance(2), 0.22, 1e-12);
}

TEST(FootstepOf, IsTheWorkspaceCentreWhenStopped) {
  StandingRobot stance;
  const PathArc arc = stance.arc(Heading::straight(0.5).stopped());
  const FootstepCommand step =
      footstep(stance.robot, nominal_stance(stance.robot), arc, stance.state, 2, 0.0, 0.0, {});
  EXPECT_LT((step.p_OT - stance.state.X_OB * stance.robot.legs[2].p_BC).head<2>().norm(), 1e-12);
}

// Mirrored: the turn's sign, y of feet and footholds.
TEST(FootstepOf, MirrorsLeftAndRight) {
  StandingRobot stance;
  const PathArc left = stance.arc(Heading::arc(0.8, 0.3)),
                right = stance.arc(Heading::arc(-0.8, -0.3));
  stance.state.X_OB = Pose{};
  for (LegId i = 0; i < 6; i += 2) {
    const Vector3 a =
        footstep(stance.robot, nominal_stance(stance.robot), left, stance.state, i, 0.1, 0.02, {})
            .p_OT;
    const Vector3 b = footstep(stance.robot, nominal_stance(stance.robot), right, stance.state,
                               i + 1, 0.1, 0.02, {})
                          .p_OT;
    EXPECT_LT((a - Vector3(b.x(), -b.y(), b.z())).head<2>().norm(), 1e-12);
  }
}
}  // namespace
}  // namespace hexagait::footstep_gen
