// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <functional>
#include <hexagait/math/geometry.hpp>
#include <numbers>
#include <string>
#include <vector>

namespace hexagait::testing {

/// A URDF of a robot with yaw-pitch-pitch legs, whose names say nothing, with places where a test can
/// spoil it. Lengths are those of a robot of about 0.3 m, times size.
struct RobotText {
  double size = 1.0, mass = 2.0;  ///< [-], [kg]
  std::vector<Vector2> hips = rows(3);
  double coxa = 0.03, femur = 0.07, tibia = 0.11;  ///< [m], times size
  std::string root = "";                           ///< links and joints before link b; or nothing
  std::string base = kBox;                         ///< what link b has besides its mass
  std::string tibia_has = kBall;  ///< what the last link of a leg has besides its mass
  std::string foot = "";          ///< links and joints behind it: {0} is the leg's number
  std::string more = "";          ///< links and joints of anything else
  std::string drive = "velocity='6' effort='{:g}'";  ///< {} is an effort that suffices [N m]
  std::string yaw = "lower='-1' upper='1'", hip = "lower='-1.5' upper='1.5'",
              knee = "lower='0.1' upper='2.6'";
  std::string type = "revolute";
  /// Mass and inertia of a link of a mass [kg] and a length [m].
  std::function<std::string(const std::string&, double, double)> inertial = plausible;
  std::function<std::string(int, int)> joint_name = [](int leg, int joint) {
    return fmt::format("q{}-{}", leg, joint);
  };

  static constexpr const char* kBox =
      "<collision><geometry><box size='{0} {1} {2}'/></geometry></collision>";
  static constexpr const char* kBall =
      "<collision><origin xyz='{0} 0 0'/><geometry><sphere radius='{1}'/></geometry></collision>";

  /// Hips in two rows, front to rear, left before right.
  static std::vector<Vector2> rows(int pairs) {
    std::vector<Vector2> hips;
    for (int i = 0; i < pairs; ++i)
      for (const double side : {1.0, -1.0})
        hips.emplace_back(0.09 * (pairs - 1) / 2.0 - 0.09 * i, 0.045 * side);
    return hips;
  }
  /// Hips on a circle, the first one in a direction [rad].
  static std::vector<Vector2> ring(int legs, double first) {
    std::vector<Vector2> hips;
    for (int i = 0; i < legs; ++i)
      hips.emplace_back(0.08 * unit_vector(first + 2.0 * std::numbers::pi * i / legs));
    return hips;
  }

  /// A root in whose frame link b stands at a place, turned by roll, pitch and yaw.
  static std::string placed(const Vector3& p, const Vector3& rpy) {
    return fmt::format(
        "<link name='o'/><joint name='ob' type='fixed'><parent link='o'/><child link='b'/>"
        "<origin xyz='{} {} {}' rpy='{:.17g} {:.17g} {:.17g}'/></joint>",
        p.x(), p.y(), p.z(), rpy.x(), rpy.y(), rpy.z());
  }

  static std::string plausible(const std::string&, double mass, double length) {
    const double inertia = mass * 0.09 * length * length;
    return fmt::format(
        "<inertial><mass value='{0:g}'/><inertia ixx='{1:g}' iyy='{1:g}' izz='{1:g}' ixy='0' "
        "ixz='0' iyz='0'/></inertial>",
        mass, inertia);
  }

  static std::string joint(const std::string& name, const std::string& type,
                           const std::string& parent, const std::string& child,
                           const Vector3& place, double yaw, const std::string& inside) {
    return fmt::format(
        "<joint name='{}' type='{}'><parent link='{}'/><child link='{}'/>\n"
        "<origin xyz='{:.12g} {:.12g} {:.12g}' rpy='0 0 {:.17g}'/>{}</joint>\n",
        name, type, parent, child, place.x(), place.y(), place.z(), yaw, inside);
  }

  /// A link of some mass on a joint, for what is no leg.
  static std::string limb(const std::string& name, const std::string& type,
                          const std::string& parent, const Vector3& place, const char* axis) {
    return fmt::format("<link name='{}'>{}</link>", name, plausible(name, 0.02, 0.05)) +
           joint("to_" + name, type, parent, name, place, 0.0,
                 fmt::format("<axis xyz='{}'/><limit lower='-1' upper='1' velocity='5' "
                             "effort='1'/>",
                             axis));
  }

  [[nodiscard]] std::string link(const std::string& name, double kg, double length,
                                 const std::string& has) const {
    return fmt::format("<link name='{}'>\n{}{}</link>\n", name, inertial(name, kg, length), has);
  }

  [[nodiscard]] std::string leg(int i) const {
    const Vector2 hip_xy = size * hips[static_cast<std::size_t>(i)];
    const double outwards = is_ring() ? std::atan2(hip_xy.y(), hip_xy.x())
                                      : (hip_xy.y() > 0.0 ? 0.5 : -0.5) * std::numbers::pi;
    const Vector3 place(hip_xy.x(), hip_xy.y(), 0.0);
    const double lengths[] = {size * coxa, size * femur, size * tibia};
    const std::string limits[] = {yaw, hip, knee};
    const double effort = 0.5 * mass * 9.81 * (lengths[0] + lengths[1] + lengths[2]);
    std::string text, parent = "b";
    for (int k = 0; k < 3; ++k) {
      const std::string name = fmt::format("l{}{}", i, "abc"[k]);
      text += joint(joint_name(i, k), type, parent, name,
                    k == 0 ? place : Vector3(lengths[k - 1], 0.0, 0.0), k == 0 ? outwards : 0.0,
                    fmt::format("<axis xyz='{}'/><limit {} {}/>", k == 0 ? "0 0 1" : "0 1 0",
                                limits[k], fmt::format(fmt::runtime(drive), effort)));
      const std::string has =
          k < 2 ? "" : fmt::format(fmt::runtime(tibia_has), lengths[2], 0.05 * lengths[2]);
      text += link(name, 0.4 * mass / (3.0 * static_cast<double>(hips.size())), lengths[k], has);
      parent = name;
    }
    return text + fmt::format(fmt::runtime(foot), i, lengths[2]);
  }

  [[nodiscard]] bool is_ring() const {
    return hips.size() > 4 && std::abs(hips[0].norm() - hips[1].norm()) < 1e-9 &&
           std::abs(hips[1].norm() - hips[2].norm()) < 1e-9;
  }

  [[nodiscard]] std::string text() const {
    std::string all = "<robot name='r'>\n" + root;
    all += link("b", 0.6 * mass, 0.2 * size,
                fmt::format(fmt::runtime(base), 0.22 * size, 0.08 * size, 0.04 * size));
    for (int i = 0; i < static_cast<int>(hips.size()); ++i) all += leg(i);
    return all + more + "</robot>";
  }
};

}  // namespace hexagait::testing
