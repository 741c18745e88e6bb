// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/sim/random.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/executor_scene.hpp>
#include <testing/source_path.hpp>

namespace hexagait {
namespace {

using testing::kDt;
using testing::Scene;

RobotModel load(const std::string& name) {
  return load_urdf(testing::source_path("robots/" + name + ".urdf"));
}

// The numbers are drawn in this order with any compiler.
Twist random_twist(RandomSequence& random, double speed) {
  const double angle = random.uniform(-3.1, 3.1), up = 0.2 * random.uniform(-1.0, 1.0);
  const double roll = random.uniform(-0.3, 0.3), pitch = random.uniform(-0.3, 0.3);
  const double yaw = random.uniform(-2.0, 2.0);
  return {speed * Vector3(std::cos(angle), std::sin(angle), up), speed * Vector3(roll, pitch, yaw)};
}

/// How far the foot gets from where the body's motion leaves it, on the line of one piece.
struct Slip {
  double found = 0.0, bound = 0.0, at_end = 0.0;
};

Slip slip_of(const LegModel& leg, const Twist& V, double period) {
  const LegSolution start = inverse_kinematics(leg, leg.p_BC);
  const LegSolution end =
      joints_after(leg, leg.p_BC, start.q, start.trig, V, period, Vector3::Zero());
  EXPECT_TRUE(end.reachable);
  Slip slip;
  slip.bound = most_slip(leg, leg.p_BC, start.q, end.q, V, period);
  constexpr int kPoints = 40;
  for (int k = 1; k <= kPoints; ++k) {
    const double share = static_cast<double>(k) / kPoints;
    const Vector3 p_BF = foot_position(leg, LegJoints(start.q + share * (end.q - start.q)));
    slip.at_end = (displacement(V, share * period) * p_BF - leg.p_BC).norm();
    slip.found = std::max(slip.found, slip.at_end);
  }
  return slip;
}

TEST(Displacement, IsWhatTheTwistIntegratesTo) {
  RandomSequence random{.seed = 1};
  for (int trial = 0; trial < 50; ++trial) {
    const Twist V = random_twist(random, 0.3);
    Pose X;
    constexpr int kSteps = 20'000;
    for (int k = 0; k < kSteps; ++k) {
      const double dt = 0.1 / kSteps;
      X = X * Pose{rotation(V.w * dt), rotation(0.5 * V.w * dt) * (dt * V.v)};
    }
    const Pose found = displacement(V, 0.1);
    // The term of the series that is left out: φ³ |way| / 24, with φ = 0.062 rad, 30.6 mm.
    EXPECT_LT((found.p - X.p).norm(), 3.1e-7);
    EXPECT_LT((found.R - X.R).norm(), 1e-6);
  }
}

// A piece lasts whole control periods, at least one.
TEST(DisplacementTicks, AreTheNearestNumberOfPeriods) {
  EXPECT_EQ(displacement_ticks(0.05, 0.002), 25);
  EXPECT_EQ(displacement_ticks(0.05, 0.02), 3);
  EXPECT_EQ(displacement_ticks(0.001, 0.02), 1);
}

// The chord of a curve f between f(0) and f(1) is within max |f''|/8 of it; here f is the foot along
// the line of joints, less its path under V.
TEST(DiscreteDisplacement, LetsNoFootSlipFartherThanTheBend) {
  for (const char* name : {"argos", "lauron", "mite", "hexapod_4dof"}) {
    const RobotModel robot = load(name);
    const double size = robot.legs[0].p_BC.head<2>().norm();
    for (const double period : {0.01, 0.02, 0.05, 0.1, 0.2})
      for (const double speed : {0.05, 0.1, 0.2, 0.4}) {
        RandomSequence random{.seed = 2};
        double greatest_share = 0.0;
        for (int trial = 0; trial < 20; ++trial) {
          const Twist V = random_twist(random, speed * size);
          const LegModel& leg = robot.legs[trial % robot.num_legs()];
          const Slip slip = slip_of(leg, V, period);
          EXPECT_LE(slip.found, 1.0001 * slip.bound + 1e-9) << name << period << speed;
          EXPECT_LT(slip.at_end, 1e-8) << name;
          greatest_share = std::max(greatest_share, slip.found / slip.bound);
        }
        EXPECT_GT(greatest_share, 0.1) << "the bound says little";
      }
  }
}

TEST(DiscreteDisplacement, SlipsWithTheSquareOfThePeriod) {
  const RobotModel robot = load("lauron");
  RandomSequence random{.seed = 3};
  for (int trial = 0; trial < 30; ++trial) {
    const Twist V = random_twist(random, 0.15);
    const LegModel& leg = robot.legs[trial % 6];
    const Slip whole = slip_of(leg, V, 0.1), half = slip_of(leg, V, 0.05);
    EXPECT_NEAR(whole.found / half.found, 4.0, 0.4);
  }
}

/// A Scene whose base moves at a twist in pieces of a period, on feet that don't roll.
struct DiscreteScene {
  RobotModel model;
  Scene scene;

