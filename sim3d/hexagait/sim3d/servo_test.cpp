// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/world.hpp>
#include <testing/argos.hpp>
#include <testing/round_params.hpp>

// Argos on a test stand, its legs free in the air: closed forms of the joint servos.

namespace hexagait::sim3d::servo_test {
namespace {

const LegArray<LegJoints> kZero(6, LegJoints::Zero());

class ServoOnStand : public ::testing::Test {
 protected:
  ServoOnStand() {
    params_.base_on_stand = true;
    params_.start_clearance = 1.0;
  }

  void hold(World& world, const JointTargets& targets, double seconds) const {
    const double end = world.truth().time + seconds - 0.5 * params_.control_dt;
    while (world.truth().time < end) world.write(targets);
  }

  static LegArray<LegJoints> q_of(World& world) {
    Measurement measurement;
    EXPECT_EQ(world.read(measurement), PlantStatus::fresh);
    return measurement.q;
  }

  // Torque of gravity about joint k of a leg at q, base level: axis · Σ (p_M − p_J) × (−m g z).
  double gravity_torque(LegId leg, int k, const LegJoints& q) const {
    const LegModel& model = robot_.legs[leg];
    const Pose X_BL = link_pose(model, k, q);
    const Pose moved = X_BL * model.links[k].X_BL0.inverse();
    const Vector3 p_J = moved * model.p_BJ0[k], axis = moved.R * model.axis_B0[k];
    double torque = 0.0;
    for (int i = k; i < 3; ++i) {
      const LinkModel& link = model.links[i];
      const Vector3 weight(0.0, 0.0, -link.mass * params_.gravity);
      torque += axis.dot((link_pose(model, i, q) * link.p_LM - p_J).cross(weight));
    }
    return torque;
  }

  RobotModel robot_ = testing::argos();
  WorldParams params_ = hexagait::testing::round_world<WorldParams>();
};

// Legs held straight out: femur 1.2 kg at 0.14 m and tibia with foot 0.8 kg at 0.28 + 0.19475 m
// from the hip-pitch axis press down with 9.81 (1.2 · 0.14 + 0.8 · 0.47475) = 5.374 N m: 1.34 mrad
// at 4000 N m/rad, positive because positive pitch turns the leg down.
TEST_F(ServoOnStand, SagsByGravityTorqueOverStiffness) {
  World world(robot_, {}, params_, kZero);
  hold(world, {kZero, kZero, kZero}, 2.0);
  const LegArray<LegJoints> q = q_of(world);
  EXPECT_NEAR(q[0][1], 5.374 / 4000.0, 1e-7);
  for (LegId leg = 0; leg < 6; ++leg) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(q[leg][k], gravity_torque(leg, k, q[leg]) / params_.servo_kp, 1e-9);
      EXPECT_NEAR(world.efforts()[leg][k], -gravity_torque(leg, k, q[leg]), 1e-5);
    }
  }
}

TEST_F(ServoOnStand, HoldsExactlyWhenItsEffortFeedForwardCarriesTheLeg) {
  const LegArray<LegJoints> q(6, leg_joints({0.3, -0.4, 1.2}));
  LegArray<LegJoints> load(6, LegJoints::Zero());
  for (LegId leg = 0; leg < 6; ++leg) {
    for (int k = 0; k < 3; ++k) load[leg][k] = -gravity_torque(leg, k, q[leg]);
  }
  World world(robot_, {}, params_, q);
  hold(world, {q, kZero, load}, 1.0);
  for (LegId leg = 0; leg < 6; ++leg) EXPECT_NEAR((q_of(world)[leg] - q[leg]).norm(), 0.0, 1e-9);
}

// Each joint turns in its own sense about its own axis: the feet go where the model's kinematics
// says.
TEST_F(ServoOnStand, PutsTheFeetWhereTheKinematicsSays) {
  params_.gravity = 0.0;
  params_.start = {0.7, {3.0, -2.0}};
  RandomSequence random{.seed = 3};
  LegArray<LegJoints> from(6, LegJoints::Zero()), to(6, LegJoints::Zero());
  for (LegId leg = 0; leg < 6; ++leg) {
    from[leg] = leg_joints(
        {random.uniform(-0.9, 0.9), random.uniform(-1.0, 0.5), random.uniform(0.1, 2.0)});
    to[leg] = leg_joints(
        {random.uniform(-0.9, 0.9), random.uniform(-1.0, 0.5), random.uniform(0.1, 2.0)});
  }
  World world(robot_, {}, params_, from);
  const auto feet_are_at = [&](const LegArray<LegJoints>& q) {
    for (LegId leg = 0; leg < 6; ++leg) {
      EXPECT_NEAR((q_of(world)[leg] - q[leg]).norm(), 0.0, 1e-6);
      const Vector3 p_WF = world.truth().X_WB * foot_position(robot_.legs[leg], q[leg]);
      EXPECT_NEAR((world.truth().feet[leg].p_WF - p_WF).norm(), 0.0, 1e-6);
    }
  };
  feet_are_at(from);
  hold(world, {to, kZero, kZero}, 2.0);
  feet_are_at(to);
}

