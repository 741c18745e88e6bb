// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>
#include <testing/counted_allocations.hpp>
#include <testing/scripted_robot.hpp>
#include <type_traits>
#include <vector>

// What the executor does with what it can't execute.

namespace hexagait {
namespace {

using testing::argos;
using testing::kDt;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The executor keeps a pointer to its model: a model that is gone at once does not compile.
static_assert(std::is_constructible_v<Executor, const RobotModel&, ExecutorParams>);
static_assert(!std::is_constructible_v<Executor, RobotModel, ExecutorParams>);
static_assert(!std::is_constructible_v<StateEstimator, RobotModel, SensorMask>);
static_assert(!std::is_constructible_v<ActionRunner, RobotModel>);
static_assert(!std::is_constructible_v<ActionRunner, const RobotModel, RunnerParams>);
static_assert(!std::is_constructible_v<Sequencer, RobotModel, SequencerParams>);

/// Argos in its stance.
struct Stance {
  explicit Stance(const ExecutorParams& params = {}) : executor(argos(), params) {
    StateEstimator estimator(argos(), {});
    state = estimator.start({0.0, nominal_joints(argos()), LegArray<bool>(6, true)});
    executor.reset(state);
  }
  const JointTargets& tick(double dt = kDt) { return executor.advance(state, dt); }

