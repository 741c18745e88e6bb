// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/executor/executor.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/argos.hpp>
#include <testing/executor_scene.hpp>
#include <testing/source_path.hpp>

namespace hexagait::executor_test {
namespace {

using testing::argos;
using testing::kDt;
using testing::Scene;

/// Pose adaptations that want something always: the executor has to obey, not to understand.
BaseAutoCommand restless(const PlanarTwist& path, int kind) {
  constexpr PoseAdaptation kKinds[] = {
      [](const BaseAutoCommand&, const PoseAdaptationInput&) { return BaseGoal{.advance = 1.0}; },
      [](const BaseAutoCommand&, const PoseAdaptationInput&) {
        return BaseGoal{1.0, 0.05, 0.1, -0.1};
      },
      [](const BaseAutoCommand&, const PoseAdaptationInput&) {
        return BaseGoal{-1.0, -0.05, -0.1, 0.1};
      },
      [](const BaseAutoCommand&, const PoseAdaptationInput&) { return BaseGoal{}; }};
  BaseAutoCommand base;
  base.adaptation = kKinds[kind];
  base.path = path;
  return base;
}

PlanarTwist random_path(RandomSequence& random) {
  const double angle = random.uniform(-3.1, 3.1);
  return {{std::cos(angle), std::sin(angle)}, random.uniform(-2.0, 2.0)};
}

// At the start, and with the first tick: nothing to confirm, nothing in the air.
TEST(Executor, StandsOnAllFeetFromTheReset) {
  const RobotModel model = argos(0.0);
  Scene scene(model);
  EXPECT_EQ(scene.executor.support(), LegSet::all(6));
  scene.tick();
  EXPECT_EQ(scene.executor.support(), LegSet::all(6));
}

// (executor 1) is a rigid motion, cut after the second order: |V dt|³/6 < 1e-9 m a tick.
TEST(Executor, KeepsTheDistancesOfStandingFeetUnderAnyBaseMotion) {
  const RobotModel model = argos(0.0);
  RandomSequence random{.seed = 5};
  for (int trial = 0; trial < 20; ++trial) {
    Scene scene(model);
    const LegArray<Vector3> start = scene.state.p_BF;
    scene.executor.command(restless(random_path(random), trial % 3));
    for (int tick = 1; tick <= 150; ++tick) {
      scene.tick();
      for (LegId i = 0; i < 6; ++i)
        for (LegId j = 0; j < i; ++j)
          ASSERT_NEAR((scene.executor.legs()[i].p_BF - scene.executor.legs()[j].p_BF).norm(),
                      (start[i] - start[j]).norm(), 1e-9 * tick);
    }
    EXPECT_GT((scene.executor.legs()[0].p_BF - start[0]).norm(), 0.02) << "it did move";
  }
}

// p_BF(t) = X_BO(t) p_O: under a body that moves by its own twist V, exactly integrated, the feet
// stand still in odom. (The other sign moves them twice.)
TEST(Executor, LeavesStandingFeetWhereTheyAreWhileTheBaseMoves) {
  const RobotModel model = argos(0.0);
  RandomSequence random{.seed = 6};
  for (int trial = 0; trial < 20; ++trial) {
    Scene scene(model);
    const LegArray<Vector3> footholds = scene.state.p_OF;
    scene.executor.command(restless(random_path(random), trial % 3));
    for (int tick = 1; tick <= 150; ++tick) scene.tick();
    EXPECT_GT((scene.state.X_OB.p - Scene(model).state.X_OB.p).norm(), 0.02);
    for (LegId i = 0; i < 6; ++i) EXPECT_LT((scene.state.p_OF[i] - footholds[i]).norm(), 1e-6);
  }
}

// Spherical feet: the centre moves by ω_tibia × ρ n, the contact under it stays. Summed over the
// motion for a body that shifts by 5 cm along x: foot i goes along by ρ times the turn of its tibia
// about y. The roll of a tick is predicted from the tick before: while the body speeds up it lags
// by one tick's, ρ φ̇ dt = 0.02 · 1 · 0.002 = 40 µm at a tibia's 1 rad/s.
TEST(Executor, RollsSphericalFeetWithTheirTibias) {
  const RobotModel model = argos(0.02);
  Scene scene(model);
  const LegArray<Vector3> before = scene.state.p_OF;
  LegArray<Vector3> rolled(6, Vector3::Zero());
  scene.executor.command(restless({{1.0, 0.0}, 0.0}, 0));
  double most = 0.0;
  while (scene.state.X_OB.p.x() < 0.05) {
    const RobotState then = scene.state;
    scene.tick();
    for (LegId i = 0; i < 6; ++i) {
      const Matrix3 R = tibia_rotation(model.legs[i], scene.state.trig[i]) *
                        tibia_rotation(model.legs[i], then.trig[i]).transpose();
      rolled[i] += rotation_vector(R).cross(Vector3(0.0, 0.0, 0.02));
    }
  }
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_LT((scene.state.p_OF[i] - before[i] - rolled[i]).norm(), 4e-5);
    EXPECT_GT(rolled[i].norm(), 1e-4);
    most = std::max(most, rolled[i].norm());
  }
  EXPECT_GT(most, 8e-4) << "twenty times that";
}

// Power: feet that press down on the ground with the weight W while the body rises at v do the work
// W v: Σ τ · q̇ = W v. Standing level on point feet, no leg is at rest then.
TEST(Executor, FeedsForwardTheEffortsThatLiftTheBody) {
  const RobotModel model = argos(0.0);
  Scene scene(model);
  BaseAutoCommand up;
  up.adaptation = [](const BaseAutoCommand&, const PoseAdaptationInput&) {
    return BaseGoal{.height = 0.1};
  };
  scene.executor.command(up);
  for (int tick = 0; tick < 100; ++tick) scene.tick();
  double power = 0.0;
  for (LegId i = 0; i < 6; ++i)
    power += scene.executor.targets().effort[i].dot(scene.executor.targets().qd[i]);
  const double weight = model.mass * scene.executor.params().gravity;
  EXPECT_NEAR(power, weight * scene.executor.base().vertical, 1e-3 * power);
  EXPECT_GT(scene.executor.base().vertical, 0.05);
}

// Each leg by itself: δW = τ · δq must be −F δz of the foot for every joint, with one F > 0.
TEST(Executor, GivesEachLegTheEffortsOfOneVerticalForce) {
  const RobotModel model = argos(0.0);
  Scene scene(model);
  scene.tick();
  double weight = 0.0;
  for (LegId i = 0; i < 6; ++i) {
    const LegJoints q = scene.executor.targets().q[i], effort = scene.executor.targets().effort[i];
    LegJoints dz = LegJoints::Zero();
    for (int k = 0; k < 3; ++k) {
      const LegJoints h = 1e-6 * LegJoints::Unit(k);
      dz[k] = (foot_position(model.legs[i], LegJoints(q + h)).z() -
               foot_position(model.legs[i], LegJoints(q - h)).z()) /
              2e-6;
    }
    const double force = -effort.dot(dz) / dz.squaredNorm();
    EXPECT_LT((effort + force * dz).norm(), 1e-6 * force);
    EXPECT_GT(force, 0.0);
    weight += force;
  }
  EXPECT_NEAR(weight, model.mass * 9.81, 1e-3);
}

/// A stream such as a gait generator might emit, and worse: steps for any leg at any time, and new
/// base commands, within the workspaces.
void command_at_random(Scene& scene, RandomSequence& random) {
  if (random.u01() < 0.01)
    scene.executor.command(restless(random_path(random), static_cast<int>(4 * random.u01())));
  for (LegId i = 0; i < 6; ++i) {
    if (random.u01() > 0.01) continue;
    const LegModel& leg = scene.model.legs[i];
    const double angle = random.uniform(-3.1, 3.1), r = 0.7 * leg.workspace_radius * random.u01();
    const Vector3 target_B = leg.p_BC + r * Vector3(std::cos(angle), std::sin(angle), 0.0);
    Vector3 target_O = scene.state.X_OB * target_B;
    target_O.z() = 0.0;
    scene.executor.command(FootstepCommand{i, target_O, 0.1}, scene.state);
  }
  // The walker keeps the body over its feet; here it turns back in time.
  const Vector3& p = scene.state.X_OB.p;
  const double tilt = 1.0 - scene.state.X_OB.R(2, 2);
  if (p.head<2>().norm() > 0.05 || std::abs(p.z() - 0.3) > 0.03 || tilt > 0.002)
    scene.executor.command(BaseAutoCommand{});
}

// No joint target jumps: a tick's change is within what the joint's speed limit allows, but for the rounding of sums, and
// qd says what the targets do.
void expect_speed_limits(const RobotModel& model, std::uint32_t trials) {
  for (std::uint32_t trial = 0; trial < trials; ++trial) {
    RandomSequence random{.seed = 7, .trial = trial};
    Scene scene(model);
    for (int tick = 0; tick < 1500; ++tick) {
      command_at_random(scene, random);
      const LegArray<LegJoints> before = scene.executor.targets().q;
      scene.tick();
      for (LegId i = 0; i < 6; ++i) {
        const LegJoints change = scene.executor.targets().q[i] - before[i];
        ASSERT_LT((change - kDt * scene.executor.targets().qd[i]).norm(), 1e-12);
        for (int k = 0; k < model.legs[i].num_joints(); ++k)
          ASSERT_LE(std::abs(change[k]), model.legs[i].limits[k].velocity * kDt + 1e-15)
              << "trial " << trial << " tick " << tick << " leg " << i << " joint " << k << " "
              << to_string(scene.executor.legs()[i].phase);
      }
    }
  }
}

TEST(Executor, NeverMovesAJointTargetFasterThanItsLimit) { expect_speed_limits(argos(0.0), 20); }

TEST(Executor, NeverMovesAnyOfFourJointsFasterThanItsLimit) {
  expect_speed_limits(load_urdf(testing::source_path("robots/hexapod_4dof.urdf")), 3);
}

void expect_same(const Executor& a, const Executor& b) {
  for (LegId i = 0; i < 6; ++i) {
    ASSERT_EQ(a.targets().q[i], b.targets().q[i]);
    ASSERT_EQ(a.targets().qd[i], b.targets().qd[i]);
    ASSERT_EQ(a.targets().effort[i], b.targets().effort[i]);
    ASSERT_EQ(a.legs()[i].phase, b.legs()[i].phase);
  }
}

TEST(Executor, ContinuesIdenticallyAsACopy) {
  const RobotModel model = argos(0.02);
  RandomSequence random{.seed = 8};
  Scene scene(model);
  for (int tick = 0; tick < 400; ++tick) command_at_random(scene, random), scene.tick();
  Scene copy = scene;
  RandomSequence same = random;
  for (int tick = 0; tick < 400; ++tick) {
    command_at_random(scene, random), scene.tick();
    command_at_random(copy, same), copy.tick();
    expect_same(scene.executor, copy.executor);
  }
}

// Standing feet, spherical ones too, stay where they are until a new command; nothing has a speed.
TEST(ExecutorHold, StopsTheBaseAndKeepsTheSetPointsOfStandingFeet) {
  const RobotModel model = argos(0.02);
  Scene scene(model);
  scene.executor.command(restless({{1.0, 0.0}, 0.5}, 1));
  for (int tick = 0; tick < 100; ++tick) scene.tick();
  const LegArray<LegJoints> q = scene.executor.targets().q;
  EXPECT_GT(scene.executor.base().planar.v.norm(), 0.1);

  scene.executor.hold();
  EXPECT_EQ(scene.executor.base().planar.v.norm(), 0.0);
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_EQ(scene.executor.targets().q[i], q[i]);
    EXPECT_EQ(scene.executor.targets().qd[i].norm(), 0.0);
  }
  for (int tick = 0; tick < 10; ++tick) {
    scene.tick();
    for (LegId i = 0; i < 6; ++i)
      ASSERT_LT((scene.executor.targets().q[i] - q[i]).norm(), 1e-12) << "tick " << tick;
  }
}