// All of the leg stretched out, turned about the yaw axis by a servo at its limit of 120 N m. With
//     I = Σ (I_zz + m d²) = 0.000839583 + 1 · 0.04² + 0.0080275 + 1.2 · 0.22² + I_tibia + 0.8 ·
//     0.55475²
// the first step of h takes it to q̇ = h τ/I and q = h² τ/I; the hinges give by 2e-5 of that.
// Unlimited it would have been 20 times as much.
TEST_F(ServoOnStand, TurnsNoHarderThanItsEffortLimit) {
  params_.gravity = 0.0;
  World world(robot_, {}, params_, kZero);
  JointTargets targets{kZero, kZero, kZero};
  targets.q[2][0] = 0.9;
  world.write(targets);

  const double tibia = robot_.legs[2].links[2].inertia_M_L(2, 2);
  const double inertia = 0.000839583 + 1.0 * 0.04 * 0.04 + 0.0080275 + 1.2 * 0.22 * 0.22 + tibia +
                         0.8 * 0.55475 * 0.55475;
  EXPECT_NEAR(q_of(world)[2][0], 0.002 * 0.002 * 120.0 / inertia, 1e-7);
  EXPECT_NEAR(world.efforts()[2][0], 120.0, 1e-9);
  EXPECT_NEAR(q_of(world)[3][0], 0.0, 1e-12);
}

// Once it has caught up, a servo follows a target that moves at q̇* without lag: τ vanishes only
// where q = q* and q̇ = q̇*. A target is that of the end of its period, and within it moves on the
// line from the last one, so the control period does not matter. On a straight leg there are no other torques about yaw.
TEST_F(ServoOnStand, FollowsAMovingTargetWithoutLagAtAnyControlPeriod) {
  params_.gravity = 0.0;
  for (const double control_dt : {0.002, 0.02}) {
    params_.control_dt = control_dt;
    World world(robot_, {}, params_, kZero);
    JointTargets targets{kZero, kZero, kZero};
    targets.qd[0][0] = 0.5;
    while (world.truth().time < 1.5 - 0.5 * control_dt) {
      targets.q[0][0] = 0.5 * (world.truth().time + control_dt);
      world.write(targets);
    }
    EXPECT_NEAR(q_of(world)[0][0], 0.75, 1e-6) << control_dt;
  }
}

TEST_F(ServoOnStand, IsNotLedBeyondTheLimitsOfItsJoint) {
  params_.gravity = 0.0;
  World world(robot_, {}, params_, kZero);
  JointTargets targets{kZero, kZero, kZero};
  targets.q[0][0] = 2.0;
  targets.qd[1][0] = -3.0;
  hold(world, targets, 1.0);
  EXPECT_NEAR(q_of(world)[0][0], robot_.legs[0].limits[0].upper, 1e-6);
}

// By velocity q plays no part. Two equal legs with opposite velocities, gravity off: after the
// first moments each turns as fast as it is told to, whatever q says.
TEST_F(ServoOnStand, TurnsAsFastAsItIsToldToByVelocity) {
  params_.gravity = 0.0;
  World world(robot_, {}, params_, kZero);
  JointTargets targets{kZero, kZero, kZero, LegArray<ControlMode>(6, ControlMode::position)};
  targets.mode[0] = targets.mode[3] = ControlMode::velocity;
  targets.q[0] = targets.q[3] = leg_joints({0.5, 0.5, 0.5});
  targets.qd[0] = leg_joints({0.4, 0.0, 0.3});
  targets.qd[3] = leg_joints({-0.4, 0.0, 0.3});
  hold(world, targets, 0.5);
  const LegArray<LegJoints> before = q_of(world);
  hold(world, targets, 0.5);
  const LegArray<LegJoints> after = q_of(world);
  EXPECT_NEAR((after[0][0] - before[0][0]) / 0.5, 0.4, 1e-3);
  EXPECT_NEAR((after[3][0] - before[3][0]) / 0.5, -0.4, 1e-3);
  EXPECT_NEAR((after[0][2] - before[0][2]) / 0.5, 0.3, 1e-3);
  EXPECT_NEAR(after[1].norm(), 0.0, 1e-9) << "by position, at 0";
}

