// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/core/load_sharing.hpp>
#include <hexagait/core/random.hpp>
#include <hexagait/core/whole_body.hpp>

namespace hexagait {
namespace {

constexpr double kGravity = 9.81;

const RobotModel& argos() {
  static const RobotModel model = load_urdf(HEXAGAIT_SOURCE_DIR "/robots/argos.urdf");
  return model;
}

/// All feet at their nominal places, all carrying, nothing amiss.
WholeBodyInput standing() {
  WholeBodyInput input{LegArray<Vector3>(6),
                       LegArray<LegTrig>(6),
                       LegArray<double>(6, 1.0),
                       Vector3::UnitZ(),
                       LegArray<Vector3>(6, Vector3::UnitZ()),
                       {}};
  for (LegId i = 0; i < 6; ++i) {
    input.p_BF[i] = argos().legs[i].p_BC;
    input.trig[i] = inverse_kinematics(argos().legs[i], input.p_BF[i]).trig;
  }
  return input;
}

LegArray<LegJoints> efforts(WholeBodyController controller, const WholeBodyInput& input) {
  return joint_efforts(controller, argos(), input, kGravity, {});
}

/// What the feet do to the ground, from the efforts: F = −J⁻ᵀ τ is the ground on the robot.
Wrench wrench_of(const WholeBodyInput& input, const LegArray<LegJoints>& effort) {
  Wrench sum;
  for (LegId i = 0; i < 6; ++i) {
    const Matrix3 J = foot_jacobian(argos().legs[i], input.trig[i]).leftCols<3>();
    const Vector3 force = -J.transpose().inverse() * effort[i].head<3>();
    sum.force += force;
    sum.moment += input.p_BF[i].cross(force);
  }
  return sum;
}

TEST(WholeBody, CarriesTheWeightWithEitherController) {
  const WholeBodyInput input = standing();
  for (const auto controller :
       {WholeBodyController::kinematic, WholeBodyController::virtual_model}) {
    const Wrench wrench = wrench_of(input, efforts(controller, input));
    EXPECT_LT((wrench.force - Vector3(0, 0, 50.0 * kGravity)).norm(), 0.01);
    EXPECT_LT(wrench.moment.norm(), 0.01);
  }
}

// To the bit: shared_load() along `up_B`, through the Jacobian of the joint targets.
TEST(WholeBody, FeedsForwardSharedLoadsIfKinematic) {
  WholeBodyInput input = standing();
  input.load[1] = 0.3;
  input.load[4] = 0.0;
  input.up_B = rotation({0.1, -0.2, 0.3}).row(2);
  const LegArray<double> force =
      shared_load(input.p_BF, argos().p_BM, input.load, argos().mass * kGravity);
  const LegArray<LegJoints> effort = efforts(WholeBodyController::kinematic, input);
  for (LegId i = 0; i < 6; ++i) {
    const LegJacobian J = foot_jacobian(argos().legs[i], input.trig[i]);
    const LegJoints expected = J.transpose() * (-force[i] * input.up_B);
    EXPECT_EQ(effort[i], i == 4 ? LegJoints(LegJoints::Zero()) : expected);
  }
}

// A base 1 cm too low, 5 mm too far left, turned by 0.02 rad: k e and k' θ on top of the weight.
TEST(WholeBody, PushesTheBaseBackLikeASpring) {
  WholeBodyInput input = standing();
  const Pose X_OB{rotation({0.0, 0.02, 0.0}), {1.0, 0.005, 0.29}};
  const Pose X_OD{Matrix3::Identity(), {1.0, 0.0, 0.30}};
  input.error = base_error(X_OB, {}, X_OD, {});
  input.up_B = X_OB.R.row(2);
  const VirtualModelParams gains;
  const Wrench wrench = wrench_of(input, efforts(WholeBodyController::virtual_model, input));
  const Vector3 force_O = X_OB.R * wrench.force;
  EXPECT_NEAR(force_O.z(), 50.0 * kGravity + gains.stiffness * 0.01, 0.02);
  EXPECT_NEAR(force_O.y(), -gains.stiffness * 0.005, 0.02);
  EXPECT_NEAR(wrench.moment.y(), -gains.turn_stiffness * 0.02, 0.2);
}

// Too slow upwards by 0.1 m/s, too fast about z by 0.2 rad/s.
TEST(WholeBody, DampsTheMotionOfTheBase) {
  WholeBodyInput input = standing();
  const Twist actual{{0.0, 0.0, -0.1}, {0.0, 0.0, 0.2}};
  input.error = base_error({}, actual, {}, {});
  const VirtualModelParams gains;
  const Wrench wrench = wrench_of(input, efforts(WholeBodyController::virtual_model, input));
  EXPECT_NEAR(wrench.force.z(), 50.0 * kGravity + gains.damping * 0.1, 0.02);
  EXPECT_NEAR(wrench.moment.z(), -gains.turn_damping * 0.2, 0.02);
}

// D to the left of a base that looks along y: ahead of it. D's twist along its own x, D looking
// along x as well: to the right of the base.
TEST(WholeBody, SeesTheErrorInTheAxesOfTheBase) {
  const Pose X_OB{rotation_z(0.5 * std::numbers::pi), {1.0, 1.0, 0.0}};
  const Pose X_OD{Matrix3::Identity(), {1.0, 1.5, 0.0}};
  const BaseError error = base_error(X_OB, {}, X_OD, {{0.2, 0.0, 0.0}, Vector3::Zero()});
  EXPECT_LT((error.p_B - Vector3(0.5, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_LT((error.turn_B - Vector3(0.0, 0.0, -0.5 * std::numbers::pi)).norm(), 1e-12);
  EXPECT_LT((error.V_B.v - Vector3(0.0, -0.2, 0.0)).norm(), 1e-12);
}

// Legs are unloaded in steps of ε: the largest change of an effort halves with ε. No force changes
// by more than twice the weight over the ramp, and no arm is longer than 0.6 m.
TEST(WholeBody, ChangesEffortsWithoutAJumpAsLegsAreUnloaded) {
  for (const auto controller :
       {WholeBodyController::kinematic, WholeBodyController::virtual_model}) {
    for (const int steps : {50, 500}) {
      WholeBodyInput input = standing();
      input.error.p_B = {0.01, 0.0, 0.005};
      LegArray<LegJoints> before = efforts(controller, input);
      for (int k = steps - 1; k >= 0; --k) {
        input.load[0] = input.load[3] = input.load[4] = static_cast<double>(k) / steps;
        const LegArray<LegJoints> now = efforts(controller, input);
        for (LegId i = 0; i < 6; ++i)
          ASSERT_LT((now[i] - before[i]).norm(), 2.0 * 490.5 * 0.6 / steps) << k;
        before = now;
      }
      EXPECT_EQ(before[0].norm() + before[3].norm() + before[4].norm(), 0.0);
    }
  }
}

TEST(WholeBody, IsFiniteWhateverTheErrorIs) {
  RandomSequence random{.seed = 1};
  for (int trial = 0; trial < 300; ++trial) {
    WholeBodyInput input = standing();
    for (double& x : input.error.p_B) x = random.uniform(-1, 1) * std::pow(10.0, 9 * random.u01());
    for (double& load : input.load) load = random.u01() < 0.3 ? 0.0 : random.u01();
    for (const LegJoints& effort : efforts(WholeBodyController::virtual_model, input))
      ASSERT_TRUE(effort.allFinite());
  }
}

}  // namespace
}  // namespace hexagait
