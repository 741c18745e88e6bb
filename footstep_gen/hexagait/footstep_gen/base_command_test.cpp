// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/generator.hpp>
#include <limits>
#include <numbers>
#include <testing/standing_robot.hpp>

namespace hexagait::footstep_gen {
namespace {

using heading_control::Heading;
using heading_control::PathArc;
using testing::round_step;
using testing::shifted;
using testing::StandingRobot;

// Straight on, feet b behind their centres: the chord of the usable disc, 0.98 · 0.22 m, from
// there.
TEST(BaseCommand, KeepsSupportLegsWithinTheirWorkspaces) {
  for (const Vector3& offset :
       {Vector3(0.0, 0.0, 0.0), Vector3(-0.1, 0.05, 0.0), Vector3(0.12, -0.09, 0.0)}) {
    StandingRobot stance = shifted(offset);
    const BaseAutoCommand base =
        base_auto(stance.robot, stance.arc(Heading::straight(0.0)), stance.executor,
                  stance.state.X_OB, {}, {.stability_margin = 0.0});
    const double usable = 0.98 * stance.robot.legs[0].workspace_radius;
    const double chord = offset.x() + std::sqrt(usable * usable - offset.y() * offset.y());
    EXPECT_NEAR(base.max_advance, chord, 1e-12);
  }
}

// Front and middle legs on the ground, rear legs in the air: the centre of mass at the middle legs'
// x = 0 is on the rear edge. Going ahead is limited by the workspaces, back by the edge.
TEST(BaseCommand, KeepsTheCentreOfMassWithinTheFeet) {
  StandingRobot stance;
  stance.lift({4, 5});
  const auto limit = [&](double alpha, double margin) {
    return base_auto(stance.robot, stance.arc(Heading::straight(alpha)), stance.executor,
                     stance.state.X_OB, {}, {.stability_margin = margin})
        .max_advance;
  };
  EXPECT_NEAR(limit(std::numbers::pi, 0.0), 0.0, 1e-9);
  EXPECT_EQ(limit(std::numbers::pi, 0.03), 0.0) << "not negative";
  EXPECT_NEAR(limit(0.0, 0.03), 0.98 * stance.robot.legs[0].workspace_radius, 1e-9);
}

// What bounds the base on its way back is what bounds it on the way ahead of the reverse heading.
TEST(BaseCommand, BoundsTheWayBackLikeTheWayAhead) {
  RandomSequence random{.seed = 11};
  for (int trial = 0; trial < 200; ++trial) {
    StandingRobot stance =
        shifted(Vector3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0.0));
    if (trial % 3 != 0)
      stance.lift(trial % 3 == 1 ? std::initializer_list<LegId>{0, 3, 4}
                                 : std::initializer_list<LegId>{4});
    const double alpha = random.uniform(-std::numbers::pi, std::numbers::pi);
    const auto command = [&](double along) {
      return base_auto(stance.robot, stance.arc(Heading::straight(along)), stance.executor,
                       stance.state.X_OB, {}, {});
    };
    const BaseAutoCommand there = command(alpha), reverse = command(alpha + std::numbers::pi);
    EXPECT_NEAR(-there.min_advance, reverse.max_advance, 1e-9) << trial;
    EXPECT_NEAR(-reverse.min_advance, there.max_advance, 1e-9) << trial;
  }
}

// Where only the polygon limits: the front edge is at the front feet's x = 0.35, the centre of mass
// at 0 stops 0.25 m before it. (Half a metre of margin would leave nothing.)
TEST(BaseCommand, KeepsItsMarginFromTheEdgeAhead) {
  StandingRobot stance;
  const double x_front = stance.robot.legs[0].p_BC.x();
  const BaseAutoCommand base =
      base_auto(stance.robot, stance.arc(Heading::straight(0.0)), stance.executor,
                stance.state.X_OB, {}, {.stability_margin = x_front - 0.1});
  EXPECT_NEAR(base.max_advance, 0.1, 1e-9);
}

TEST(BaseCommand, KeepsMoreMarginWhereItIsAskedFor) {
  StandingRobot stance;
  const double x_front = stance.robot.legs[0].p_BC.x();
  const auto left = [&](double margin) {
    return base_auto(stance.robot, stance.arc(Heading::straight(0.0)), stance.executor,
                     stance.state.X_OB, {}, {.stability_margin = x_front - 0.15}, margin)
        .max_advance;
  };
  EXPECT_NEAR(left(x_front - 0.1), 0.1, 1e-9);
  EXPECT_NEAR(left(0.0), 0.15, 1e-9);
  stance.executor.set_centre_of_mass(stance.robot.p_BM + Vector3(0.02, 0.0, 0.0));
  EXPECT_NEAR(left(x_front - 0.1), 0.08, 1e-9) << "as it is in this posture";
}

// With two feet, diagonal ones, the base may pass the line between them by its margin; with one, it
// waits, whatever margin is asked for where it has an inside.
TEST(BaseCommand, DoesNotDriveOnOverTwoFeetOrOne) {
  StandingRobot stance;
  stance.lift({1, 2, 3, 4});  // front left and rear right stand: the line passes the middle
  const auto left = [&](double alpha) {
    return base_auto(stance.robot, stance.arc(Heading::straight(alpha)), stance.executor,
                     stance.state.X_OB, {}, {.stability_margin = 0.03}, 0.09)
        .max_advance;
  };
  const Vector2 line = (stance.robot.legs[0].p_BC - stance.robot.legs[5].p_BC).head<2>();
  const double across = std::abs(cross(line.normalized(), Vector2::UnitX()));
  EXPECT_NEAR(left(0.0), 0.03 / across, 1e-9);
  EXPECT_NEAR(left(std::numbers::pi), 0.03 / across, 1e-9);
  stance.lift({5});
  EXPECT_EQ(left(0.0), 0.0);
}

// The centre of mass is 0.32 m above the feet: tilted by 12° it is 6.8 cm from where it is over the
// level stance, and that much nearer to the edge downhill.
TEST(BaseCommand, SeesTheFeetAlongGravity) {
  StandingRobot stance;
  stance.robot.p_BM = {0.0, 0.0, 0.0};
  const double height = -stance.robot.legs[0].p_BC.z();
  const double x_front = stance.robot.legs[0].p_BC.x(), margin = x_front - 0.1;
  for (const double pitch : {0.0, 0.1, 0.2}) {
    const Pose X_OB{rotation(Vector3(0.0, pitch, 0.0)), {0.0, 0.0, 0.3}};  // the front is low
    const BaseAutoCommand base = base_auto(stance.robot, stance.arc(Heading::straight(0.0)),
                                           stance.executor, X_OB, {}, {.stability_margin = margin});
    // To the front edge, seen from above; the path, too, is seen so.
    const double edge = x_front * std::cos(pitch) - height * std::sin(pitch);
    EXPECT_NEAR(base.max_advance, (edge - margin) / std::cos(pitch), 1e-9) << pitch;
  }
}

// The body 5 cm behind the rear edge: back it goes, with all of it, to 3 cm inside. At the edge no
// correction takes it farther out, but along the edge and inwards it may go.
TEST(BaseCommand, BringsACentreOfMassFromOutsideBackOverTheFeet) {
  StandingRobot stance;
  stance.lift({4, 5});
  stance.robot.p_BM = {-0.05, 0.0, 0.0};
  const auto corrected = [&](const Vector2& deviation) {
    return base_auto(stance.robot, stance.arc(Heading::straight(0.0)), stance.executor,
                     stance.state.X_OB, {deviation, 0.0}, round_step())
        .correction.v;
  };
  EXPECT_LT((corrected({0.0, 0.0}) - Vector2(0.08, 0.0)).norm(), 1e-9);
  EXPECT_LT((corrected({-0.02, 0.01}) - Vector2(0.08, 0.01)).norm(), 1e-9);
  EXPECT_LT((corrected({0.02, 0.01}) - Vector2(0.10, 0.01)).norm(), 1e-9);
}

// 1 cm inside the rear edge it is moved by 2 cm, and with the margin or more, not at all.
TEST(BaseCommand, GivesALostMarginBack) {
  StandingRobot stance;
  stance.lift({4, 5});
  for (const double inside : {0.01, 0.03, 0.05}) {
    stance.robot.p_BM = {inside, 0.0, 0.0};
    const Vector2 back =
        base_auto(stance.robot, stance.arc(Heading::straight(std::numbers::pi / 2.0)),
                  stance.executor, stance.state.X_OB, {}, round_step())
            .correction.v;
    EXPECT_LT((back - Vector2(std::max(0.0, 0.03 - inside), 0.0)).norm(), 1e-9) << inside;
  }
}

// (base 3) From an edge on, and less far the nearer to it.
TEST(BaseCommand, LowersTheBodyTowardsAFootOnlyAsTheCentreOfMassIsInside) {
  StandingRobot stance;
  stance.lift({4, 5});
  for (const double inside : {-0.01, 0.0, 0.03, 0.06, 0.1}) {
    stance.robot.p_BM = {inside, 0.0, 0.0};
    const double share = base_auto(stance.robot, stance.arc(Heading::straight(0.0)),
                                   stance.executor, stance.state.X_OB, {}, round_step())
                             .lowering;
    EXPECT_NEAR(share, std::clamp(inside / 0.06, 0.0, 1.0), 1e-9) << inside;
  }
}

// 5 cm inside the rear edge, and 9 cm are asked for: ahead by 4 cm, or as far as no standing foot leaves its workspace.
TEST(BaseCommand, IsMovedFartherInOnlyAsLegsReach) {
  const double usable = 0.98 * StandingRobot().robot.legs[0].workspace_radius;
  for (const double room : {0.0, 0.01, 0.10}) {
    StandingRobot stance = shifted({room - usable, 0.0, 0.0});
    stance.lift({4, 5});
    const double rear_edge = stance.robot.legs[2].p_BC.x() + room - usable;
    stance.robot.p_BM = {rear_edge + 0.05, 0.0, 0.0};
    const Vector2 way = base_auto(stance.robot, stance.arc(Heading::straight(0.0)), stance.executor,
                                  stance.state.X_OB, {}, round_step(), 0.09)
                            .correction.v;
    EXPECT_LT((way - Vector2(std::min(room, 0.04), 0.0)).norm(), 1e-9) << room;
  }
}

// The zero-moment point may go to 1.5 times `stability_margin` from the front edge, and no farther: from the centre of
// mass at 0 by 0.35 − 0.045 m. It is ahead by height × deceleration / g.
TEST(BaseCommand, BrakesAsHardAsTheSupportPolygonAllows) {
  StandingRobot stance;
  stance.robot.p_BM = {0.0, 0.0, 0.0};
  stance.executor = Executor(stance.robot, hexagait::testing::round_executor());
  stance.executor.reset(stance.state);
  const auto braking = [&] {
    return base_auto(stance.robot, stance.arc(Heading::straight(std::numbers::pi / 2.0)),
                     stance.executor, stance.state.X_OB, {},
                     {.stability_margin = 0.03, .lift_margin = 0.06})
        .max_braking;
  };
  EXPECT_EQ(braking(), 0.0) << "at rest";
  const auto walk_on = [&](const Heading& heading) {
    for (int tick = 0; tick < 100; ++tick) {
      stance.executor.command(base_auto(stance.robot, stance.arc(heading), stance.executor,
                                        stance.state.X_OB, {{0.3, 0.0}, 0.0}, round_step()));
      (void)stance.executor.advance(stance.state, 0.002);
    }
  };
  walk_on(Heading::stop());  // a correction, straight ahead
  ASSERT_GT(stance.executor.base().planar.v.x(), 0.01);
  const double x_front = stance.executor.legs()[0].p_BF.x();
  const double height = -stance.executor.legs()[0].p_BF.z();
  EXPECT_NEAR(braking(), 9.81 * (x_front - 0.045) / height, 1e-6);
}

TEST(BaseCommand, WaitsWhileAFootholdGivesWay) {
  StandingRobot stance;
  stance.state.slide_O = LegArray<Vector3>(6, Vector3::Zero());
  const auto ahead = [&] {  // as far as foot 1 lets it
    stance.executor.sense(stance.state, 0.002);
    return base_auto(stance.robot, stance.arc(Heading::straight(0.0)), stance.executor,
                     stance.state.X_OB, {}, round_step())
        .max_advance;
  };
  EXPECT_GT(ahead(), 0.1);
  stance.state.slide_O[1].z() -= 0.003;
  EXPECT_EQ(ahead(), 0.0);
  for (int k = 0; k < 100; ++k) ahead();
  EXPECT_GT(ahead(), 0.1);
}

// The pose adaptation: feet ahead by d ask for an advance by d, feet low by h for a body lower by h
// (the footprints follow the body).
TEST(BaseCommand, AsksForTheBodyToBeOverItsFeet) {
  StandingRobot stance = shifted({0.06, 0.0, -0.02});
  const BaseAutoCommand base =
      base_auto(stance.robot, stance.arc(Heading::straight(0.0)), stance.executor,
                stance.state.X_OB, {{0.01, 0.02}, 0.03}, {});
  const BaseGoal goal = base.adaptation(base, stance.executor.pose_adaptation_input(stance.state));
  EXPECT_NEAR(goal.advance, 0.06, 1e-12);
  EXPECT_NEAR(goal.height, -0.02, 1e-12);
  EXPECT_NEAR(goal.roll, 0.0, 1e-12);
  EXPECT_NEAR(goal.pitch, 0.0, 1e-12);
  EXPECT_EQ(base.correction.w, 0.03);
}

// Of six feet on a plane one has met a wall and is above them: the body rises by half of that.
TEST(BaseCommand, TakesTheBodyOverWhatAFootHasMet) {
  StandingRobot stance;
  const BaseAutoCommand base = base_auto(stance.robot, stance.arc(Heading::straight(0.0)),
                                         stance.executor, stance.state.X_OB, {}, {});
  PoseAdaptationInput in = stance.executor.pose_adaptation_input(stance.state);
  in.p_BF[1].z() += 0.14;
  EXPECT_NEAR(base.adaptation(base, in).height, 0.0, 1e-12) << "a step as any other";
  in.blocked.insert(1);
  EXPECT_NEAR(base.adaptation(base, in).height, 0.07, 1e-12);
}

// Anywhere within the workspaces, on uneven ground, tilted by up to 5°.
void place_at_random(StandingRobot& stance, RandomSequence& random) {
  stance.state.X_OB.R *=
      rotation(Vector3(random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08), 0.0));
  for (LegId i = 0; i < 6; ++i) {
    const LegModel& leg = stance.robot.legs[i];
    const double r = 0.97 * leg.workspace_radius * std::sqrt(random.u01());
    stance.state.p_BF[i] =
        leg.p_BC + rotation_z(random.uniform(-std::numbers::pi, std::numbers::pi)) *
                       Vector3(r, 0.0, random.uniform(-0.08, 0.08));
  }
  stance.place();
}

