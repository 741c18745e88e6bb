// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <limits>
#include <numeric>
#include <testing/argos.hpp>
#include <testing/round_params.hpp>
#include <thread>

namespace hexagait::sim3d {
namespace {

using testing::argos;

LegArray<LegJoints> everywhere(const LegJoints& q) { return LegArray<LegJoints>(6, q); }

// Joint positions with every foot at its workspace centre, moved by `shift` [m].
LegArray<LegJoints> stance(const Vector3& shift = Vector3::Zero()) {
  LegArray<LegJoints> q = everywhere(LegJoints::Zero());
  for (LegId leg = 0; leg < 6; ++leg) {
    const LegModel& model = argos().legs[leg];
    q[leg] = inverse_kinematics(model, model.p_BC + shift).q;
  }
  return q;
}

JointTargets at(const LegArray<LegJoints>& q) {
  return {q, everywhere(LegJoints::Zero()), everywhere(LegJoints::Zero())};
}

void run(World& world, const JointTargets& targets, double seconds) {
  const double end = world.truth().time + seconds - 1e-9;
  while (world.truth().time < end) world.write(targets);
}

double total_force(const World& world) {
  double sum = 0.0;
  for (const FootTruth& foot : world.truth().feet) sum += foot.normal_force;
  return sum;
}

int num_felt(World& world) {
  Measurement measurement;
  EXPECT_EQ(world.read(measurement), PlantStatus::fresh);
  return static_cast<int>(std::count(measurement.contact.begin(), measurement.contact.end(), true));
}

// ODE steps v before p, so after n steps the robot has fallen by g h² n (n + 1)/2.
TEST(World, LetsTheRobotFallFreely) {
  WorldParams params = hexagait::testing::round_world<WorldParams>();
  params.start_clearance = 2.0;
  World world(argos(), {}, params, stance());
  const double z0 = world.truth().X_WB.p.z();
  for (int n = 1; n <= 200; ++n) {
    world.write(at(stance()));
    EXPECT_NEAR(world.truth().X_WB.p.z(), z0 - 9.81 * 0.002 * 0.002 * n * (n + 1) / 2, 1e-9);
    EXPECT_NEAR((world.truth().V_WB.v - Vector3(0, 0, -9.81 * 0.002 * n)).norm(), 0.0, 1e-9);
  }
  EXPECT_NEAR(world.truth().time, 0.4, 1e-12);
  EXPECT_EQ(num_felt(world), 0);
}

TEST(World, StartsWithTheLowestFootJustAboveTheGround) {
  for (const char* terrain : {"flat", "boxes:0.1", "steps:0.1"}) {
    WorldParams params = hexagait::testing::round_world<WorldParams>();
    params.start = {2.0, {-40.0, 25.0}};
    World world(argos(), parse_terrain(terrain), params, stance());
    double lowest = 1.0;
    for (const FootTruth& foot : world.truth().feet) {
      const double ground = world.terrain().height_at(foot.p_WF.x(), foot.p_WF.y());
      lowest = std::min(lowest, foot.p_WF.z() - argos().foot_radius - ground);
    }
    EXPECT_NEAR(lowest, params.start_clearance, 1e-9);
    EXPECT_NEAR(roll_pitch_yaw(world.truth().X_WB.R).z(), 2.0, 1e-12);
  }
}

TEST(World, HoldsAStandingRobotWithForcesThatAddUpToItsWeight) {
  for (const char* terrain : {"flat", "boxes:0.1", "steps:0.1"}) {
    World world(argos(), parse_terrain(terrain), {}, stance());
    run(world, at(stance()), 2.0);
    EXPECT_NEAR(total_force(world), argos().mass * 9.81, 0.001 * argos().mass * 9.81);
    EXPECT_EQ(num_felt(world), 6);
    EXPECT_NEAR(world.truth().V_WB.v.norm() + world.truth().V_WB.w.norm(), 0.0, 1e-5);
    EXPECT_NEAR(roll_pitch_yaw(world.truth().X_WB.R).norm(), 0.0, 1e-6);
    EXPECT_FALSE(world.truth().base_touches_ground);
    EXPECT_TRUE(world.truth().finite);
    EXPECT_EQ(world.truth().solver_complaints, 0);
  }
}

// In a step, force F presses the foot in by h · cfm · F and the ground pushes out the fraction erp
// of the depth d: at rest, d = h · cfm/erp · F.
TEST(World, LetsAFootSinkByItsLoad) {
  WorldParams params = hexagait::testing::round_world<WorldParams>();
  params.contact_cfm = 1e-4;
  World world(argos(), {}, params, stance());
  run(world, at(stance()), 2.0);
  for (const FootTruth& foot : world.truth().feet) {
    const double depth = argos().foot_radius - foot.p_WF.z();
    EXPECT_NEAR(depth, 0.002 * 1e-4 / 0.3 * foot.normal_force, 1e-3 * depth);
  }
}

TEST(World, FeelsAFootFromTheThresholdOn) {
  World reference(argos(), {}, {}, stance());
  run(reference, at(stance()), 1.0);
  const double load = reference.truth().feet[0].normal_force;
  for (const double factor : {0.99, 1.01}) {
    WorldParams params = hexagait::testing::round_world<WorldParams>();
    params.contact_threshold = factor * load;
    World world(argos(), {}, params, stance());
    run(world, at(stance()), 1.0);
    Measurement measurement;
    world.read(measurement);
    EXPECT_EQ(measurement.contact[0], factor < 1.0);
  }
}

// The sensor latches: over ten physics steps it has felt what it would have felt in any of them.
// The robot drops, stands, and pulls all feet up, so that contact is made and lost within periods.
TEST(World, LatchesContactOverTheControlPeriod) {
  WorldParams slow = hexagait::testing::round_world<WorldParams>();
  slow.control_dt = 0.02;
  slow.start_clearance = 0.01;
  WorldParams fast = slow;
  fast.control_dt = 0.002;
  World latched(argos(), {}, slow, stance()), reference(argos(), {}, fast, stance());
  int lost_within_a_period = 0;
  for (int k = 0; k < 40; ++k) {
    const JointTargets targets = at(stance({0.0, 0.0, k % 10 < 5 ? 0.0 : 0.05}));
    latched.write(targets);
    LegSet felt, last;
    for (int i = 0; i < 10; ++i) {
      reference.write(targets);
      Measurement measurement;
      reference.read(measurement);
      for (LegId leg = 0; leg < 6; ++leg) {
        last.set(leg, measurement.contact[leg]);
        if (measurement.contact[leg]) felt.insert(leg);
      }
    }
    Measurement measurement;
    latched.read(measurement);
    for (LegId leg = 0; leg < 6; ++leg) EXPECT_EQ(measurement.contact[leg], felt.contains(leg));
    lost_within_a_period += felt == last ? 0 : 1;
  }
  EXPECT_GT(lost_within_a_period, 0);
}

TEST(World, FeelsNoFootWhenTheRobotLiesOnItsBelly) {
  WorldParams params = hexagait::testing::round_world<WorldParams>();
  params.start_clearance = 0.06;
  World world(argos(), {}, params, everywhere(LegJoints::Zero()));
  EXPECT_FALSE(world.truth().base_touches_ground);
  run(world, at(everywhere(LegJoints::Zero())), 0.5);
  EXPECT_TRUE(world.truth().base_touches_ground);
  EXPECT_EQ(num_felt(world), 0);
  EXPECT_EQ(total_force(world), 0.0);
}

TEST(World, HasGroundUnderTheRobotWhereverItIs) {
  for (const char* terrain : {"flat", "boxes:0.1", "steps:0.1"}) {
    for (const Vector2& place : {Vector2(100.0, -100.0), Vector2(-5000.0, 3000.0)}) {
      WorldParams params = hexagait::testing::round_world<WorldParams>();
      params.start = {0.3, place};
      World world(argos(), parse_terrain(terrain), params, stance());
      run(world, at(stance()), 1.5);
      EXPECT_GE(num_felt(world), 3) << terrain;
      EXPECT_NEAR(total_force(world), argos().mass * 9.81, 0.05 * argos().mass * 9.81) << terrain;
      EXPECT_LT((world.truth().X_WB.p.head<2>() - place).norm(), 0.1);
    }
  }
}

// Something that moves all joints and makes and breaks contacts.
JointTargets marching(double t) {
  JointTargets targets = at(stance());
  for (LegId leg = 0; leg < 6; ++leg) {
    const double phase = 5.0 * t + leg;
    const Vector3 lift(0.05 * std::sin(phase), 0.0, 0.05 * std::max(0.0, std::cos(phase)));
    const LegModel& model = argos().legs[leg];
    targets.q[leg] = inverse_kinematics(model, model.p_BC + lift).q;
  }
  return targets;
}

bool same_bits(const LegArray<LegJoints>& a, const LegArray<LegJoints>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const LegJoints& x, const LegJoints& y) {
                      return std::memcmp(x.data(), y.data(), sizeof(LegJoints)) == 0;
                    });
}