TEST(ExecutorHold, LeavesNoSpeedToAFootInTheAir) {
  const RobotModel model = argos(0.0);
  Scene scene(model);
  scene.executor.command(
      FootstepCommand{2, scene.state.X_OB * (model.legs[2].p_BC + Vector3(0.1, 0, 0)), 0.1},
      scene.state);
  for (int tick = 0; tick < 100; ++tick) scene.tick();
  ASSERT_EQ(scene.executor.legs()[2].phase, LegPhase::transfer);
  EXPECT_GT(scene.executor.legs()[2].v_O.norm(), 0.1);
  scene.executor.hold();
  EXPECT_EQ(scene.executor.legs()[2].v_O.norm(), 0.0);
  EXPECT_EQ(scene.executor.legs()[2].a_O.norm(), 0.0);
}

// Load weighs the trust of odometry: none in the air, none without contact.
TEST(Executor, TellsOdometryHowFarToTrustEachFoot) {
  const RobotModel model = argos(0.0);
  Scene scene(model);
  scene.executor.command(FootstepCommand{2, scene.state.p_OF[2]}, scene.state);
  for (int tick = 0; tick < 10; ++tick) scene.tick();
  EXPECT_NEAR(scene.executor.footing()[2], 0.5, 1e-9) << "half unloaded";
  EXPECT_EQ(scene.executor.footing()[3], 1.0);
  for (int tick = 0; tick < 20; ++tick) scene.tick();
  EXPECT_EQ(scene.executor.footing()[2], 0.0);
  EXPECT_FALSE(scene.executor.support().contains(2));
  scene.state.contact[3] = false;
  scene.executor.advance(scene.state, kDt);
  EXPECT_EQ(scene.executor.footing()[3], 0.0);
  EXPECT_TRUE(scene.executor.support().contains(3)) << "not yet lost";
}

