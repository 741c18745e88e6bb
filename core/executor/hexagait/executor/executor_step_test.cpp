// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <hexagait/executor/executor.hpp>
#include <testing/argos.hpp>
#include <testing/executor_scene.hpp>

// Steps of a robot that does exactly what the executor wants.

namespace hexagait::executor_step_test {
namespace {

using testing::argos;
using testing::kDt;
using testing::Scene;

// (executor 3) With joints of a quarter of the speed that the step asks for: the set point waits for them, on
// its way, so that nothing seems to block the foot.
TEST(Executor, SlowsAStepDownToWhatItsJointsCanDo) {
  RobotModel model = argos(0.0);
  for (LegModel& leg : model.legs)
    for (JointLimits& limits : leg.limits) limits.velocity = 1.0;
  Scene scene(model);
  const LegId leg = 2;
  const Vector3 start = scene.state.p_OF[leg], target = start + Vector3(0.1, 0.1, 0.0);
  scene.executor.command({leg, target, 0.1}, scene.state);
  int limited = 0;
  for (int k = 0; k < 2000; ++k) {
    scene.tick();
    const LegLane& lane = scene.executor.legs()[leg];
    ASSERT_EQ(lane.retreats, 0);
    if (lane.on_ground()) continue;
    ASSERT_LT((lane.p_BF - scene.state.p_BF[leg]).norm(), 1e-9) << k;
    const double most = scene.executor.targets().qd[leg].cwiseAbs().maxCoeff();
    ASSERT_LE(most, 1.0 * (1.0 + 1e-9));
    limited += most > 0.999;
    const Vector3 way = scene.state.p_OF[leg] - start;
    ASSERT_LT(std::abs(way.x() - way.y()), 0.003) << "on its way";
  }
  EXPECT_GT(limited, 50);
  EXPECT_LT((scene.state.p_OF[leg] - target).head<2>().norm(), 0.005);
}

// A foot whose joints are too slow for it, and whose target comes nearer while it descends: how far it passes it is a
// matter of the joints, not of the period.
TEST(Executor, BrakesAFootThatItsJointsHoldBackAtAnyPeriod) {
  const RobotModel robot = argos(0.0);
  constexpr LegId kLeg = 2;
  const auto passed = [&robot](double dt) {
    Scene scene(robot);
    FootstepCommand step{kLeg, scene.state.p_OF[kLeg] + Vector3(0.0, 0.27, 0.0), 0.03};
    step.haste = 1.8;
    scene.executor.command(step, scene.state);
    double farthest = 0.0, limited = 0.0;
    for (double t = 0.0; t < 1.0; t += dt) {
      scene.tick(dt);
      if (scene.executor.legs()[kLeg].phase == LegPhase::descend) {
        step.p_OT.y() = robot.legs[kLeg].p_BC.y() + 0.2;
        scene.executor.command(step, scene.state);
      }
      farthest = std::max(farthest, scene.state.p_OF[kLeg].y() - step.p_OT.y());
      const double knee = std::abs(scene.executor.targets().qd[kLeg][2]);
      if (knee > robot.legs[kLeg].limits[2].velocity - 1e-6) limited += dt;
    }
    EXPECT_GT(limited, 0.05);
    EXPECT_EQ(scene.executor.legs()[kLeg].retreats, 0) << dt;
    return farthest;
  };
  const double usual = passed(0.002);
  EXPECT_LT(usual, 0.05);
  for (const double dt : {0.001, 0.005, 0.01}) EXPECT_NEAR(passed(dt), usual, 0.005) << dt;
}

// (swing 7) A tripod is in the air, and one of its legs is told to go back: the others wait for it, and all land together.
TEST(Executor, TurnsTheLegsOfATripodInOneTime) {
  const RobotModel robot = argos(0.0);
  static constexpr LegId kTripod[] = {0, 3, 4};
  const auto landings = [&robot](bool turns) {
    Scene scene(robot);
    const auto command = [&scene](LegId leg, double way) {
      const Vector3 target = scene.state.print_O[leg] + Vector3(way, 0.0, 0.0);
      scene.executor.command({leg, target, 0.1}, scene.state);
    };
    for (const LegId leg : kTripod) command(leg, 0.22);
    std::array<double, 3> at{};
    bool turned = !turns;
    for (double t = 0.0; t < 2.0; t += kDt) {
      scene.tick();
      const double way = (scene.state.p_OF[0] - scene.state.print_O[0]).x();
      if (!turned && way > 0.13) command(0, -0.05), turned = true;
      for (std::size_t k = 0; k < at.size(); ++k)
        if (scene.executor.legs()[kTripod[k]].phase == LegPhase::descend) at[k] = t;
    }
    EXPECT_TRUE(turned);
    return at;
  };
  const auto straight = landings(false), turned = landings(true);
  EXPECT_GT(turned[0], straight[0] + 0.05);
  for (const double landed : turned) EXPECT_NEAR(landed, turned[0], 0.01);
}

// A foot that finds no ground counts as lower than its last footprint, by a share of how deep it has come.
TEST(Executor, LowersTheBodyTowardsAFootThatSearchesByTheShareThatIsAllowed) {
  const RobotModel robot = argos(0.0);
  constexpr LegId kLeg = 2;
  for (const double share : {0.0, 0.25, 1.0}) {
    static LegArray<Vector3> footprint;
    Scene scene(robot);
    BaseAutoCommand base;
    base.adaptation = [](const BaseAutoCommand&, const PoseAdaptationInput& in) {
      footprint = in.footprint_BF;
      return BaseGoal{};
    };
    base.lowering = share;
    scene.executor.command(base);
    const double ground = scene.state.p_BF[kLeg].z();
    FootstepCommand step{kLeg, scene.state.p_OF[kLeg] + Vector3(0.05, 0.0, 0.0), 0.05};
    scene.executor.command(step, scene.state);
    double depth = 0.0;
    for (double t = 0.0; t < 5.0 && depth < 0.1; t += kDt) {
      depth = ground - scene.executor.legs()[kLeg].p_BF.z();
      scene.tick();
      scene.state.contact[kLeg] = false;
    }
    ASSERT_GE(depth, 0.1);
    EXPECT_NEAR(footprint[kLeg].z(), ground - share * depth, 1e-9);
    EXPECT_NEAR(footprint[0].z(), scene.state.p_BF[0].z(), 1e-9);
  }
}

}  // namespace
}  // namespace hexagait::executor_step_test
