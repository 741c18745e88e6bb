// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/gallery/random_robot.hpp>
#include <hexagait/math/geometry.hpp>
#include <hexagait/sim/random.hpp>
#include <numbers>

namespace hexagait::experiments {
namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;

struct Lot {
  RandomSequence random;
  double operator()(double least, double most) { return random.uniform(least, most); }
  bool chance(double share) { return random.u01() < share; }
  /// As often in each octave, and uniform within it.
  double by_octave(double least, int octaves) {
    for (int left = static_cast<int>(random.uniform(0.0, octaves)); left > 0; --left) least *= 2.0;
    return random.uniform(least, 2.0 * least);
  }
};

// All that is the same for each leg.
struct Body {
  LegLayout layout = LegLayout::yaw_pitch_pitch;
  bool round = false;
  int pairs = 0;
  double size = 0.0, mass = 0.0, length = 0.0, width = 0.0;  // [m], [kg], [m], [m]
  double coxa = 0.0, femur = 0.0, tibia = 0.0, tarsus = 0.0, leg_mass = 0.0;
  double lean = 0.0, fan = 0.0;                 // [rad]
  double yaw = 0.0, speed = 0.0, effort = 0.0;  // of the joints [rad], [rad/s], [N m]
};

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

struct Range {
  double lower, upper;  // [rad]
};

std::string joint(const Body& body, const std::string& name, const std::string& parent,
                  const std::string& child, const std::string& origin, const char* axis,
                  Range range) {
  return fmt::format(
      "<joint name='{}' type='revolute'><parent link='{}'/><child link='{}'/><origin {}/><axis "
      "xyz='{}'/><limit lower='{:.6g}' upper='{:.6g}' velocity='{:.6g}' effort='{:.6g}'/></joint>",
      name, parent, child, origin, axis, range.lower, range.upper, body.speed, body.effort);
}

Body random_body(Lot& lot) {
  Body body;
  const double legs = lot(0.0, 1.0), kind = lot(0.0, 1.0);
  body.pairs = legs < 0.1 ? 2 : legs < 0.7 ? 3 : legs < 0.92 ? 4 : 5;
  body.layout = kind < 0.55   ? LegLayout::yaw_pitch_pitch
                : kind < 0.75 ? LegLayout::leaning
                : kind < 0.90 ? LegLayout::four_joints
                              : LegLayout::roll_pitch_pitch;
  const bool below = body.layout == LegLayout::roll_pitch_pitch;
  body.round = !below && lot.chance(0.2);
  body.size = lot.by_octave(0.12, 4);
  body.mass = body.size * body.size * body.size * lot(25.0, 90.0);
  body.femur = body.size * lot(0.16, 0.28) * (below ? 0.9 : 1.0);
  body.tibia = body.femur * (below ? lot(0.85, 1.15) : lot(0.9, 1.6));
  body.coxa = body.femur * lot(0.15, 0.6);
  body.tarsus = body.layout == LegLayout::four_joints ? body.femur * lot(0.2, 0.5) : 0.0;
  body.length = body.size * lot(0.5, 0.9) * (body.pairs > 3 ? 1.25 : 1.0);
  body.width = body.size * lot(0.15, 0.35);
  body.lean = body.layout == LegLayout::leaning ? lot(-0.35, 0.35) : 0.0;
  body.fan = lot(0.0, 0.6);
  body.yaw = lot(0.5, 1.2);
  body.speed = lot(3.0, 9.0);
  body.effort = body.mass * 9.81 * body.femur * lot(0.6, 2.0);
  body.leg_mass = body.mass * lot(0.2, 0.45) / (2 * body.pairs);
  return body;
}

// Where leg k's first joint is, and which way the leg goes from there.
std::string hip(const Body& body, int k) {
  const int pair = k / 2;
  const double side = k % 2 == 0 ? 1.0 : -1.0, along = 1.0 - 2.0 * pair / (body.pairs - 1.0);
  double angle = side * (kRightAngle - body.fan * along);
  Vector2 place(0.45 * body.length * along, 0.5 * side * body.width);
  if (body.layout == LegLayout::roll_pitch_pitch) angle = side * kRightAngle;
  if (body.round) {
    angle = side * std::numbers::pi * (pair + 0.5) / body.pairs;
    place = 0.5 * body.width * unit_vector(angle);
  }
  return fmt::format("xyz='{:.6g} {:.6g} 0' rpy='0 {:.6g} {:.6g}'", place.x(), place.y(), body.lean,
                     angle);
}

std::string along_x(double length) { return fmt::format("xyz='{:.6g} 0 0'", length); }

// From the root of the leg to the ball that is its foot.
std::string leg(const Body& body, int k) {
  const std::string name = fmt::format("leg{}", k);
  const bool below = body.layout == LegLayout::roll_pitch_pitch;
  const double radius = 0.06 * body.femur;
  // A leg below the body turns at its hip about the body's long axis, and hangs: x goes down.
  std::string text = joint(body, name + "_1", "base", name + "a", hip(body, k),
                           below ? "0 1 0" : "0 0 1", {-body.yaw, body.yaw});
  text += link(name + "a", body.coxa, radius, 0.25 * body.leg_mass);
  text += joint(body, name + "_2", name + "a", name + "b",
                along_x(body.coxa) + (below ? " rpy='1.5707963 1.5707963 0'" : ""), "0 1 0",
                {-1.7, 1.5});
  text += link(name + "b", body.femur, radius, 0.4 * body.leg_mass);
  text +=
      joint(body, name + "_3", name + "b", name + "c", along_x(body.femur), "0 1 0", {0.0, 2.6});
  text += link(name + "c", body.tibia, 0.6 * radius, 0.34 * body.leg_mass);
  std::string last = name + "c";
  double length = body.tibia;
  if (body.tarsus > 0.0) {
    text += joint(body, name + "_4", last, name + "d", along_x(length), "0 1 0", {-1.2, 1.2});
    text += link(name + "d", body.tarsus, 0.5 * radius, 0.1 * body.leg_mass);
    last = name + "d";
    length = body.tarsus;
  }
  text += fmt::format(
      "<joint name='{0}_f' type='fixed'><parent link='{1}'/><child link='{0}f'/><origin {2}/>"
      "</joint>",
      name, last, along_x(length));
  return text + link(name + "f", 0.0, 0.6 * radius, 0.01 * body.leg_mass);
}

}  // namespace