// Only of a foot that stands: one on its way may move as it likes.
TEST(Executor, IsUnsureOfAFootholdThatGivesWay) {
  const RobotModel model = argos(0.0);
  Scene scene(model);
  scene.state.slide_O = LegArray<Vector3>(6, Vector3::Zero());
  scene.executor.command(FootstepCommand{2, scene.state.p_OF[2]}, scene.state);
  for (int tick = 0; tick < 60; ++tick) scene.tick();
  EXPECT_TRUE(scene.executor.unsure().empty());
  for (const LegId i : {2, 3}) scene.state.slide_O[i].x() += 0.003;
  scene.executor.sense(scene.state, kDt);
  EXPECT_EQ(scene.executor.unsure(), LegSet(0b001000));
  EXPECT_TRUE(scene.executor.support().contains(3)) << "it carries its load still";
}

// A foot that has bounced may bounce again: no neighbour lifts until its contact has lasted. A robot that is put down stands.
TEST(Executor, IsUnsureOfAFootThatHasJustTouchedAgain) {
  const RobotModel model = argos(0.0);
  Scene scene(model);
  EXPECT_TRUE(scene.executor.unsure().empty());
  const auto sensed = [&scene](bool contact) {
    scene.state.contact[3] = contact;
    scene.executor.sense(scene.state, kDt);
    return scene.executor.unsure();
  };
  EXPECT_EQ(sensed(false), LegSet(0b001000));
  const int ticks = static_cast<int>(std::lround(scene.executor.params().swing.touch_time / kDt));
  for (int tick = 0; tick < ticks; ++tick) EXPECT_EQ(sensed(true), LegSet(0b001000)) << tick;
  EXPECT_TRUE(sensed(true).empty());
}