  Executor executor;
  RobotState state;
};

bool finite(const JointTargets& targets) {
  bool finite = true;
  for (LegId i = 0; i < targets.q.size(); ++i)
    finite = finite && targets.q[i].allFinite() && targets.qd[i].allFinite() &&
             targets.effort[i].allFinite();
  return finite;
}

LegPlan plan_to(const Vector3& p, bool in_body) {
  LegPlan plan;
  plan.kind = LegPlan::Kind::foot;
  plan.duration = 0.1;
  plan.in_body = in_body;
  plan.foot.plan_target({}, {p, Vector3::Zero(), Vector3::Zero()}, plan.duration);
  return plan;
}

using Poison = std::function<void(Stance&, double)>;

// Commands that no step was planned from, with a number that is none or of which the square is.
std::vector<Poison> poisons() {
  return {[](Stance& s, double bad) {
            s.executor.command(FootstepCommand{.leg = 1, .p_OT = {bad, 0.0, 0.0}}, s.state);
          },
          [](Stance& s, double bad) {
            s.executor.command(FootstepCommand{.leg = 4, .profile_height = bad}, s.state);
          },
          [](Stance& s, double bad) {
            BaseAutoCommand base;
            base.path.v.x() = bad;
            base.adaptation = [](const BaseAutoCommand&, const PoseAdaptationInput&) {
              return BaseGoal{.advance = 0.1};
            };
            s.executor.command(base);
          },
          [](Stance& s, double) {
            BaseAutoCommand base;
            base.adaptation = [](const BaseAutoCommand&, const PoseAdaptationInput&) {
              return BaseGoal{.roll = kNaN};
            };
            s.executor.command(base);
          },
          [](Stance& s, double bad) {
            s.executor.command(2, plan_to({0.0, bad, 0.0}, true), s.state);
          },
          [](Stance& s, double bad) {
            s.executor.command(2, plan_to({0.0, bad, 0.0}, false), s.state);
          },
          [](Stance& s, double bad) {
            LegPlan push = plan_to(s.state.p_BF[3], true);
            push.force_O.z() = bad;
            s.executor.command(3, push, s.state);
          },
          [](Stance& s, double) {
            const BaseKnot knot{0.1, {Matrix3::Constant(kNaN), Vector3::Zero()}};
            BasePlan plan;
            plan.curve.plan({}, {&knot, 1});
            s.executor.command(plan);
          }};
}

TEST(ExecutorGuard, HoldsTheLastGoodTargetsUntilTheReset) {
  const std::vector<Poison> all = poisons();
  for (const Poison& poison : all) {
    for (const double bad : {kNaN, 1e300}) {
      Stance stance;
      stance.tick();
      const JointTargets start = stance.executor.targets();
      poison(stance, bad);
      bool failed = false;
      JointTargets before = start;
      for (int k = 0; k < 400; ++k) {
        const JointTargets& targets = stance.tick();
        ASSERT_TRUE(finite(targets)) << &poison - all.data() << " " << bad << " " << k;
        if (failed) {
          for (LegId i = 0; i < 6; ++i) ASSERT_EQ(targets.q[i], before.q[i]);
          for (LegId i = 0; i < 6; ++i) ASSERT_EQ(targets.qd[i].norm(), 0.0);
        }
        failed = stance.executor.failed();
        before = targets;
      }
      EXPECT_TRUE(failed || bad == 1e300) << &poison - all.data() << ": not noticed";
      stance.executor.reset(stance.state);
      EXPECT_FALSE(stance.executor.failed());
      EXPECT_TRUE(finite(stance.tick()));
    }
  }
}

TEST(ExecutorGuard, HoldsInAPeriodThatIsNone) {
  for (const double dt : {0.0, -0.002, kNaN, std::numeric_limits<double>::infinity()}) {
    Stance stance;
    EXPECT_TRUE(finite(stance.tick(dt))) << dt;
    EXPECT_TRUE(stance.executor.failed()) << dt;
  }
}

// Bounds that contradict each other: a foot would have to press with twice the weight and with no
// more than half of it. The tick is that of the kinematic controller.
TEST(ExecutorGuard, DrivesByPositionWhileContactForcesHaveNoSolution) {
  ExecutorParams params;
  params.controller = WholeBodyController::virtual_model;
  params.virtual_model.least_load = 2.0;
  params.virtual_model.most_load = 0.5;
  Stance soft(params), stiff;
  for (int k = 0; k < 50; ++k) {
    const JointTargets& targets = soft.tick();
    const JointTargets& expected = stiff.tick();
    ASSERT_EQ(soft.executor.contact_forces(), QpStatus::infeasible);
    EXPECT_FALSE(soft.executor.failed());
    for (LegId i = 0; i < 6; ++i) {
      EXPECT_EQ(targets.mode[i], ControlMode::position);
      EXPECT_EQ(targets.effort[i], expected.effort[i]);
      EXPECT_LT((targets.q[i] - expected.q[i]).norm(), 1e-12);
    }
  }
  EXPECT_STREQ(to_string(soft.executor.contact_forces()), "infeasible");

  params.virtual_model = {};
  Stance solved(params);
  EXPECT_EQ(solved.tick().mode[0], ControlMode::effort);
  EXPECT_STREQ(to_string(solved.executor.contact_forces()), "solved");
}

// 10 kN at a foot ask for more than any joint has; the weight of a heavy planet too.
TEST(ExecutorGuard, AsksNoJointForMoreThanItsEffortLimit) {
  const auto at_limit = [](const JointTargets& targets) {
    int count = 0;
    for (LegId i = 0; i < 6; ++i)
      for (int k = 0; k < 3; ++k) {
        const double limit = argos().legs[i].limits[k].effort;
        EXPECT_LE(std::abs(targets.effort[i][k]), limit);
        if (std::abs(targets.effort[i][k]) == limit) ++count;
      }
    return count;
  };
  Stance pushed;
  LegPlan push = plan_to(pushed.state.p_BF[0], true);
  push.duration = 0.4;
  push.lands = false;
  push.force_O = {1e4, 0.0, -1e4};
  pushed.executor.command(0, push, pushed.state);
  int most = 0;
  for (int k = 0; k < 200; ++k) most = std::max(most, at_limit(pushed.tick()));
  EXPECT_GT(most, 0);

  ExecutorParams heavy;
  heavy.gravity = 200.0;
  Stance planet(heavy);
  EXPECT_GT(at_limit(planet.tick()), 0);
}

// What a sequencer has reserved stays when the executor alone is reset: no tick allocates.
TEST(ExecutorGuard, KeepsTheReservedSpaceOverAReset) {
  Stance stance;
  stance.executor.reserve(50, 50, 50);
  LegPlan plan;
  plan.kind = LegPlan::Kind::foot;
  std::vector<FootKnot> knots;
  for (int k = 1; k <= 40; ++k) knots.push_back({0.01 * k, stance.state.p_BF[0], {}});
  plan.foot.reserve(50);
  plan.foot.plan_trajectory({stance.state.p_BF[0], Vector3::Zero(), Vector3::Zero()}, knots);
  plan.duration = plan.foot.duration();
  plan.in_body = true;
  stance.executor.reset(stance.state);
  const long before = testing::allocations;
  stance.executor.command(0, plan, stance.state);
  stance.tick();
  EXPECT_EQ(testing::allocations, before);
}

}  // namespace
}  // namespace hexagait