double margin(const StandingRobot& stance) {
  return stability_margin(support_polygon(stance.state.p_OF, stance.executor.support()),
                          (stance.state.X_OB * stance.robot.p_BM).head<2>());
}

struct Least {
  double margin = std::numeric_limits<double>::infinity();  // [m]
  bool in_reach = true;                                     // each foot that stands
};

// The base moves for 1.5 s as it is told, without slip; its place on the path is `off` away.
Least move_base(StandingRobot& stance, const PathArc& arc, const PlanarTwist& off, double dt) {
  RobotState& state = stance.state;
  const Pose X_OG = state.X_OB * Pose{rotation_z(off.w), {off.v.x(), off.v.y(), 0.0}};
  Least least;
  for (double t = 0.0; t < 1.5; t += dt) {
    const Pose X_BG = state.X_OB.inverse() * X_OG;
    const PlanarTwist deviation{X_BG.p.head<2>(), std::atan2(X_BG.R(1, 0), X_BG.R(0, 0))};
    stance.executor.command(
        base_auto(stance.robot, arc, stance.executor, state.X_OB, deviation, round_step()));
    stance.executor.advance(state, dt);
    const Twist V = stance.executor.base().twist();
    state.X_OB = state.X_OB * Pose{rotation(V.w * dt), dt * V.v + 0.5 * dt * dt * V.w.cross(V.v)};
    for (LegId i = 0; i < 6; ++i) {
      if (!stance.executor.legs()[i].on_ground()) {
        state.p_BF[i] = stance.executor.legs()[i].p_BF;
        continue;
      }
      state.p_BF[i] = state.X_OB.inverse() * state.p_OF[i];
      if (!inverse_kinematics(stance.robot.legs[i], state.p_BF[i]).reachable)
        least.in_reach = false;
    }
    least.margin = std::min(least.margin, margin(stance));
  }
  return least;
}