LegArray<LegJoints> q_after_marching(const char* terrain, double seconds) {
  WorldParams params = hexagait::testing::round_world<WorldParams>();
  params.start.shift = {30.0, 0.0};
  World world(argos(), parse_terrain(terrain), params, stance());
  while (world.truth().time < seconds) world.write(marching(world.truth().time));
  Measurement measurement;
  world.read(measurement);
  return measurement.q;
}

// Two worlds side by side, one made after they are gone, and two on threads of their own.
TEST(World, RepeatsItselfToTheLastBit) {
  for (const char* terrain : {"boxes:0.05", "steps:0.05"}) {
    const double seconds = 2.0;
    const LegArray<LegJoints> q = q_after_marching(terrain, seconds);
    EXPECT_GT((q[0] - stance()[0]).norm(), 1e-3);
    EXPECT_TRUE(same_bits(q, q_after_marching(terrain, seconds)));

    LegArray<LegJoints> q_a(6, LegJoints::Zero()), q_b(6, LegJoints::Zero());
    std::thread a([&] { q_a = q_after_marching(terrain, seconds); });
    std::thread b([&] { q_b = q_after_marching(terrain, seconds); });
    a.join();
    b.join();
    EXPECT_TRUE(same_bits(q, q_a));
    EXPECT_TRUE(same_bits(q, q_b));
  }
}

