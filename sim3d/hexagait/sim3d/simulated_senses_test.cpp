// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/simulated_senses.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/source_path.hpp>

namespace hexagait::sim3d {
namespace {

class SimulatedSenses : public ::testing::Test {
 protected:
  // A robot that stands at this pose and looks about.
  navigation::Senses senses_at(const PlanarPose& pose, const char* terrain,
                               const std::vector<Block>& blocks = {}, double noise = 0.0) {
    WorldParams params;
    params.start = pose;
    params.start_clearance = 0.0;
    params.blocks = blocks;
    LegArray<LegJoints> q(robot_.num_legs());
    for (LegId i = 0; i < robot_.num_legs(); ++i)
      q[i] = inverse_kinematics(robot_.legs[i], robot_.legs[i].p_BC).q;
    World world(robot_, parse_terrain(terrain), params, q);
    Inclinometer(world, world, noise, draws_++).read(measurement_);
    return sense(world, layout_, noise, random_);
  }

  // How far ahead a beam looks.
  double looks_ahead(std::size_t k) const {
    const navigation::Beam& beam = layout_.beams[k];
    return beam.from_B.x() + beam.to_floor * beam.direction_B.x();
  }

  RobotModel robot_ = load_urdf(testing::source_path("robots/genghis.urdf"));
  navigation::SenseLayout layout_ = navigation::sense_layout_for(robot_);
  Measurement measurement_;  // of the robot that looked about last
  std::uint64_t draws_ = 0;  // a seed for each
  RandomSequence random_{.seed = 1, .stream = RandomStream::senses};
};

TEST_F(SimulatedSenses, SeeTheFloorWhereThereIsNothingElse) {
  for (const double yaw : {0.0, 1.0, -2.5}) {
    const navigation::Senses senses = senses_at({yaw, {3.0, -7.0}}, "flat");
    for (std::size_t k = 0; k < navigation::kBeams; ++k)
      EXPECT_NEAR(senses.range[k], layout_.beams[k].to_floor, 1e-6);
    EXPECT_FALSE(senses.touches[0] || senses.touches[1]);
  }
}

// A cliff of 20 cm from x = 1.5 on. The robot looks so far ahead that it is just behind the line on
// which the beams meet the floor, or just before it; then they go on down by 20 cm.
TEST_F(SimulatedSenses, SeeACliffFromWhereTheBeamsMeetTheFloor) {
  const double here = 1.5 - looks_ahead(0);
  const navigation::Senses before = senses_at({0.0, {here - 1e-3, 0.0}}, "cliff:3m,20cm"),
                           behind = senses_at({0.0, {here + 1e-3, 0.0}}, "cliff:3m,20cm");
  for (std::size_t k = 0; k < navigation::kBeams; ++k) {
    const navigation::Beam& beam = layout_.beams[k];
    EXPECT_NEAR(before.range[k], beam.to_floor, 1e-6);
    EXPECT_NEAR(behind.range[k], beam.to_floor - 0.2 / beam.direction_B.z(), 1e-6);
  }
}

// A wall across the way, of which the beams see the face and the whiskers feel it.
TEST_F(SimulatedSenses, SeeAndFeelAWall) {
  const auto wall_at = [](double x) {
    return std::vector{Block{{x + 0.5, 0.0, 0.5}, {1.0, 20.0, 1.0}}};
  };
  const navigation::Beam& beam = layout_.beams[1];
  const double x = 0.9 * looks_ahead(1);
  EXPECT_NEAR(senses_at({}, "flat", wall_at(x)).range[1],
              (x - beam.from_B.x()) / beam.direction_B.x(), 1e-6);

  const double tip = layout_.whiskers[0].tip_B.x();
  for (const auto& [at, touches] : {std::pair{tip - 1e-3, true}, {tip + 1e-3, false}}) {
    const navigation::Senses senses = senses_at({}, "flat", wall_at(at));
    EXPECT_EQ(senses.touches[0], touches);
    EXPECT_EQ(senses.touches[1], touches);
  }
  const navigation::Senses left = senses_at({}, "flat", {Block{{0.3, 0.6, 0.5}, {0.2, 0.8, 1.0}}});
  EXPECT_TRUE(left.touches[0]);
  EXPECT_FALSE(left.touches[1]);
}

TEST_F(SimulatedSenses, HaveTheNoiseThatIsAskedFor) {
  double sum = 0.0, squares = 0.0, pitch = 0.0;
  constexpr int kCount = 200;
  for (int i = 0; i < kCount; ++i) {
    const navigation::Senses senses = senses_at({}, "flat", {}, 0.02);
    const double error = senses.range[0] / layout_.beams[0].to_floor - 1.0;
    sum += error;
    squares += error * error;
    pitch += measurement_.inclination.pitch * measurement_.inclination.pitch;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.005);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.02, 0.004);
  EXPECT_NEAR(std::sqrt(pitch / kCount), 0.02, 0.004);
  EXPECT_TRUE(std::isnan(measurement_.inclination.roll)) << "it measures the pitch only";
}

}  // namespace
}  // namespace hexagait::sim3d