// Wherever the base is told to go and however it stands, no standing foot goes where its leg does
// not reach, and the margin does not fall below what it is to be: by no more than the way in which
// the base brakes while it turns, 3 mm, and the corrections that are made each period.
TEST(BaseCommand, LeavesStandingFeetInReachAndTheCentreOfMassInside) {
  const LegSet in_the_air[] = {LegSet(), LegSet(0b100110), LegSet(0b000001)};
  for (const double dt : {0.005, 0.02}) {
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
      RandomSequence random{.seed = seed};
      StandingRobot stance;
      place_at_random(stance, random);
      for (LegId i = 0; i < 6; ++i) {
        if (!in_the_air[seed % 3].contains(i)) continue;
        stance.lift({i});
        stance.state.contact[i] = false;
      }
      const PathArc arc = stance.arc(Heading::arc(
          random.uniform(0.3, 3.0), random.uniform(-std::numbers::pi, std::numbers::pi)));
      const PlanarTwist off{{random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15)},
                            random.uniform(-0.2, 0.2)};
      const double to_be = std::min(margin(stance), round_step().stability_margin);
      const Least least = move_base(stance, arc, off, dt);
      EXPECT_TRUE(least.in_reach) << dt << " " << seed;
      EXPECT_GT(least.margin, to_be - 0.003 - 0.1 * dt) << dt << " " << seed;
    }
  }
}
}  // namespace
}  // namespace hexagait::footstep_gen