TEST(World, DoesNotDisturbAnotherInTheSameProcess) {
  WorldParams params = hexagait::testing::round_world<WorldParams>();
  World one(argos(), parse_terrain("boxes:0.05"), params, stance());
  World two(argos(), parse_terrain("boxes:0.05"), params, stance());
  World other(argos(), parse_terrain("steps:0.1"), params, stance({0.01, 0.0, 0.0}));
  Measurement q_one, q_two;
  for (int k = 0; k < 1000; ++k) {
    const JointTargets targets = marching(one.truth().time);
    one.write(targets);
    if (k % 3 == 0) other.write(targets);
    two.write(targets);
    one.read(q_one);
    two.read(q_two);
    ASSERT_TRUE(same_bits(q_one.q, q_two.q)) << "step " << k;
  }
}

TEST(World, CanBeMovedAndKeepsRunning) {
  World world(argos(), parse_terrain("boxes:0.05"), {}, stance());
  world.write(at(stance()));
  World moved = std::move(world);
  world = World(argos(), {}, {}, stance());
  run(moved, at(stance()), 0.5);
  run(world, at(stance()), 0.5);
  EXPECT_EQ(num_felt(moved), 6);
  EXPECT_EQ(num_felt(world), 6);
}

TEST(World, ClosesOnTargetsThatAreNotFinite) {
  World world(argos(), {}, {}, stance());
  run(world, at(stance()), 0.1);
  JointTargets targets = at(stance());
  targets.effort[0][0] = std::numeric_limits<double>::quiet_NaN();
  world.write(targets);
  world.write(at(stance()));
  Measurement measurement;
  EXPECT_EQ(world.read(measurement), PlantStatus::closed);
  EXPECT_NEAR(measurement.time, 0.1, 1e-12);
  EXPECT_FALSE(world.truth().finite);
}

// Of the whole robot [m].
Vector3 centre_of_mass(World& world) {
  Measurement measurement;
  EXPECT_EQ(world.read(measurement), PlantStatus::fresh);
  Vector3 sum = argos().base.mass * (argos().base.X_BL0 * argos().base.p_LM);
  double mass = argos().base.mass;
  for (LegId leg = 0; leg < 6; ++leg)
    for (int k = 0; k < 3; ++k) {
      const LinkModel& link = argos().legs[leg].links[k];
      sum += link.mass * (link_pose(argos().legs[leg], k, measurement.q[leg]) * link.p_LM);
      mass += link.mass;
    }
  return world.truth().X_WB * Vector3(sum / mass);
}

