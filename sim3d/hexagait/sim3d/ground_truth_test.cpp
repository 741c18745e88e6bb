// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/world.hpp>
#include <testing/argos.hpp>
#include <testing/round_params.hpp>

namespace hexagait::sim3d::ground_truth_test {
namespace {

const LegArray<LegJoints> kZero(6, LegJoints::Zero());

class Referee : public ::testing::Test {
 protected:
  // Joint positions with every foot at its workspace centre, moved by `shift` [m].
  LegArray<LegJoints> stance(const Vector3& shift = Vector3::Zero()) const {
    LegArray<LegJoints> q = kZero;
    for (LegId leg = 0; leg < 6; ++leg) {
      q[leg] = inverse_kinematics(robot_.legs[leg], robot_.legs[leg].p_BC + shift).q;
    }
    return q;
  }

  // Moves the targets evenly from one set of joint positions to another.
  void move(World& world, const LegArray<LegJoints>& from, const LegArray<LegJoints>& to,
            double seconds) const {
    const double begin = world.truth().time;
    JointTargets targets{from, kZero, kZero};
    for (LegId leg = 0; leg < 6; ++leg) targets.qd[leg] = (to[leg] - from[leg]) / seconds;
    while (world.truth().time < begin + seconds - 1e-9) {
      const double t = world.truth().time - begin;
      for (LegId leg = 0; leg < 6; ++leg) targets.q[leg] = from[leg] + t * targets.qd[leg];
      world.write(targets);
    }
  }