  DiscreteScene(RobotModel robot, double period, const PlanarTwist& path)
      : model(std::move(robot)), scene((model.foot_radius = 0.0, model)) {
    ExecutorParams params = testing::round_executor();
    params.base.displacement_period = period;
    params.base.max_speed = 0.2;
    scene.executor = Executor(model, params);
    scene.executor.reset(scene.state);
    BaseAutoCommand base;
    base.adaptation = [](const BaseAutoCommand&, const PoseAdaptationInput&) {
      return BaseGoal{.advance = 1.0};
    };
    base.path = path;
    scene.executor.command(base);
  }
};

// From a bound of the chord to feet that stand: nothing else moves them. Without the option the feet
// stay to rounding errors.
TEST(DiscreteExecutor, KeepsStandingFeetWithinTheBound) {
  for (const double period : {0.0, 0.02, 0.05, 0.1})
    for (const PlanarTwist& path : {PlanarTwist{{1.0, 0.0}, 0.0}, PlanarTwist{{0.6, -0.8}, 0.0},
                                    PlanarTwist{{0.5, 0.0}, 2.0}}) {
      DiscreteScene discrete(load("lauron"), period, path);
      Scene& scene = discrete.scene;
      const LegArray<Vector3> before = scene.state.p_OF;
      double slip = 0.0, bound = 0.0;
      LegArray<LegJoints> q = scene.state.q;
      LegArray<Vector3> p_BF = scene.state.p_BF;
      const int ticks = period > 0.0 ? displacement_ticks(period, kDt) : 1;
      for (int tick = 0; tick < 200; ++tick) {
        scene.tick();
        for (LegId i = 0; i < 6; ++i)
          slip = std::max(slip, (scene.state.p_OF[i] - before[i]).norm());
        if ((tick + 1) % ticks != 0) continue;
        const Twist V = scene.executor.base().twist();
        for (LegId i = 0; i < 6; ++i)
          bound = std::max(bound, most_slip(discrete.model.legs[i], p_BF[i], q[i], scene.state.q[i],
                                            V, ticks * kDt));
        q = scene.state.q;
        p_BF = scene.state.p_BF;
      }
      EXPECT_GT(scene.executor.base().twist().v.norm(), 0.09);
      EXPECT_LE(slip, bound + 2e-6) << period;
      EXPECT_LT(slip, period > 0.0 ? 1e-3 : 2e-6);
      EXPECT_GT(slip, period > 0.03 ? 0.1 * bound : 0.0);
    }
}

// All joints move along one straight line, and arrive together; so do they when one is too slow for
// the base, which is then slower.
TEST(DiscreteExecutor, LetsAllJointsArriveTogether) {
  for (const double slowest : {8.0, 0.2}) {
    RobotModel robot = load("lauron");
    robot.legs[2].limits[0].velocity = slowest;
    DiscreteScene discrete(robot, 0.05, {{1.0, 0.0}, 0.0});
    Scene& scene = discrete.scene;
    for (int piece = 0; piece < 12; ++piece) {
      LegArray<LegJoints> first(6);
      for (int tick = 0; tick < 25; ++tick) {
        const LegArray<LegJoints> q = scene.executor.targets().q;
        scene.tick();
        for (LegId i = 0; i < 6; ++i) {
          const LegJoints change = scene.executor.targets().q[i] - q[i];
          if (tick == 0) first[i] = change;
          EXPECT_LT((change - first[i]).norm(), 1e-12) << piece << tick;
          EXPECT_LE(std::abs(change[0]), discrete.model.legs[i].limits[0].velocity * kDt + 1e-12);
        }
      }
      for (LegId i = 0; i < 6; ++i)
        EXPECT_LT((scene.executor.legs()[i].p_BF - scene.state.p_BF[i]).norm(), 2e-6);
    }
    const double speed = scene.executor.base().twist().v.norm();
    EXPECT_EQ(speed > 0.1, slowest > 1.0) << speed;
  }
}

// The base decides at the end of a displacement, and keeps its limit of acceleration between them.
TEST(DiscreteExecutor, KeepsTheLimitsOfTheBase) {
  DiscreteScene discrete(load("lauron"), 0.05, {{1.0, 0.0}, 0.0});
  Scene& scene = discrete.scene;
  double before = 0.0;
  for (int tick = 0; tick < 200; ++tick) {
    scene.tick();
    const double v = scene.executor.base().twist().v.x();
    EXPECT_TRUE(tick % 25 == 0 || v == before);
    EXPECT_LE(v - before, scene.executor.params().base.acceleration * 0.05 + 1e-12);
    before = v;
  }
  EXPECT_DOUBLE_EQ(before, 0.2);
}

TEST(DiscreteExecutor, IsOffUnlessAskedFor) {
  for (const char* name : {"argos", "lauron"})
    EXPECT_EQ(params_for(load(name)).base.displacement_period, 0.0);
}

}  // namespace
}  // namespace hexagait