// By effort nothing holds the leg but what it is given. Straight out and weightless, turned about
// the yaw axis by τ for one step of h from rest: q̇ = h τ/(I + h D), q = h q̇ (I: above).
TEST_F(ServoOnStand, TurnsFreelyByEffort) {
  params_.gravity = 0.0;
  World world(robot_, {}, params_, kZero);
  JointTargets targets{kZero, kZero, kZero, LegArray<ControlMode>(6, ControlMode::position)};
  targets.mode[2] = ControlMode::effort;
  targets.q[2][0] = -0.9;  // of no account
  targets.effort[2][0] = 30.0;
  world.write(targets);

  const double tibia = robot_.legs[2].links[2].inertia_M_L(2, 2);
  const double inertia = 0.000839583 + 1.0 * 0.04 * 0.04 + 0.0080275 + 1.2 * 0.22 * 0.22 + tibia +
                         0.8 * 0.55475 * 0.55475;
  const double h = 0.002;
  const double qd = h * 30.0 / (inertia + h * params_.servo_friction);
  EXPECT_NEAR(q_of(world)[2][0], h * qd, 1e-3 * h * qd);
  EXPECT_NEAR(world.efforts()[2][0], 30.0 - params_.servo_friction * qd, 1e-3);
}

// A leg whose weight is carried by its efforts floats: it stays where it is put, and nothing else
// holds it. With 1 N m less at the hip it sinks.
TEST_F(ServoOnStand, FloatsByEffortWhereItsLoadIsFedForward) {
  const LegArray<LegJoints> q(6, leg_joints({0.3, -0.4, 1.2}));
  JointTargets targets{kZero, kZero, kZero, LegArray<ControlMode>(6, ControlMode::effort)};
  for (LegId leg = 0; leg < 6; ++leg)
    for (int k = 0; k < 3; ++k) targets.effort[leg][k] = -gravity_torque(leg, k, q[leg]);
  targets.effort[5][1] += 1.0;  // positive pitch turns the leg down
  World world(robot_, {}, params_, q);
  hold(world, targets, 0.2);
  EXPECT_NEAR((q_of(world)[0] - q[0]).norm(), 0.0, 1e-4);
  EXPECT_GT(q_of(world)[5][1], q[5][1] + 0.01);
}

// Neither mode has a position to clamp: the stop must hold.
TEST_F(ServoOnStand, StopsAtItsLimitsInEveryMode) {
  for (const ControlMode mode : {ControlMode::velocity, ControlMode::effort}) {
    World world(robot_, {}, params_, kZero);
    JointTargets targets{kZero, kZero, kZero, LegArray<ControlMode>(6, mode)};
    for (LegId leg = 0; leg < 6; ++leg) {
      const double way = leg % 2 == 0 ? 1.0 : -1.0;
      targets.qd[leg] = LegJoints::Constant(2.0 * way);
      targets.effort[leg] = LegJoints::Constant(50.0 * way);
    }
    hold(world, targets, 3.0);
    for (LegId leg = 0; leg < 6; ++leg) {
      for (int k = 0; k < 3; ++k) {
        const JointLimits& limits = robot_.legs[leg].limits[k];
        const double stop = leg % 2 == 0 ? limits.upper : limits.lower;
        EXPECT_NEAR(q_of(world)[leg][k], stop, 0.05) << leg << " " << k;
      }
    }
  }
}

// A leg that was led by effort is caught where its position servo is told to.
TEST_F(ServoOnStand, GoesBackToPositionsWhenItIsToldTo) {
  World world(robot_, {}, params_, kZero);
  JointTargets targets{kZero, kZero, kZero, LegArray<ControlMode>(6, ControlMode::effort)};
  hold(world, targets, 0.1);
  targets.mode = LegArray<ControlMode>(6, ControlMode::position);
  hold(world, targets, 2.0);
  World other(robot_, {}, params_, kZero);
  hold(other, {kZero, kZero, kZero}, 2.0);
  for (LegId leg = 0; leg < 6; ++leg)
    EXPECT_NEAR((q_of(world)[leg] - q_of(other)[leg]).norm(), 0.0, 1e-6);
}

}  // namespace
}  // namespace hexagait::sim3d::servo_test
