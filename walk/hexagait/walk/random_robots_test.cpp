// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/params/best_stance.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/trial.hpp>

/// Robots that nobody has seen before: sizes, proportions, axes, limits and masses by lot.
namespace hexagait::walk {
namespace {

// A cylinder or sphere of some mass as a URDF link, from the origin along x.
std::string link(const std::string& name, double length, double radius, double mass) {
  const std::string origin =
      fmt::format("<origin xyz='{:.6g} 0 0' rpy='0 1.5707963 0'/>", 0.5 * length);
  const std::string shape =
      length > 0.0 ? fmt::format("<geometry><cylinder radius='{:.6g}' length='{:.6g}'/></geometry>",
                                 radius, length)
                   : fmt::format("<geometry><sphere radius='{:.6g}'/></geometry>", radius);
  const double round = 0.4 * mass * radius * radius;
  const double along = mass * length * length / 12.0 + round;
  return fmt::format(
      "<link name='{0}'><inertial>{1}<mass value='{2:.6g}'/><inertia ixx='{3:.6g}' ixy='0' ixz='0' "
      "iyy='{3:.6g}' iyz='0' izz='{4:.6g}'/></inertial><collision>{1}{5}</collision></link>",
      name, origin, mass, along, round, shape);
}

struct Lot {
  RandomSequence random;
  double operator()(double least, double most) { return random.uniform(least, most); }
  /// As often in each octave.
  double log(double least, double most) {
    return least * std::exp(random.uniform(0.0, std::log(most / least)));
  }
};

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& origin, const char* axis, double lower, double upper,
                  double speed, double effort) {
  return fmt::format(
      "<joint name='{}' type='revolute'><parent link='{}'/><child link='{}'/><origin {}/><axis "
      "xyz='{}'/><limit lower='{:.6g}' upper='{:.6g}' velocity='{:.6g}' effort='{:.6g}'/></joint>",
      name, parent, child, origin, axis, lower, upper, speed, effort);
}

// Six or eight legs of three joints: yaw-pitch-pitch, or with a first axis that leans by up to 20°.
std::string random_urdf(std::uint64_t seed) {
  Lot lot{{.seed = seed}};
  const int pairs = lot(0.0, 1.0) < 0.75 ? 3 : 4;
  const double size = lot.log(0.12, 1.6);  // from foot to foot, or so
  const double mass = size * size * size * lot(25.0, 90.0);
  const double femur = size * lot(0.16, 0.28), tibia = femur * lot(0.9, 1.6);
  const double coxa = femur * lot(0.15, 0.6), radius = 0.06 * femur;
  const double length = size * lot(0.5, 0.9), width = size * lot(0.15, 0.35);
  const double lean = lot(0.0, 1.0) < 0.3 ? lot(-0.35, 0.35) : 0.0;
  const double fan = lot(0.0, 0.6);  // of the front and rear legs, from straight sideways
  const double yaw = lot(0.5, 1.2), speed = lot(3.0, 9.0);
  const double effort = mass * 9.81 * femur * lot(0.6, 2.0);
  const double leg_mass = mass * lot(0.2, 0.45) / (2 * pairs);

  std::string urdf = fmt::format(
      "<robot name='random{}'><link name='base'><inertial><mass value='{:.6g}'/><inertia "
      "ixx='{:.6g}' ixy='0' ixz='0' iyy='{:.6g}' iyz='0' izz='{:.6g}'/></inertial><collision>"
      "<geometry><box size='{:.6g} {:.6g} {:.6g}'/></geometry></collision></link>",
      seed, mass - 2 * pairs * leg_mass, mass * width * width / 12.0, mass * length * length / 12.0,
      mass * (width * width + length * length) / 12.0, length, width, 0.1 * size);
  for (int k = 0; k < 2 * pairs; ++k) {
    const double side = k % 2 == 0 ? 1.0 : -1.0, along = 1.0 - 2.0 * (k / 2) / (pairs - 1.0);
    const double angle = side * (0.5 * std::numbers::pi - fan * along);
    const std::string leg = fmt::format("leg{}", k);
    urdf += joint(leg + "_1", "base", leg + "a",
                  fmt::format("xyz='{:.6g} {:.6g} 0' rpy='0 {:.6g} {:.6g}'", 0.45 * length * along,
                              0.5 * side * width, lean, angle),
                  "0 0 1", -yaw, yaw, speed, effort);
    urdf += link(leg + "a", coxa, radius, 0.25 * leg_mass);
    urdf += joint(leg + "_2", leg + "a", leg + "b", fmt::format("xyz='{:.6g} 0 0'", coxa), "0 1 0",
                  -1.7, 1.5, speed, effort);
    urdf += link(leg + "b", femur, radius, 0.4 * leg_mass);
    urdf += joint(leg + "_3", leg + "b", leg + "c", fmt::format("xyz='{:.6g} 0 0'", femur), "0 1 0",
                  0.0, 2.6, speed, effort);
    urdf += link(leg + "c", tibia, 0.6 * radius, 0.34 * leg_mass);
    urdf += fmt::format(
        "<joint name='{0}_f' type='fixed'><parent link='{0}c'/><child link='{0}f'/><origin "
        "xyz='{1:.6g} 0 0'/></joint>",
        leg, tibia);
    urdf += link(leg + "f", 0.0, 0.6 * radius, 0.01 * leg_mass);
  }
  return urdf + "</robot>";
}

// Why it does not walk two lengths straight on and turn; empty if it does.
std::string failure(const RobotModel& robot) {
  const RobotScale scale = scale_of(robot);
  const double seconds = 2.0 * scale.size / (0.06 * scale.reach / scale.time);
  for (const auto& heading : {heading_control::Heading::straight(0.0),
                              heading_control::Heading::arc(2.0 * scale.size, 0.0)}) {
    sim3d::World world(robot, {}, {}, nominal_posture(robot));
    footstep_gen::Walker walker(robot);
    TrialOptions options;
    options.schedule = {{0.0, heading, {}}};
    options.seconds = seconds;
    options.distance = 2.0 * scale.size;
    const Summary s = run_trial(walker, world, world.truth(), options);
    if (s.fell) return "fell";
    if (s.stuck) return in_words(s.hindrance, robot);
    if (!s.arrived)
      return fmt::format("too slow: {:.2f} of its way", s.distance / options.distance);
    if (s.lateral_max > 0.05 * scale.size)
      return fmt::format("off its path by {:.3f} of its size", s.lateral_max / scale.size);
  }
  return "";
}

TEST(RandomRobots, WalkIfTheyCanStand) {
  constexpr int kRobots = 5;
  int stand = 0, walk = 0;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    std::string problem;
    try {
      const RobotModel robot = parse_urdf(random_urdf(seed), fmt::format("random{}", seed));
      problem = why_it_cannot_walk(robot);
      if (problem.empty()) {
        ++stand;
        problem = failure(robot);
        walk += problem.empty() ? 1 : 0;
        if (!problem.empty())
          problem += fmt::format(" ({:.2f} m, {:.1f} kg)", scale_of(robot).size, robot.mass);
      } else {
        problem = "cannot stand: " + problem;
      }
    } catch (const InvalidInput& error) {
      problem = std::string("no robot: ") + error.what();
    }
    if (!problem.empty()) fmt::print("{}: {}\n", seed, problem);
  }
  fmt::print("{} of {} can stand; {} of them walk\n", stand, kRobots, walk);
  EXPECT_GE(stand, kRobots / 2);
  EXPECT_EQ(walk, stand);
}

}  // namespace
}  // namespace hexagait::walk
