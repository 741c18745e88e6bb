// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <hexagait/gallery/random_robot.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/params/best_stance.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <numbers>
#include <optional>
#include <utility>

// The whole swing of robots that nobody has seen before is within what their legs can do.

namespace hexagait::experiments {
namespace {

constexpr std::uint64_t kRobots = 300;
constexpr int kPlaces = 40;          // of each leg
constexpr double kBodySpeed = 0.33;  // while a foot swings at its greatest speed, of ℓ/T

std::optional<RobotModel> standing_robot(std::uint64_t seed) {
  const RandomRobot random = random_robot(seed);
  try {
    RobotModel robot = parse_urdf(random.urdf, "random");
    if (why_it_cannot_walk(robot).empty()) return robot;
  } catch (const InvalidInput&) {  // it can't be told from the file how it would stand
  }
  return std::nullopt;
}

// A place of the foot in a step, uniform in the cylinder of half a stroke around the nominal one, from below
// the ground to the apex.
Vector3 place_in_swing(const LegModel& leg, const StepParams& step, RandomSequence& random) {
  const double radius = 0.5 * step.stroke * std::sqrt(random.uniform(0.0, 1.0));
  const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
  const double z = random.uniform(-0.3 * step.height, step.height);
  return leg.p_BC + Vector3(radius * std::cos(angle), radius * std::sin(angle), z);
}

// Joint speeds of least norm that move the foot with v; by a decomposition that params_for() doesn't use.
LegJoints speeds(const LegModel& leg, const LegTrig& trig, const Vector3& v) {
  const Eigen::MatrixXd J = foot_jacobian(leg, trig).leftCols(leg.num_joints());
  LegJoints all = LegJoints::Zero();
  all.head(leg.num_joints()) =
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(J).solve(Eigen::VectorXd(v));
  return all;
}

TEST(RandomLegs, ReachTheWholeSwingWithinTheirJointsRangesAndSpeeds) {
  int robots = 0;
  double fastest = 0.0;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    const auto robot = standing_robot(seed);
    if (!robot) continue;
    ++robots;
    const RobotParams params = params_for(*robot);
    const RobotScale scale = scale_of(*robot);
    // The body makes a part of the foot's speed over the ground.
    const double across = params.swing.max_speed - kBodySpeed * scale.reach / scale.time;
    const double up = params.swing.max_rise;
    RandomSequence random{.seed = seed};
    for (const LegModel& leg : robot->legs)
      for (int k = 0; k < kPlaces; ++k) {
        const Vector3 p_BF = place_in_swing(leg, params.step, random);
        const LegSolution solution = inverse_kinematics(leg, p_BF);
        ASSERT_TRUE(solution.reachable) << "robot " << seed << ", leg " << leg.name;
        ASSERT_LT((foot_position(leg, solution.trig) - p_BF).norm(), 1e-7 * leg.max_reach);
        const double direction = random.uniform(-std::numbers::pi, std::numbers::pi);
        const LegJoints sideways = speeds(
            leg, solution.trig, across * Vector3(std::cos(direction), std::sin(direction), 0.0));
        const LegJoints upwards = speeds(leg, solution.trig, up * Vector3::UnitZ());
        for (int j = 0; j < leg.num_joints(); ++j) {
          const JointLimits& limits = leg.limits[j];
          ASSERT_GE(solution.q[j], limits.lower - 1e-9);
          ASSERT_LE(solution.q[j], limits.upper + 1e-9);
          const double most = std::max(std::abs(sideways[j]), std::abs(upwards[j]));
          ASSERT_LT(most, limits.velocity) << "robot " << seed << ", leg " << leg.name << ", " << j;
          fastest = std::max(fastest, most / limits.velocity);
        }
      }
  }
  EXPECT_GT(robots, 100);
  EXPECT_GT(fastest, 0.8) << "nothing of what the joints can do is left over";
}

// A foot anywhere on the ground within half a stroke carries its load, and the leg its own links.
TEST(RandomLegs, CarryTheRobotAllAlongTheirStrokes) {
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    const auto robot = standing_robot(seed);
    if (!robot) continue;
    const double stroke = params_for(*robot).step.stroke, load = standing_load(*robot);
    RandomSequence random{.seed = seed};
    for (const LegModel& leg : robot->legs)
      for (int k = 0; k < kPlaces; ++k) {
        const Vector3 p_BF = place_in_swing(leg, {.stroke = stroke, .height = 0.0}, random);
        const LegJoints effort = standing_effort(leg, inverse_kinematics(leg, p_BF), load);
        for (int j = 0; j < leg.num_joints(); ++j) {
          const double share = std::abs(effort[j]) / leg.limits[j].effort;
          ASSERT_LT(share, 1.01) << "robot " << seed << ", leg " << leg.name << ", " << j;
          most = std::max(most, share);
        }
      }
  }
  EXPECT_GT(most, 0.9) << "nothing of what the joints can do is left over";
}

// Legs of four joints use the one too many to stay away from their limits.
TEST(RandomLegs, OfMoreThanThreeJointsStayAwayFromTheirLimits) {
  int legs = 0;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    const auto robot = standing_robot(seed);
    if (!robot || robot->legs[0].num_joints() == 3) continue;
    const StepParams step = params_for(*robot).step;
    RandomSequence random{.seed = seed};
    for (const LegModel& leg : robot->legs) {
      ++legs;
      for (int k = 0; k < kPlaces; ++k) {
        const LegJoints q = inverse_kinematics(leg, place_in_swing(leg, step, random)).q;
        for (int j = 0; j < leg.num_joints(); ++j) {
          const auto& [lower, upper] = std::pair(leg.limits[j].lower, leg.limits[j].upper);
          EXPECT_GT(std::min(q[j] - lower, upper - q[j]), 0.05 * (upper - lower))
              << "robot " << seed << ", leg " << leg.name << ", " << j;
        }
      }
    }
  }
  EXPECT_GT(legs, 100);
}

}  // namespace
}  // namespace hexagait::experiments