const char* to_string(LegLayout layout) {
  switch (layout) {
    case LegLayout::yaw_pitch_pitch:
      return "yaw-pitch-pitch";
    case LegLayout::leaning:
      return "leaning";
    case LegLayout::four_joints:
      return "four joints";
    case LegLayout::roll_pitch_pitch:
      return "roll-pitch-pitch";
  }
  return "";
}

RandomRobot random_robot(std::uint64_t seed) {
  Lot lot{{.seed = seed}};
  const Body body = random_body(lot);
  const double mass = body.mass - 2 * body.pairs * body.leg_mass;
  const double across = body.width * body.width, along = body.length * body.length;
  std::string urdf = fmt::format(
      "<robot name='random{}'><link name='base'><inertial><mass value='{:.6g}'/><inertia "
      "ixx='{:.6g}' ixy='0' ixz='0' iyy='{:.6g}' iyz='0' izz='{:.6g}'/></inertial><collision>"
      "<geometry><box size='{:.6g} {:.6g} {:.6g}'/></geometry></collision></link>",
      seed, mass, body.mass * across / 12.0, body.mass * along / 12.0,
      body.mass * (across + along) / 12.0, body.length, body.width, 0.1 * body.size);
  for (int k = 0; k < 2 * body.pairs; ++k) urdf += leg(body, k);
  return {seed, 2 * body.pairs, body.layout, body.round, urdf + "</robot>"};
}

}  // namespace hexagait::experiments
