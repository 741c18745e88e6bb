// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The virtual model in physics: the base as a mass in a spring, and what that is good for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <hexagait/load/load_action.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/walk/actions/action_trial.hpp>
#include <hexagait/walk/start_posture.hpp>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait::walk::virtual_model_test {
namespace {

constexpr auto kKinematic = WholeBodyController::kinematic;
constexpr auto kVirtualModel = WholeBodyController::virtual_model;

using testing::argos;

action::Action standing(double seconds) {
  return action::parse_action("steps: [step: [wait: {duration: " + std::to_string(seconds) + "}]]",
                              "test.yaml", argos());
}

/// A robot and its world, and what the referee saw.
struct Trial {
  explicit Trial(WholeBodyController controller)
      : world(argos(), {}, {}, start_posture(argos(), StartKind::standing).q) {
    params.executor.controller = controller;
  }

  ActionSummary run(const action::Action& action, const ActionObserver& observer = {}) {
    ActionRunner runner(argos(), params);
    return run_action(runner, world, world.truth(), action, {}, observer);
  }

  sim3d::World world;
  RunnerParams params;
};

/// The law that the base is to obey, by itself: p'' = ω² (p_D − p) + 2 ζ ω (p_D' − p').
struct Spring {
  double w = 12.5, zeta = 1.0;
  Vector3 p = Vector3::Zero(), v = Vector3::Zero(), last_D = Vector3::Zero();
  void follow(const Vector3& p_D, double dt) {
    v += dt * (w * w * (p_D - p) + 2.0 * zeta * w * ((p_D - last_D) / dt - v));
    p += dt * v;
    last_D = p_D;
  }
};

/// How far the base was from its plan, and from a mass that a spring leads along it [m].
struct PlanError {
  ActionSummary summary;
  double beside_spring = 0.0;
};

PlanError plan_error(const std::string& name, WholeBodyController controller) {
  Trial trial(controller);
  const action::Action action =
      action::load_action(testing::source_path("actions/" + name + ".yaml"), argos());
  PlanError error;
  Pose X_WO;
  Spring spring;
  bool begun = false;
  const auto watch = [&](const ActionRecord& record, const GroundTruth& truth) {
    if (!record.desired.base_follows) return true;
    if (!begun) {
      X_WO = truth.X_WB * record.state.X_OB.inverse();
      spring.p = spring.last_D = truth.X_WB.p;
    }
    begun = true;
    const Pose X_WD = X_WO * record.desired.X_OB;
    spring.follow(X_WD.p, 0.002);
    error.beside_spring = std::max(error.beside_spring, (spring.p - truth.X_WB.p).norm());
    return true;
  };
  error.summary = trial.run(action, watch);
  EXPECT_TRUE(error.summary.ok()) << name;
  return error;
}

// A spring lags behind what accelerates: up to a/ω², with a up to 4 m/s² where `height` goes down
// by 6 cm in 0.3 s. What it does not know is that legs (18 of 50 kg) don't go all the way with the
// body, and the friction of the drives: 6 legs, 2 joints, 1 N m s/rad at 0.28 m are 150 N s/m, at
// 0.3 m/s half a centimetre of spring. The kinematic controller gives way by its servos alone.
TEST(VirtualModel, LeadsTheBaseAlongItsPlanAsASpringLeadsAMass) {
  for (const char* name : {"push_up_six", "look_around", "body_circle", "height"}) {
    const PlanError stiff = plan_error(name, kKinematic), soft = plan_error(name, kVirtualModel);
    EXPECT_LT(stiff.summary.off_plan_height, 0.001) << name;
    EXPECT_LT(stiff.summary.off_plan_sideways, 0.001) << name;
    EXPECT_LT(stiff.summary.off_plan_tilt, 0.002) << name;
    EXPECT_LT(soft.beside_spring, 0.005) << name;
    EXPECT_LT(soft.summary.off_plan_height, 0.010) << name;
    EXPECT_LT(soft.summary.off_plan_sideways, 0.008) << name;
    EXPECT_LT(soft.summary.off_plan_tilt, 0.035) << name;
  }
}

/// What a push did to a robot that stands.
struct Yielding {
  double most = 0.0;        ///< way of the base [m]
  double at_end = 0.0;      ///< what is left of it [m]
  double beyond = 0.0;      ///< against the push, when it is over [m]
  double slid = 0.0;        ///< way of a foot over the ground, at most [m]
  double peak_force = 0.0;  ///< of any foot [N]
};

Yielding pushed(WholeBodyController controller, const Vector3& force, double seconds) {
  Trial trial(controller);
  Yielding yielding;
  Vector3 before = Vector3::Zero();
  bool begun = false;
  const auto watch = [&](const ActionRecord&, const GroundTruth& truth) {
    if (!begun) {
      trial.world.push(force, seconds);
      before = truth.X_WB.p;
      begun = true;
    }
    const Vector3 way = truth.X_WB.p - before;
    yielding.at_end = way.norm();
    yielding.most = std::max(yielding.most, way.norm());
    yielding.beyond = std::max(yielding.beyond, -way.dot(force.normalized()));
    for (const FootTruth& foot : truth.feet)
      yielding.slid = std::max(yielding.slid, foot.slip_path);
    return true;
  };
  const ActionSummary summary = trial.run(standing(1.1), watch);
  EXPECT_TRUE(summary.ok());
  yielding.peak_force = summary.foot_force_max;
  return yielding;
}

// For half a second: f/(m ω²), 12.8 mm for 100 N, of which a critically damped spring has gone
// 1 − (1 + ω t) exp(−ω t) = 98.6 %; from there back without overshoot, to where it was. A servo
// gives way by less than a millimetre.
TEST(VirtualModel, GivesWayToAPushByTheLawOfItsSpringAndComesBack) {
  for (const Vector3& force :
       {Vector3(100, 0, 0), Vector3(0, 100, 0), Vector3(0, 0, -300), Vector3(0, 0, 200)}) {
    const Yielding soft = pushed(kVirtualModel, force, 0.5);
    EXPECT_NEAR(soft.most, 0.986 * force.norm() / 7812.5, 0.05 * soft.most) << force;
    EXPECT_LT(soft.at_end, 1e-4) << force;
    EXPECT_LT(soft.beyond, 1e-4) << force;
    EXPECT_LT(pushed(kKinematic, force, 0.5).most, 0.001) << force;
  }
}

// A blow of 60 N s from above takes 20 ms. Legs by positions are stiff and hand it on to the feet;
// those that are driven by torques carry no more than springs and damper say, which begin with
// 2 ζ ω 60 N s = 1500 N, a sixth of it for each foot, on top of 82 N: 332 N.
TEST(VirtualModel, SparesTheFeetABlow) {
  const Vector3 blow(0.0, 0.0, -3000.0);
  const Yielding stiff = pushed(kKinematic, blow, 0.02), soft = pushed(kVirtualModel, blow, 0.02);
  EXPECT_NEAR(soft.peak_force, 332.0, 0.1 * 332.0);
  EXPECT_LT(soft.peak_force, 0.65 * stiff.peak_force);
  EXPECT_LT(soft.at_end, 1e-4);
}

// A blow of 30 N s from the side, beyond what friction holds while it lasts: stiff legs slide, and
// the robot stays beside its place. Soft ones give way without sliding.
TEST(VirtualModel, KeepsTheFeetWhereTheyAreUnderABlowFromTheSide) {
  const Vector3 blow(0.0, 1500.0, 0.0);
  const Yielding stiff = pushed(kKinematic, blow, 0.02), soft = pushed(kVirtualModel, blow, 0.02);
  EXPECT_GT(stiff.slid, 0.01);
  EXPECT_GT(stiff.at_end, 0.01);
  EXPECT_LT(soft.slid, 0.001);
  EXPECT_LT(soft.at_end, 1e-4);
}

// Torques that nobody adapts any more would let the robot fall: when it is stopped, in the middle
// of a push-up, the joints hold where they are. Before, they were driven by torques.
TEST(VirtualModel, HoldsByPositionsWhenItIsStopped) {
  Trial trial(kVirtualModel);
  ActionRunner runner(argos(), trial.params);
  Measurement measurement;
  trial.world.read(measurement);
  runner.start(measurement);
  runner.submit(action::load_action(testing::source_path("actions/push_up_six.yaml"), argos()));
  double height = 0.0;
  for (int k = 0; k < 1500; ++k) {
    if (k == 600) {
      EXPECT_EQ(runner.record().desired.targets.mode[1], ControlMode::effort);
      height = trial.world.truth().X_WB.p.z();
      runner.emergency_stop();
    }
    trial.world.write(runner.tick(PlantStatus::fresh, measurement).desired.targets);
    trial.world.read(measurement);
  }
  EXPECT_EQ(runner.record().fault, Fault::emergency_stop);
  EXPECT_NEAR(trial.world.truth().X_WB.p.z(), height, 0.005);
  EXPECT_GT(trial.world.truth().X_WB.R(2, 2), std::cos(0.01));
}

// Lowered onto its belly, the body meets the ground before its plan ends.
TEST(VirtualModel, LiesDownWithoutPressingTheLegsApart) {
  const action::Action action =
      action::load_action(testing::source_path("actions/sit_down.yaml"), argos());
  const ActionSummary stiff = Trial(kKinematic).run(action),
                      soft = Trial(kVirtualModel).run(action);
  EXPECT_TRUE(stiff.ok());
  EXPECT_TRUE(soft.ok());
  EXPECT_LT(soft.foot_force_max, 0.4 * stiff.foot_force_max);
}

}  // namespace
}  // namespace hexagait::walk::virtual_model_test
