// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/generator.hpp>
#include <limits>
#include <numbers>
#include <testing/kinematic_plant.hpp>
#include <testing/round_params.hpp>

namespace hexagait::footstep_gen {
namespace {

using heading_control::Heading;
using heading_control::PathArc;

StepParams round_step() { return hexagait::testing::round_params().step; }

/// Of six feet from their workspace centres [m].
using Offsets = std::array<Vector3, 6>;

Offsets shift_of_all(const Vector3& offset) {
  return {offset, offset, offset, offset, offset, offset};
}

/// A six-legged robot whose feet stand at their workspace centres plus what the test says.
struct Stance {
  RobotModel robot = testing::robot_of(6);
  RobotState state;
  Executor executor{robot, hexagait::testing::round_executor()};

  // Not inlined: GCC 12 would warn that unused elements are copied uninitialised.
  [[gnu::noinline]] explicit Stance(const Offsets& offset = shift_of_all(Vector3::Zero())) {
    state.q = LegArray<LegJoints>(6);
    state.p_BF = state.p_OF = state.print_O = LegArray<Vector3>(6);
    state.trig = LegArray<LegTrig>(6);
    state.contact = LegArray<bool>(6, true);
    state.X_OB = {rotation_z(0.6), {2.0, -1.0, 0.32}};
    for (LegId i = 0; i < 6; ++i) {
      state.p_BF[i] = robot.legs[i].p_BC + offset[static_cast<std::size_t>(i)];
    }
    place();
  }

  // The feet where p_BF says.
  void place() {
    for (LegId i = 0; i < 6; ++i) {
      state.q[i] = inverse_kinematics(robot.legs[i], state.p_BF[i]).q;
      state.trig[i] = leg_trig(robot.legs[i], state.q[i]);
      state.print_O[i] = state.p_OF[i] = state.X_OB * state.p_BF[i];
    }
    executor.reset(state);
  }

