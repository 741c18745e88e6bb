// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/balance/load_sharing.hpp>
#include <hexagait/balance/whole_body.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait {
namespace {

constexpr double kGravity = 9.81;
constexpr auto kKinematic = WholeBodyController::kinematic;
constexpr VirtualModelParams kSprings{.frequency = 12.5, .turn_frequency = 12.5};
constexpr auto kVirtualModel = WholeBodyController::virtual_model;

using testing::argos;

/// All feet at their nominal places, all carrying, nothing amiss.
struct Standing {
  LegArray<LegJoints> q{6};
  LegArray<LegTrig> trig{6};
  WholeBodyInput input{q,
                       trig,
                       LegArray<Vector3>(6),
                       LegArray<double>(6, 1.0),
                       Matrix3::Identity(),
                       argos().p_BM,
                       LegArray<Vector3>(6, Vector3::UnitZ()),
                       {}};

  Standing() {
    for (LegId i = 0; i < 6; ++i) put(i, argos().legs[i].p_BC);
  }
  Standing(const Standing&) = delete;

  void put(LegId leg, const Vector3& p_BF) {
    const LegSolution joints = inverse_kinematics(argos().legs[leg], p_BF);
    input.p_BF[leg] = p_BF;
    q[leg] = joints.q;
    trig[leg] = joints.trig;
  }
};

LegArray<LegJoints> efforts(WholeBodyController controller, const WholeBodyInput& input) {
  return joint_efforts(controller, argos(), input, kGravity, kSprings).effort;
}

/// What the feet do to the ground, from the efforts: F = −J⁻ᵀ τ is the ground on the robot. In the
/// virtual model the joints hold the legs besides.
Wrench wrench_of(WholeBodyController controller, const WholeBodyInput& input) {
  const LegArray<LegJoints> effort = efforts(controller, input);
  Wrench sum;
  for (LegId i = 0; i < 6; ++i) {
    const LegModel& leg = argos().legs[i];
    LegJoints press = effort[i];
    if (controller == kVirtualModel)
      press -= leg_weight(leg, input.q[i], kGravity * input.up_B()).effort;
    const Matrix3 J = foot_jacobian(leg, input.trig[i]).leftCols<3>();
    const Vector3 force = -J.transpose().inverse() * press.head<3>();
    sum.force += force;
    sum.moment += input.p_BF[i].cross(force);
  }
  return sum;
}

TEST(WholeBody, CarriesTheWeightWithEitherController) {
  const Standing standing;
  const WholeBodyInput& input = standing.input;
  for (const auto controller : {kKinematic, kVirtualModel}) {
    const Wrench wrench = wrench_of(controller, input);
    EXPECT_LT((wrench.force - Vector3(0, 0, 50.0 * kGravity)).norm(), 0.01);
    EXPECT_LT(wrench.moment.norm(), 0.01);
  }
}

// Its centre of mass, 0.3 m above the feet, is then 8 cm beside where it is over them on level ground.
TEST(WholeBody, BalancesTheWeightOfATiltedBody) {
  Standing standing;
  WholeBodyInput& input = standing.input;
  input.R_OB = rotation({0.2, -0.15, 0.3});
  for (const auto controller : {kKinematic, kVirtualModel}) {
    const Wrench wrench = wrench_of(controller, input);
    EXPECT_LT((wrench.force - 50.0 * kGravity * input.up_B()).norm(), 0.01);
    EXPECT_LT((wrench.moment - argos().p_BM.cross(wrench.force)).norm(), 0.01);
  }
}

// shared_load() as gravity sees the feet, through the Jacobian of the joint targets.
TEST(WholeBody, FeedsForwardSharedLoadsIfKinematic) {
  Standing standing;
  WholeBodyInput& input = standing.input;
  input.load[1] = 0.3;
  input.load[4] = 0.0;
  input.R_OB = rotation({0.1, -0.2, 0.3});
  LegArray<Vector3> p_F_O(6);
  for (LegId i = 0; i < 6; ++i) p_F_O[i] = input.R_OB * input.p_BF[i];
  const LegArray<double> force =
      shared_load(p_F_O, input.R_OB * argos().p_BM, input.load, argos().mass * kGravity);
  const LegArray<LegJoints> effort = efforts(kKinematic, input);
  for (LegId i = 0; i < 6; ++i) {
    const LegJacobian J = foot_jacobian(argos().legs[i], input.trig[i]);
    const LegJoints expected = J.transpose() * (-force[i] * input.up_B());
    EXPECT_LT((effort[i] - (i == 4 ? LegJoints(LegJoints::Zero()) : expected)).norm(), 1e-12) << i;
  }
}

// A base 1 cm too low, 5 mm too far left, turned by 0.02 rad: m ω² e and I ω² θ on top of the
// weight, which is 50 · 12.5² = 7812.5 N/m, and by I_yy = 3.38 kg m² (sum of the URDF) 528 N m/rad.
TEST(WholeBody, PushesTheBaseBackLikeASpring) {
  Standing standing;
  WholeBodyInput& input = standing.input;
  const Pose X_OB{rotation({0.0, 0.02, 0.0}), {1.0, 0.005, 0.29}};
  const Pose X_OD{Matrix3::Identity(), {1.0, 0.0, 0.30}};
  input.error = base_error(X_OB, {}, X_OD, {});
  input.R_OB = X_OB.R;
  const Wrench wrench = wrench_of(kVirtualModel, input);
  const Vector3 force_O = X_OB.R * wrench.force;
  EXPECT_NEAR(force_O.z(), 50.0 * kGravity + 7812.5 * 0.01, 0.1);
  EXPECT_NEAR(force_O.y(), -7812.5 * 0.005, 0.1);
  const Vector3 spring = -156.25 * argos().inertia_M_B.col(1) * 0.02;
  EXPECT_LT((wrench.moment - argos().p_BM.cross(wrench.force) - spring).norm(), 0.1);
}

// Too slow upwards by 0.1 m/s, too fast about z by 0.2 rad/s: 2 ζ m ω = 2 · 50 · 12.5 = 1250 N s/m.
TEST(WholeBody, DampsTheMotionOfTheBase) {
  Standing standing;
  WholeBodyInput& input = standing.input;
  const Twist actual{{0.0, 0.0, -0.1}, {0.0, 0.0, 0.2}};
  input.error = base_error({}, actual, {}, {});
  const Wrench wrench = wrench_of(kVirtualModel, input);
  EXPECT_NEAR(wrench.force.z(), 50.0 * kGravity + 1250.0 * 0.1, 0.02);
  EXPECT_NEAR(wrench.moment.z(), -25.0 * argos().inertia_M_B(2, 2) * 0.2, 0.02);
}

// A rigid body with the mass and the inertia of the robot, let go beside its place and turned: it
// comes back as every critically damped spring does, e₀ (1 + ω t) exp(−ω t), whatever its mass. The
// semi-implicit integration is off by ω dt ~ 1e-3 of e₀.
TEST(WholeBody, BringsAnyRobotBackInTheSameTime) {
  const RobotModel quadruped = load_urdf(testing::source_path("robots/quadruped.urdf"));
  RandomSequence random{.seed = 3};
  for (const RobotModel* robot : {&argos(), &quadruped}) {
    VirtualModelParams params;
    params.frequency = random.uniform(5.0, 20.0);
    params.turn_frequency = random.uniform(5.0, 20.0);
    Standing standing;
    WholeBodyInput& input = standing.input;
    input.error.p_B = {0.01, -0.02, 0.03};
    input.error.turn_B = {0.01, 0.02, -0.01};
    const Vector3 p0 = input.error.p_B, turn0 = input.error.turn_B;
    constexpr double kStep = 1e-4;
    const int steps = 2000;
    for (int k = 0; k < steps; ++k) {
      const Wrench wrench = virtual_model_wrench(*robot, Vector3::Zero(), input, kGravity, params);
      const Vector3 gravity = -robot->mass * kGravity * Vector3::UnitZ();
      input.error.V_B.v -= kStep * (wrench.force + gravity) / robot->mass;
      input.error.V_B.w -= kStep * robot->inertia_M_B.inverse() * wrench.moment;
      input.error.p_B += kStep * input.error.V_B.v;
      input.error.turn_B += kStep * input.error.V_B.w;
    }
    const auto left = [](double w) { return (1.0 + 0.2 * w) * std::exp(-0.2 * w); };
    EXPECT_LT((input.error.p_B - left(params.frequency) * p0).norm(), 3e-3 * p0.norm());
    EXPECT_LT((input.error.turn_B - left(params.turn_frequency) * turn0).norm(),
              3e-3 * turn0.norm());
  }
}

// About another point than the centre of mass, the same motion takes the moment of the force, and
// the error of that point is not that of the centre: p × F, and e + θ × p.
TEST(WholeBody, ActsAtTheCentreOfMass) {
  const Vector3 p_BM(0.1, -0.05, 0.02);
  Standing standing;
  WholeBodyInput& input = standing.input;
  input.error.p_B = {0.01, 0.0, 0.0};
  input.error.turn_B = {0.0, 0.0, 0.1};
  const Wrench wrench = virtual_model_wrench(argos(), p_BM, input, 0.0, kSprings);
  const Vector3 force = 7812.5 * Vector3(0.01 + 0.1 * 0.05, 0.1 * 0.1, 0.0);
  EXPECT_LT((wrench.force - force).norm(), 1e-9);
  const Vector3 turning = 156.25 * 0.1 * argos().inertia_M_B.col(2);
  EXPECT_LT((wrench.moment - turning - p_BM.cross(force)).norm(), 1e-9);
}

// A leg in the air swings out by 0.2 m: the centre of mass goes along, and the others carry it
// there.
TEST(WholeBody, CarriesTheCentreOfMassWhereTheLegsPutIt) {
  Standing standing;
  WholeBodyInput& input = standing.input;
  input.load[0] = 0.0;
  standing.put(0, input.p_BF[0] + Vector3(0.1, 0.15, 0.1));
  Vector3 moment_B = argos().base.mass * argos().base.p_LM;
  for (LegId i = 0; i < 6; ++i)
    for (int k = 0; k < argos().legs[i].num_joints(); ++k) {
      const LinkModel& link = argos().legs[i].links[k];
      moment_B += link.mass * (link_pose(argos().legs[i], k, input.q[i]) * link.p_LM);
    }
  const Vector3 expected = moment_B.cross(kGravity * Vector3::UnitZ());
  EXPECT_GT(expected.norm(), 0.5);
  EXPECT_LT((wrench_of(kVirtualModel, input).moment - expected).norm(), 0.02);
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
  for (const auto controller : {kKinematic, kVirtualModel}) {
    for (const int steps : {50, 500}) {
      Standing standing;
      WholeBodyInput& input = standing.input;
      input.error.p_B = {0.01, 0.0, 0.005};
      LegArray<LegJoints> before = efforts(controller, input);
      for (int k = steps - 1; k >= 0; --k) {
        input.load[0] = input.load[3] = input.load[4] = static_cast<double>(k) / steps;
        const LegArray<LegJoints> now = efforts(controller, input);
        for (LegId i = 0; i < 6; ++i)
          ASSERT_LT((now[i] - before[i]).norm(), 2.0 * 490.5 * 0.6 / steps) << k;
        before = now;
      }
      for (const LegId i : {0, 3, 4}) {
        const bool holds_itself = controller == kVirtualModel;
        const LegWeight weight =
            leg_weight(argos().legs[i], input.q[i], kGravity * Vector3::UnitZ());
        EXPECT_EQ(before[i], holds_itself ? weight.effort : LegJoints(LegJoints::Zero()));
      }
    }
  }
}

TEST(WholeBody, IsFiniteWhateverTheErrorIs) {
  RandomSequence random{.seed = 1};
  for (int trial = 0; trial < 300; ++trial) {
    Standing standing;
    WholeBodyInput& input = standing.input;
    for (double& x : input.error.p_B) x = random.uniform(-1, 1) * std::pow(10.0, 9 * random.u01());
    for (double& load : input.load) load = random.u01() < 0.3 ? 0.0 : random.u01();
    for (const LegJoints& effort : efforts(kVirtualModel, input)) ASSERT_TRUE(effort.allFinite());
  }
}

}  // namespace
}  // namespace hexagait
