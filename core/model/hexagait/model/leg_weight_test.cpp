// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait {
namespace {

const RobotModel& robot(const std::string& name) {
  static const RobotModel quadruped = load_urdf(testing::source_path("robots/quadruped.urdf"));
  return name == "argos" ? testing::argos() : quadruped;
}

// Σ m p of a leg's links, by link_pose().
Vector3 moment(const LegModel& leg, const LegJoints& q) {
  Vector3 sum = Vector3::Zero();
  for (int i = 0; i < static_cast<int>(leg.links.size()); ++i) {
    const LinkModel& link = leg.links[i];
    sum += link.mass * (link_pose(leg, i, q) * link.p_LM);
  }
  return sum;
}

// Leg held straight out: femur 1.2 kg at 0.14 m and tibia with foot 0.8 kg at 0.28 + 0.19475 m from
// the hip-pitch axis. To hold 9.81 (1.2 · 0.14 + 0.8 · 0.47475) = 5.374 N m up takes as much, minus
// because positive pitch turns the leg down; the knee 9.81 · 0.8 · 0.19475 = 1.528 N m; yaw
// nothing.
TEST(LegWeight, HoldsAStraightLegOut) {
  const LegWeight weight =
      leg_weight(robot("argos").legs[0], LegJoints::Zero(), 9.81 * Vector3::UnitZ());
  EXPECT_NEAR(weight.effort[0], 0.0, 1e-12);
  EXPECT_NEAR(weight.effort[1], -5.374, 1e-3);
  EXPECT_NEAR(weight.effort[2], -1.528, 1e-3);
}

// Held by its efforts, a leg's potential energy U = Σ m g up · p is stationary: τ = ∂U/∂q, by
// differences of the links' poses. The error of central differences is below 1e-8 here.
TEST(LegWeight, IsTheGradientOfThePotentialEnergy) {
  RandomSequence random{.seed = 1};
  for (const char* name : {"argos", "quadruped"}) {
    for (int trial = 0; trial < 200; ++trial) {
      const LegModel& leg = robot(name).legs[trial % 4];
      LegJoints q = LegJoints::Zero();
      for (int k = 0; k < leg.num_joints(); ++k) q[k] = random.uniform(-1.5, 1.5);
      const Vector3 g_up =
          9.81 * rotation({random.uniform(-1, 1), random.uniform(-1, 1), 0.0}).row(2).transpose();
      const LegWeight weight = leg_weight(leg, q, g_up);
      EXPECT_LT((weight.moment_B - moment(leg, q)).norm(), 1e-12);
      for (Eigen::Index k = 0; k < q.size(); ++k) {
        LegJoints more = q, less = q;
        more[k] += 1e-5;
        less[k] -= 1e-5;
        const double slope = g_up.dot(moment(leg, more) - moment(leg, less)) / 2e-5;
        EXPECT_NEAR(weight.effort[k], slope, 1e-7);
      }
    }
  }
}

// The efforts that hold the legs are the gradient of the whole robot's potential energy too: by the axes of the joints
// on one side, by the places of the links on the other.
TEST(CentreOfMass, MovesWithTheLegs) {
  RandomSequence random{.seed = 3};
  const RobotModel& model = robot("argos");
  LegArray<LegJoints> q(6, LegJoints::Zero());
  for (LegId i = 0; i < 6; ++i) q[i] = inverse_kinematics(model.legs[i], model.legs[i].p_BC).q;
  EXPECT_LT((centre_of_mass(model, q) - model.p_BM).norm(), 1e-12) << "in the nominal stance";
  for (int trial = 0; trial < 20; ++trial) {
    const Vector3 up(random.uniform(-1, 1), random.uniform(-1, 1), 1.0);
    for (LegJoints& leg : q)
      for (double& joint : leg) joint = random.uniform(-1.5, 1.5);
    for (LegId i = 0; i < 6; ++i) {
      const LegJoints effort = leg_weight(model.legs[i], q[i], up).effort;
      for (Eigen::Index k = 0; k < effort.size(); ++k) {
        LegArray<LegJoints> more = q, less = q;
        more[i][k] += 1e-5;
        less[i][k] -= 1e-5;
        const Vector3 way = centre_of_mass(model, more) - centre_of_mass(model, less);
        EXPECT_NEAR(model.mass * up.dot(way) / 2e-5, effort[k], 1e-7);
      }
    }
  }
}

// The kinetic energy of a robot that turns as one rigid thing about its centre of mass, ½ wᵀ I w,
// summed over its links: ½ m |w × arm|² + ½ wᵀ I_L w. And the robot is as symmetric as it looks.
TEST(NominalInertia, GivesTheKineticEnergyOfTurning) {
  RandomSequence random{.seed = 2};
  for (const char* name : {"argos", "quadruped"}) {
    const RobotModel& model = robot(name);
    for (int trial = 0; trial < 20; ++trial) {
      const Vector3 w(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const auto energy = [&](const LinkModel& link, const Pose& X_BL) {
        const Vector3 w_L = X_BL.R.transpose() * w;
        const double speed = w.cross(X_BL * link.p_LM - model.p_BM).norm();
        return 0.5 * (link.mass * speed * speed + w_L.dot(link.inertia_M_L * w_L));
      };
      double sum = energy(model.base, {});
      for (const LegModel& leg : model.legs) {
        const LegJoints q = inverse_kinematics(leg, leg.p_BC).q;
        for (int i = 0; i < leg.num_joints(); ++i)
          sum += energy(leg.links[i], link_pose(leg, i, q));
      }
      EXPECT_NEAR(0.5 * w.dot(model.inertia_M_B * w), sum, 1e-12 * sum);
    }
    EXPECT_LT((model.inertia_M_B - model.inertia_M_B.transpose()).norm(), 1e-12);
    EXPECT_NEAR(model.inertia_M_B(0, 1), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace hexagait