// A foothold a metre away, and an apex of a metre: the set point ends where the leg does, is where
// the joints are, and comes back at once when the next command is within reach.
TEST(Executor, NeverWindsASetPointUpBeyondTheLegsReach) {
  const RobotModel robot = argos(0.0);
  for (const double height : {0.1, 1.0}) {
    Scene scene(robot);
    const Vector3 start = scene.state.p_OF[0];
    for (int k = 0; k < 1500; ++k) {
      const double far = height < 0.5 ? 1.0 : 0.1;
      scene.executor.command({0, start + Vector3(far, far, 0.0), height}, scene.state);
      scene.tick();
      const Vector3 p_BF = foot_position(robot.legs[0], leg_trig(robot.legs[0], scene.state.q[0]));
      ASSERT_LT((scene.executor.legs()[0].p_BF - p_BF).norm(), 0.04) << height << ", tick " << k;
      ASSERT_LT(scene.executor.legs()[0].v_O.norm(), 3.0);
    }
    EXPECT_LE(scene.executor.legs()[0].retreats, scene.executor.params().swing.max_retreats);
  }
}

// A body that is asked to go on for ever: it stops where its standing legs end, and does not drag
// them. Asked to come back it does.
TEST(Executor, StopsTheBaseWhereAStandingLegEnds) {
  const RobotModel robot = argos(0.0);
  for (const Vector2& way : {Vector2(1.0, 0.0), Vector2(0.0, 1.0), Vector2(-0.6, 0.8)}) {
    Scene scene(robot);
    BaseAutoCommand base = restless({way, 0.0}, 0);
    scene.executor.command(base);
    for (int k = 0; k < 3000; ++k) scene.tick();
    EXPECT_LT(scene.executor.base().twist().v.norm(), 1e-9);
    // Braking from 0.6 m/s at 1.2 m/s² takes 15 cm, of which the feet slide.
    for (LegId i = 0; i < 6; ++i) {
      const Vector3 p_BF = foot_position(robot.legs[i], leg_trig(robot.legs[i], scene.state.q[i]));
      EXPECT_LT((scene.executor.legs()[i].p_BF - p_BF).norm(), 0.15 + 1e-3) << i;
    }
    base.path.v = -way;
    scene.executor.command(base);
    const double before = scene.state.X_OB.p.head<2>().dot(way);
    for (int k = 0; k < 200; ++k) scene.tick();
    EXPECT_LT(scene.state.X_OB.p.head<2>().dot(way), before - 0.05);
  }
}

