// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/model/robot_model.hpp>
#include <hexagait/sim2d/genghis_world.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::sim2d {
namespace {

using ::testing::HasSubstr;

LegArray<GenghisJoints> nominal(const GenghisModel& model) {
  LegArray<GenghisJoints> q(kGenghisLegs);
  for (LegId i = 0; i < kGenghisLegs; ++i) q[i] = joints_for(model, i, centre(model, i));
  return q;
}

struct Standing {
  GenghisModel model;
  LegArray<GenghisJoints> q = nominal(model);
  GenghisWorld world{model, {}, {}, q};
  GenghisTargets targets{q, LegArray<GenghisJoints>(kGenghisLegs)};
  GenghisMeasurement measurement;

  void wait(double seconds) {
    for (double t = 0.0; t < seconds; t += 0.005) world.write(targets);
    world.read(measurement);
  }
};

TEST(GenghisModel, JointsForAFootPutItThere) {
  const GenghisModel model;
  for (LegId i = 0; i < kGenghisLegs; ++i)
    for (const double x : {-0.05, 0.0, 0.04})
      for (const double z : {-0.07, -0.02, 0.03}) {
        const Vector2 p = hip(model, i) + Vector2(x, z);
        EXPECT_LT((foot_position(model, i, joints_for(model, i, p)) - p).norm(), 1e-12);
      }
}

// Paper: legs of 10 cm, 8 cm of clearance when they are vertical.
TEST(GenghisModel, HasThePapersClearanceWithVerticalLegs) {
  const GenghisModel model;
  const double hips = -foot_position(model, 2, {0.0, 0.0}).y() + model.foot_radius;
  EXPECT_NEAR(hips, 0.10, 1e-12);
  EXPECT_NEAR(hips - model.belly, 0.08, 1e-12);
}

// 1.6 kg · 9.81 m/s² = 15.7 N, of which the motors carry all but the legs' own 6 · 0.98 N.
TEST(GenghisWorld, TheFeetCarryTheWeight) {
  Standing robot;
  robot.wait(2.0);
  const double weight = robot.model.mass() * 9.81;
  double feet = 0.0, load = 0.0;
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    feet += robot.world.truth().feet[i].normal_force;
    load += robot.measurement.load[i];
  }
  EXPECT_NEAR(feet, weight, 0.01 * weight);
  EXPECT_NEAR(load, weight, 0.01 * weight);
  EXPECT_FALSE(robot.world.underside_touches());
  EXPECT_NEAR(robot.world.pitch(), 0.0, 0.01);
}

// The load of a leg in the air is none, though its motor holds it up.
TEST(GenghisWorld, ALiftedLegHasNoLoadAndNoContact) {
  Standing robot;
  robot.targets.q[2].lift += 0.03;
  robot.wait(2.0);
  EXPECT_NEAR(robot.measurement.load[2], 0.0, 0.05);
  EXPECT_FALSE(robot.world.truth().feet[2].in_contact);
  EXPECT_GT(robot.measurement.load[3], 1.0);
}

// One knows front from rear, and up from down: the rear legs drawn in, the nose points up.
TEST(GenghisWorld, PitchIsPositiveNoseUp) {
  Standing robot;
  for (const LegId rear : {4, 5}) robot.targets.q[rear].lift += 0.02;
  robot.wait(2.0);
  EXPECT_GT(robot.measurement.pitch, 0.03);
  EXPECT_EQ(robot.world.pitch(), robot.measurement.pitch);
  // In space, x forward and z up: the nose is above the tail.
  EXPECT_GT((robot.world.truth().X_WB.R * Vector3::UnitX()).z(), 0.03);
}

// The plane has no y: left feet stand to the left, right ones to the right, the body between them.
TEST(GenghisWorld, TheTruthIsThatOfARobotInSpace) {
  Standing robot;
  robot.wait(0.5);
  const GroundTruth& truth = robot.world.truth();
  EXPECT_EQ(truth.X_WB.p.y(), 0.0);
  EXPECT_FALSE(truth.base_touches_ground);
  for (LegId i = 0; i < kGenghisLegs; ++i)
    EXPECT_EQ(truth.feet[i].p_WF.y(), sign_of(i) * robot.model.foot_y);
}

// A foot that slides: its slip has the length of the path, and lies along the flat ground.
TEST(GenghisWorld, SlipIsAVectorAlongTheGround) {
  Standing robot;
  robot.wait(0.5);
  const FootTruth before = robot.world.truth().feet[2];
  robot.targets.q[2].swing += 0.3;
  robot.wait(1.0);
  const FootTruth& after = robot.world.truth().feet[2];
  const Vector3 slip = after.slip - before.slip;
  EXPECT_GT(slip.x(), 0.005);
  EXPECT_NEAR(slip.z(), 0.0, 1e-6);
  EXPECT_LE(slip.norm(), after.slip_path - before.slip_path + 1e-12);
}

// Left legs stand on the left profile, right ones on the right.
TEST(GenghisWorld, EachSideHasItsOwnGround) {
  const GenghisModel model;
  const TerrainSpec2d rough = parse_terrain2d("rough:0.05");
  GenghisWorldParams params;
  params.seed = 5;
  const auto q = nominal(model);
  GenghisWorld world(model, rough, params, q);
  GenghisTargets targets{q, LegArray<GenghisJoints>(kGenghisLegs)};
  for (int k = 0; k < 200; ++k) world.write(targets);
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    const FootTruth& foot = world.truth().feet[i];
    const double ground = world.terrain().height_at(side_of(i), foot.p_WF.x());
    if (foot.in_contact) {
      EXPECT_NEAR(foot.p_WF.z(), ground + model.foot_radius, 0.003);
    }
  }
}

TEST(GenghisWorld, RefusesParametersOfNoWorldAllAtOnce) {
  const GenghisModel model;
  GenghisWorldParams params;
  params.physics_dt = 0.003;
  params.gravity = 0.0;
  try {
    const GenghisWorld world(model, {}, params, nominal(model));
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("control_dt"));
    EXPECT_THAT(error.what(), HasSubstr("gravity"));
  }
}

}  // namespace
}  // namespace hexagait::sim2d
