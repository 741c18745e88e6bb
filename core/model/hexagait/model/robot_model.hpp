// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait {

/// Joint values of one leg, from hip to foot, in the signs and zeros of the robot's URDF [rad],
/// [rad/s] or [N m]. Entries beyond the leg's joints are 0 and not used.
using LegJoints = Eigen::Vector<double, kMaxLegJoints>;

/// ∂p/∂q of a point of a leg [m/rad]; columns beyond the leg's joints are 0.
using LegJacobian = Eigen::Matrix<double, 3, kMaxLegJoints>;

/// Joint values from a list, from hip to foot; the rest are 0.
[[nodiscard]] inline LegJoints leg_joints(std::initializer_list<double> values) {
  assert(static_cast<int>(values.size()) <= kMaxLegJoints);
  LegJoints joints = LegJoints::Zero();
  std::copy(values.begin(), values.end(), joints.data());
  return joints;
}

struct JointLimits {
  double lower = -std::numbers::pi;  ///< [rad]
  double upper = std::numbers::pi;   ///< [rad]
  double velocity = 10.0;            ///< [rad/s]
  double effort = 100.0;             ///< [N m]
};

/// Collision shape of a link. The axis of a cylinder is its z.
struct Shape {
  enum class Kind { box, cylinder, sphere };
  Kind kind = Kind::box;
  Vector3 size = Vector3::Zero();  ///< box: edges; cylinder: radius, length, –; sphere: radius [m]
  Pose X_LS;                       ///< in the link frame L
};

/// A rigid link with frame L.
struct LinkModel {
  std::string name;
  double mass = 0.0;                      ///< [kg]
  Vector3 p_LM = Vector3::Zero();         ///< centre of mass in L [m]
  Matrix3 inertia_M_L = Matrix3::Zero();  ///< about the centre of mass, axes of L [kg m²]
  std::vector<Shape> shapes;
  Pose X_BL0;  ///< pose of L in the body frame with all joints at zero
};

/// How the kinematics of a leg are computed.
enum class LegKind : std::uint8_t {
  yaw_pitch_pitch,  ///< three joints, in closed form: yaw_pitch_pitch.hpp
  serial,           ///< 3 to 6 joints about any axes, by iteration: serial_leg.hpp
  yaw_pitch,        ///< two joints, reduced control, in closed form: yaw_pitch.hpp
};

/// A leg: a chain of revolute joints that ends in a spherical foot.
///
/// Yaw-pitch-pitch: the origin of the hip frame H is on the yaw axis at the height of the hip-pitch
/// axis; z is up, x points outwards along the leg at canonical yaw 0. With canonical angles k,
/// where positive pitch turns the leg downwards, the foot is in H at
///
///     p_HF = Rz(k₁) (coxa + femur cos k₂ + tibia cos(k₂+k₃), 0, −femur sin k₂ − tibia sin(k₂+k₃))
///
/// The robot's own joint values q follow from k = sign · q + offset.
///
/// Yaw-pitch: the same without a knee; femur is from the pitch axis to the foot's centre, tibia is 0.
/// Its foot can't follow an arc over the ground: has_two_joints().
///
/// Serial: the origin of H is the point of the first axis closest to the second; z is up, x points
/// outwards. The lengths, signs and offsets are not used.
///
/// Derived from the URDF by recognise_leg(), and the workspace by leg_reach(), nominal_foot(),
/// reachable_radius() and take_serial_stance().
struct LegModel {
  std::string name;
  LegKind kind = LegKind::yaw_pitch_pitch;
  Pose X_BH;                                    ///< hip frame in the body frame
  double coxa = 0.0, femur = 0.0, tibia = 0.0;  ///< link lengths; tibia to the foot's centre [m]
  Vector3 joint_sign = Vector3::Ones();         ///< ±1
  Vector3 joint_offset = Vector3::Zero();       ///< [rad]; that of yaw is 0

  JointArray<std::string> joint_names{3};
  JointArray<JointLimits> limits{3};  ///< of q
  JointArray<LinkModel> links{3};     ///< link k is moved by joint k; the last one has the foot
  JointArray<Vector3> p_BJ0{3};       ///< a point on each joint axis, joints at zero [m]
  JointArray<Vector3> axis_B0{3};     ///< joint axes, joints at zero, unit vectors
  Vector3 p_BF0 = Vector3::Zero();    ///< foot centre, joints at zero [m]

  Vector3 p_BC = Vector3::Zero();  ///< workspace centre: the foot centre of the nominal stance [m]
  LegJoints q_nominal = LegJoints::Zero();  ///< serial: joints of the nominal stance [rad]
  double workspace_radius = 0.0;  ///< horizontal disc about p_BC that the foot may use [m]
  /// Range of the foot centre's distance from the hip-pitch axis; of a serial leg, from the hip
  /// [m].
  double min_reach = 0.0, max_reach = 0.0;

  int num_joints() const { return limits.size(); }

  /// Its foot is on a surface: where it stands it slides to the side, and that is no fault.
  bool has_two_joints() const { return kind == LegKind::yaw_pitch; }
};

/// A leg's name without "_leg" or "_LEG", which actions may write after it or leave out.
[[nodiscard]] inline std::string_view short_leg_name(std::string_view name) {
  for (const std::string_view suffix : {"_LEG", "_leg"})
    if (name.ends_with(suffix)) return name.substr(0, name.size() - suffix.size());
  return name;
}

/// Where something of a robot comes from that does not stand in its file just so.
enum class Origin : std::uint8_t {
  derived,      ///< computed from what the file says
  substituted,  ///< the file says nothing, or what can't be
  given,        ///< by an option
  left_out,     ///< it is in the file, and not used
};

[[nodiscard]] constexpr const char* to_string(Origin origin) noexcept {
  constexpr const char* kWords[] = {"derived", "substituted", "given", "left out"};
  return kWords[static_cast<int>(origin)];
}

/// A value of a robot that is not its file's.
struct Substitution {
  Origin origin = Origin::substituted;
  std::string element;  ///< as "joint LF_yaw"
  int line = 0;         ///< of the element in the file; 0: none
  std::string what;     ///< as "velocity limit"
  std::string found;    ///< as "0 rad/s" or "none"
  std::string used;     ///< as "5 rad/s", with the rule
  std::string option;   ///< that overrides it; empty: none
};

/// A legged robot. Body frame B: x forward, y left, z up, origin at the base link.
struct RobotModel {
  std::string name;
  LinkModel base;
  LegArray<LegModel> legs;         ///< in the order of LegId
  double foot_radius = 0.0;        ///< spherical feet [m]
  double mass = 0.0;               ///< all links [kg]
  Vector3 p_BM = Vector3::Zero();  ///< centre of mass in the nominal stance [m]
  /// Inertia about the centre of mass in the nominal stance, axes of B [kg m²].
  Matrix3 inertia_M_B = Matrix3::Zero();
  std::vector<Substitution> substitutions;  ///< what of it its file does not say

  int num_legs() const { return legs.size(); }
};

}  // namespace hexagait