  RobotModel robot_ = testing::argos();
  WorldParams params_ = hexagait::testing::round_world<WorldParams>();
};

// A leg of a robot on a stand presses its foot on the ground and turns about its yaw axis by ψ: the
// contact point, straight below the foot's centre, drags along an arc of radius R and length R ψ.
TEST_F(Referee, MeasuresTheSlipOfADraggedFootAsTheArcItDraws) {
  params_.base_on_stand = true;
  params_.friction = 0.3;
  params_.start_clearance = 0.01;
  World world(robot_, {}, params_, stance());
  LegArray<LegJoints> pressing = stance();
  pressing[2] = inverse_kinematics(robot_.legs[2], robot_.legs[2].p_BC - Vector3(0, 0, 0.011)).q;
  move(world, stance(), pressing, 0.2);
  LegArray<LegJoints> turned = pressing;
  turned[2] = pressing[2] + 0.5 * LegJoints::Unit(0);

  // From when it slides to when it is turned round, by the angle that the joint really makes.
  LegArray<LegJoints> begun = pressing;
  begun[2][0] += 0.1;
  move(world, pressing, begun, 0.2);
  Measurement before, after;
  world.read(before);
  const FootTruth start = world.truth().feet[2];
  move(world, begun, turned, 0.8);
  world.read(after);
  const FootTruth end = world.truth().feet[2];

  const double psi = after.q[2][0] - before.q[2][0];
  const double radius = (end.p_WF - world.truth().X_WB * robot_.legs[2].p_BJ0[0]).head<2>().norm();
  EXPECT_GT(psi, 0.39);
  EXPECT_TRUE(end.in_contact);
  EXPECT_NEAR(end.slip_path - start.slip_path, radius * psi, 1e-3 * radius * psi);
  EXPECT_NEAR(end.slip_speed, radius * 0.5, 0.01 * radius * 0.5);

  // As a vector it is the chord, from where the foot was to where it is.
  EXPECT_NEAR((end.slip - start.slip - (end.p_WF - start.p_WF)).norm(), 0.0, 1e-3 * radius * psi);

  // And the other way round it adds to the path, but takes back the vector.
  move(world, turned, begun, 0.8);
  const FootTruth back = world.truth().feet[2];
  EXPECT_NEAR(back.slip_path - start.slip_path, 2.0 * radius * psi, 0.05 * radius * psi);
  EXPECT_LT((back.slip - start.slip).norm(), 0.05 * radius * psi);
  EXPECT_EQ(world.truth().feet[3].slip_path, 0.0);
}

// The body moves 8 cm forward over standing feet, whose tibias tilt. A ball of radius r that rolls
// moves its centre by dw × r z while it turns by dw. Led so, the feet's centres move by up to 2 mm
// while the material at the contact stays where it is, but for the little that the servos give.
TEST_F(Referee, CountsRollingAsNoSlip) {
  constexpr int kSteps = 500;
  World world(robot_, {}, params_, stance());
  move(world, stance(), stance(), 0.5);
  const LegArray<FootTruth> start = world.truth().feet;
  LegArray<LegJoints> q = stance();
  LegArray<Vector3> p_BF(6, Vector3::Zero());
  for (LegId leg = 0; leg < 6; ++leg) p_BF[leg] = robot_.legs[leg].p_BC;

  for (int k = 0; k < kSteps; ++k) {
    LegArray<LegJoints> next = q;
    for (LegId leg = 0; leg < 6; ++leg) {
      const LegModel& model = robot_.legs[leg];
      p_BF[leg].x() -= 0.08 / kSteps;
      const LegJoints dq = inverse_kinematics(model, p_BF[leg]).q - q[leg];
      const Vector3 turn = tibia_turn(model, leg_trig(model, q[leg]), dq);
      p_BF[leg] += turn.cross(robot_.foot_radius * Vector3::UnitZ());
      next[leg] = inverse_kinematics(model, p_BF[leg]).q;
    }
    move(world, q, next, params_.control_dt);
    q = next;
  }
  for (LegId leg = 0; leg < 6; ++leg) {
    const FootTruth& foot = world.truth().feet[leg];
    const double rolled = (foot.p_WF - start[leg].p_WF).norm();
    EXPECT_GT(rolled, 4e-4);
    EXPECT_LT(foot.slip_path - start[leg].slip_path, 0.05 * rolled);
  }
}

// Soft ground: at 82 N per foot, h · cfm/erp · F = 5.5 mm (see WorldParams). The feet go straight
// down.
TEST_F(Referee, CountsSinkingAsNoSlip) {
  params_.contact_cfm = 0.01;
  World world(robot_, {}, params_, stance());
  move(world, stance(), stance(), 0.5);
  for (const FootTruth& foot : world.truth().feet) {
    EXPECT_GT(robot_.foot_radius - foot.p_WF.z(), 4e-3);
    EXPECT_LT(foot.slip_path, 4e-4);
  }
}

TEST_F(Referee, LosesNothingBetweenTwoControlPeriods) {
  WorldParams slow = params_;
  slow.control_dt = 0.05;
  slow.start_clearance = params_.start_clearance = 0.02;
  slow.friction = params_.friction = 0.1;
  const JointTargets targets{stance({0.0, 0.02, 0.0}), kZero, kZero};
  World fine(robot_, {}, params_, stance()), coarse(robot_, {}, slow, stance());
  for (int k = 0; k < 10; ++k) coarse.write(targets);
  for (int k = 0; k < 250; ++k) fine.write(targets);
  for (LegId leg = 0; leg < 6; ++leg) {
    EXPECT_GT(fine.truth().feet[leg].slip_path, 0.0);
    EXPECT_EQ(fine.truth().feet[leg].slip_path, coarse.truth().feet[leg].slip_path);
    EXPECT_EQ(fine.truth().feet[leg].slip, coarse.truth().feet[leg].slip);
  }
  EXPECT_EQ(fine.truth().X_WB.p, coarse.truth().X_WB.p);
}

// The velocity of the base integrates to its motion: X₊ ≈ X (rotation(h w), h v). It is that of the
// base's origin, wherever the base's centre of mass is.
TEST_F(Referee, GivesTheVelocityOfTheBaseInTheBase) {
  robot_.base.p_LM = {0.1, 0.05, 0.15};
  params_.start = {1.0, {0.2, -0.1}};
  World world(robot_, {}, params_, stance());
  const JointTargets targets{stance({-0.1, 0.05, 0.03}), kZero, kZero};
  double fastest = 0.0;
  for (int k = 0; k < 50; ++k) {
    const Pose before = world.truth().X_WB;
    world.write(targets);
    const Pose moved = before.inverse() * world.truth().X_WB;
    const Twist& V = world.truth().V_WB;
    EXPECT_NEAR((moved.p / 0.002 - V.v).norm(), 0.0, 0.01 * (V.v.norm() + 0.01));
    EXPECT_NEAR((rotation_vector(moved.R) / 0.002 - V.w).norm(), 0.0, 0.01 * (V.w.norm() + 0.01));
    fastest = std::max(fastest, V.v.norm());
  }
  EXPECT_GT(fastest, 0.3);
}

// With one physics step a control period: the sum of |τ Δq| over steps and joints, and no more while
// nothing moves.
TEST_F(Referee, AddsUpTheWorkOfTheJointsWhetherTheyDriveOrBrake) {
  params_.base_on_stand = true;
  params_.physics_dt = params_.control_dt;
  World world(robot_, {}, params_, stance());
  const LegArray<LegJoints> lifted = stance(Vector3(0.0, 0.0, 0.08));
  double work = 0.0;
  Measurement before, after;
  for (const auto& target : {lifted, stance()})
    for (int k = 0; k < 200; ++k) {
      static_cast<void>(world.read(before));
      world.write({target, kZero, kZero});
      static_cast<void>(world.read(after));
      for (LegId leg = 0; leg < 6; ++leg)
        work += world.efforts()[leg].cwiseProduct(after.q[leg] - before.q[leg]).cwiseAbs().sum();
    }
  EXPECT_GT(work, 1.0);
  EXPECT_NEAR(world.truth().work, work, 1e-9 * work);
}

}  // namespace
}  // namespace hexagait::sim3d::ground_truth_test