// Newton: without gravity, F moves the centre of mass of the floating robot by F h² n (n + 1)/2m in
// n steps, whatever the legs do meanwhile: be still, or kick with all that their servos have, in
// which each step is done twice.
TEST(World, IsPushedByAForceForATime) {
  const Vector3 force(30.0, -20.0, 50.0);
  WorldParams params = hexagait::testing::round_world<WorldParams>();
  params.gravity = 0.0;
  params.start_clearance = 5.0;
  for (const double kick : {0.0, 1.0}) {
    World world(argos(), {}, params, stance());
    const Vector3 p0 = centre_of_mass(world);
    world.push(force, 0.2);
    LegArray<LegJoints> q = stance();
    for (LegJoints& leg : q) leg.head<3>().array() += kick;
    run(world, at(q), 0.2);
    const Vector3 way = force / argos().mass * 0.002 * 0.002 * 100 * 101 / 2;
    EXPECT_NEAR((centre_of_mass(world) - p0 - way).norm(), 0.0, 1e-5) << kick;

    // Then it floats on at F t/m.
    run(world, at(q), 0.5);
    const Vector3 end = p0 + way + force / argos().mass * 0.2 * 0.5;
    EXPECT_NEAR((centre_of_mass(world) - end).norm(), 0.0, 1e-5) << kick;
  }
}

TEST(World, StandsOnABlockThatTheTerrainDoesNotKnow) {
  WorldParams params = hexagait::testing::round_world<WorldParams>();
  params.blocks = {{{0.0, 0.0, 0.05}, {4.0, 4.0, 0.1}}};
  params.start_clearance = 0.101;
  World world(argos(), {}, params, stance());
  run(world, at(stance()), 1.0);
  EXPECT_NEAR(world.truth().feet[0].p_WF.z(), 0.1 + argos().foot_radius, 1e-4);
  EXPECT_EQ(world.terrain().height_at(0.0, 0.0), 0.0);
}

// Under 10⁷ m/s² the robot is at 2 · 10⁴ m/s after one step, and ODE would soon abort.
TEST(World, ClosesWhenThePhysicsBlowsUp) {
  WorldParams params = hexagait::testing::round_world<WorldParams>();
  params.gravity = 1e7;
  World world(argos(), {}, params, stance());
  for (int k = 0; k < 10; ++k) world.write(at(stance()));
  Measurement measurement;
  EXPECT_EQ(world.read(measurement), PlantStatus::closed);
  EXPECT_EQ(measurement.time, 0.0);
}

// The largest targets there are: limits of position and effort hold.
TEST(World, SurvivesAnyFiniteTargets) {
  const double most = std::numeric_limits<double>::max();
  World world(argos(), {}, {}, stance());
  for (int k = 0; k < 500; ++k) {
    const LegArray<LegJoints> extreme = everywhere(LegJoints::Constant(k % 20 < 10 ? most : -most));
    world.write({extreme, k % 3 == 0 ? extreme : everywhere(LegJoints::Zero()), extreme});
  }
  EXPECT_TRUE(world.truth().finite);
  EXPECT_TRUE(world.truth().X_WB.p.allFinite());
}

TEST(World, RefusesEverythingThatIsWrongAtOnce) {
  RobotModel robot = argos();
  robot.legs[1].links[1].mass = 0.0;
  robot.legs[2].links[2].shapes.clear();
  robot.legs[3].limits[0].effort = 0.0;
  LegArray<LegJoints> q = stance();
  q[4][2] = -1.0;
  WorldParams params = hexagait::testing::round_world<WorldParams>();
  params.physics_dt = 0.003;
  params.control_dt = 0.005;
  params.friction = -1.0;
  params.contact_erp = 1.5;
  params.blocks = {{{0.0, 0.0, 0.0}, {0.1, 0.0, 0.1}}};
  params.start.angle = std::numeric_limits<double>::quiet_NaN();
  try {
    World world(robot, {}, params, q);
    FAIL() << "accepted";
  } catch (const InvalidInput& refusal) {
    for (const char* part : {"RF_femur", "LM: ", "RM_yaw", "LR_knee", "-1 rad", "control_dt",
                             "friction", "contact_erp", "start", "blocks"}) {
      EXPECT_THAT(refusal.what(), ::testing::HasSubstr(part));
    }
  }
  EXPECT_THROW(World(argos(), {}, {}, LegArray<LegJoints>(4, LegJoints::Zero())), InvalidInput);
}

}  // namespace
}  // namespace hexagait::sim3d