  PathArc arc(const Heading& heading) const { return path_arc(heading, nominal_stance(robot)); }
  void lift(std::initializer_list<LegId> legs) {
    for (const LegId i : legs) executor.command(FootstepCommand{i, state.p_OF[i]}, state);
  }
};

/// The same offset for all feet.
Stance shifted(const Vector3& offset) { return Stance(shift_of_all(offset)); }

// Straight on, a foot 5 cm behind its centre lags by 5 cm of path; one 5 cm ahead by −5 cm. A leg
// is urgent from 80 % of its radius on, 0.8 · 0.22 = 0.176 m, behind only.
TEST(GaitInput, SaysHowFarFeetLagAndWhichOnesMustGo) {
  Offsets offset = shift_of_all(Vector3::Zero());
  offset[0].x() = -0.05, offset[1].x() = 0.05, offset[2].x() = -0.170, offset[3].x() = -0.181;
  offset[4].x() = 0.19;
  Stance stance(offset);
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
  Stance stance;
  const PathArc arc = stance.arc(Heading::straight(0.3));
  EXPECT_NEAR(path_to_come(arc, stance.executor, 0.1), 0.0, 1e-12);
  stance.lift({0, 3, 4});
  EXPECT_NEAR(path_to_come(arc, stance.executor, 0.1), 0.1, 1e-12);
  EXPECT_NEAR(path_to_come(arc, stance.executor, 0.0), 0.0, 1e-12) << "stopped";
}

// One leg in the air, five behind by b: Σ lag = 5 b − h, over 5: never backwards.
TEST(PathToCome, IsNeverNegative) {
  Stance stance = shifted({-0.05, 0.0, 0.0});
  stance.lift({2});
  const PathArc arc = stance.arc(Heading::straight(0.0));
  EXPECT_EQ(path_to_come(arc, stance.executor, 0.1), 0.0);
  Stance ahead = shifted({0.05, 0.0, 0.0});
  ahead.lift({2});
  EXPECT_NEAR(path_to_come(arc, ahead.executor, 0.1), (0.25 + 0.1) / 5.0, 1e-12);
}

// AEP = M(s) c, s the half step and what is still to come, in odom; the height is that of the last
// footprint. Half a step is no more than half of the leg's radius.
TEST(FootstepOf, IsTheAnteriorExtremePositionTakenAlong) {
  Stance stance;
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

// Clearance 10 cm on the flat, also for the leg that stands highest; 0.7 more per metre by which
// the highest footprint is above its own: 0.1 + 0.7 · 0.08 = 0.156; at most 0.22.
TEST(FootstepOf, GoesHigherWhereAnotherFootStandsHigher) {
  Stance stance;
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
  Stance stance;
  const PathArc arc = stance.arc(Heading::straight(0.5).stopped());
  const FootstepCommand step =
      footstep(stance.robot, nominal_stance(stance.robot), arc, stance.state, 2, 0.0, 0.0, {});
  EXPECT_LT((step.p_OT - stance.state.X_OB * stance.robot.legs[2].p_BC).head<2>().norm(), 1e-12);
}

// Straight on, feet b behind their centres: the chord of the usable disc, 0.98 · 0.22 m, from
// there.
TEST(BaseCommand, KeepsSupportLegsWithinTheirWorkspaces) {
  for (const Vector3& offset :
       {Vector3(0.0, 0.0, 0.0), Vector3(-0.1, 0.05, 0.0), Vector3(0.12, -0.09, 0.0)}) {
    Stance stance = shifted(offset);
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
  Stance stance;
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
    Stance stance = shifted(Vector3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0.0));
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
  Stance stance;
  const double x_front = stance.robot.legs[0].p_BC.x();
  const BaseAutoCommand base =
      base_auto(stance.robot, stance.arc(Heading::straight(0.0)), stance.executor,
                stance.state.X_OB, {}, {.stability_margin = x_front - 0.1});
  EXPECT_NEAR(base.max_advance, 0.1, 1e-9);
}

// With two feet, diagonal ones, the base may pass the line between them by the margin; with one, it
// waits.
TEST(BaseCommand, DoesNotDriveOnOverTwoFeetOrOne) {
  Stance stance;
  stance.lift({1, 2, 3, 4});  // front left and rear right stand: the line passes the middle
  const auto left = [&](double alpha) {
    return base_auto(stance.robot, stance.arc(Heading::straight(alpha)), stance.executor,
                     stance.state.X_OB, {}, {.stability_margin = 0.03})
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
  Stance stance;
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
  Stance stance;
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
  Stance stance;
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

// The zero-moment point may go to `lift_margin` from the front edge, and no farther: from the centre of
// mass at 0 by 0.35 − 0.06 m. It is ahead by height × deceleration / g.
TEST(BaseCommand, BrakesAsHardAsTheSupportPolygonAllows) {
  Stance stance;
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
  EXPECT_NEAR(braking(), 9.81 * (x_front - 0.06) / height, 1e-6);
}

TEST(BaseCommand, WaitsWhileAFootholdGivesWay) {
  Stance stance;
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
  Stance stance = shifted({0.06, 0.0, -0.02});
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
  Stance stance;
  const BaseAutoCommand base = base_auto(stance.robot, stance.arc(Heading::straight(0.0)),
                                         stance.executor, stance.state.X_OB, {}, {});
  PoseAdaptationInput in = stance.executor.pose_adaptation_input(stance.state);
  in.p_BF[1].z() += 0.14;
  EXPECT_NEAR(base.adaptation(base, in).height, 0.0, 1e-12) << "a step as any other";
  in.blocked.insert(1);
  EXPECT_NEAR(base.adaptation(base, in).height, 0.07, 1e-12);
}

// Anywhere within the workspaces, on uneven ground, tilted by up to 5°.
void place_at_random(Stance& stance, RandomSequence& random) {
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

double margin(const Stance& stance) {
  return stability_margin(support_polygon(stance.state.p_OF, stance.executor.support()),
                          (stance.state.X_OB * stance.robot.p_BM).head<2>());
}

struct Least {
  double margin = std::numeric_limits<double>::infinity();  // [m]
  bool in_reach = true;                                     // each foot that stands
};

// The base moves for 1.5 s as it is told, without slip; its place on the path is `off` away.
Least move_base(Stance& stance, const PathArc& arc, const PlanarTwist& off, double dt) {
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
      Stance stance;
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

// Mirrored: the turn's sign, y of feet and footholds.
TEST(FootstepOf, MirrorsLeftAndRight) {
  Stance stance;
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