// (executor 4) Friction holds a body on legs of two joints that is told to go down faster than the foot in the air: the
// command ends, and the foot comes down.
TEST(Executor, StopsABaseThatRunsFromAFootOfTwoJoints) {
  RobotModel robot = argos(0.0);
  for (LegModel& leg : robot.legs) {
    leg.kind = LegKind::yaw_pitch;
    LegJoints q = LegJoints::Zero();
    q[1] = leg.joint_sign[1] * 0.8;
    leg.p_BC = foot_position(leg, leg_trig(leg, q));
  }
  Scene scene(robot);
  RobotState& state = scene.state;
  BaseAutoCommand base = restless({}, 3);
  base.adaptation = [](const BaseAutoCommand&, const PoseAdaptationInput&) {
    return BaseGoal{.height = -1.0};
  };
  scene.executor.command(base);
  scene.executor.command({0, state.p_OF[0], 0.05}, state);
  const double ground = state.p_OF[0].z();
  double lowest = ground;
  for (int k = 0; k < 1000; ++k) {
    state.q[0] = scene.executor.advance(state, kDt).q[0];  // no standing leg moves
    scene.sense();
    state.contact = LegArray<bool>(6, true);
    state.contact[0] = scene.executor.legs()[0].on_ground();
    lowest = std::min(lowest, state.p_OF[0].z());
  }
  EXPECT_LT(lowest, ground - 0.02);
}

}  // namespace
}  // namespace hexagait::executor_test
