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
#include <vector>

namespace hexagait {

/// Joint values of one leg, hip to foot, in the robot's own signs and zeros (those of its URDF)
/// [rad], [rad/s] or [N m]. A leg of fewer joints leaves the last entries 0; these play no part.
using LegJoints = Eigen::Vector<double, kMaxLegJoints>;

/// ∂p/∂q of a point of a leg [m/rad]; columns of joints that it doesn't have are 0.
using LegJacobian = Eigen::Matrix<double, 3, kMaxLegJoints>;

/// Joint values from a list, hip to foot; 0 for the rest.
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

/// Collision shape of a link. Cylinders lie along their own z.
struct Shape {
  enum class Kind { box, cylinder, sphere };
  Kind kind = Kind::box;
  Vector3 size = Vector3::Zero();  ///< box: edges; cylinder: radius, length, –; sphere: radius [m]
  Pose X_LS;                       ///< in the link frame L
};

/// A rigid link. With all joints at zero its frame L stands at X_BL0 in the body frame B.
struct LinkModel {
  std::string name;
  double mass = 0.0;                      ///< [kg]
  Vector3 p_LM = Vector3::Zero();         ///< centre of mass in L [m]
  Matrix3 inertia_M_L = Matrix3::Zero();  ///< about the centre of mass, axes of L [kg m²]
  std::vector<Shape> shapes;
  Pose X_BL0;
};

/// How a leg's kinematics are computed.
enum class LegKind : std::uint8_t {
  yaw_pitch_pitch,  ///< three joints, in closed form: yaw_pitch_pitch.hpp
  serial,           ///< 3 to 6 joints about any axes, by iteration: serial_leg.hpp
};

/// A leg: a chain of revolute joints that ends in a spherical foot.
///
/// Yaw-pitch-pitch: the hip frame H stands on the yaw axis at the height of the hip-pitch axis, z
/// up, x outwards along the leg at canonical yaw 0. In H, with canonical angles k, of which
/// positive pitch turns the leg downwards:
///
///     foot = Rz(k₁) · (coxa + femur cos k₂ + tibia cos(k₂+k₃), 0, −femur sin k₂ − tibia
///     sin(k₂+k₃))
///
/// The robot's own joint values q follow by k = sign · q + offset.
///
/// Serial: H stands where the first axis is nearest to the second, z up, x outwards; the lengths,
/// signs and offsets aren't used.
///
/// How all this is derived from the URDF: recognise_leg(); the workspace: leg_reach(),
/// nominal_foot(), reachable_radius(), take_serial_stance().
struct LegModel {
  std::string name;
  LegKind kind = LegKind::yaw_pitch_pitch;
  Pose X_BH;                                    ///< hip frame in the body frame
  double coxa = 0.0, femur = 0.0, tibia = 0.0;  ///< link lengths; tibia to the foot's centre [m]
  Vector3 joint_sign = Vector3::Ones();         ///< ±1
  Vector3 joint_offset = Vector3::Zero();       ///< [rad]; that of yaw is 0

  JointArray<std::string> joint_names{3};
  JointArray<JointLimits> limits{3};  ///< of q
  JointArray<LinkModel> links{3};     ///< each is moved by its joint; the last one has the foot
  JointArray<Vector3> p_BJ0{3};       ///< a point on each joint axis, all joints zero [m]
  JointArray<Vector3> axis_B0{3};     ///< joint axes, all joints zero, unit vectors
  Vector3 p_BF0 = Vector3::Zero();    ///< foot centre, all joints zero [m]

  Vector3 p_BC = Vector3::Zero();  ///< workspace centre: the foot centre of the nominal stance [m]
  LegJoints q_nominal = LegJoints::Zero();  ///< serial: joints of the nominal stance [rad]
  double workspace_radius = 0.0;  ///< horizontal disc about p_BC that the foot may use [m]
  /// Foot centre from the hip-pitch axis; of a serial leg from the hip [m].
  double min_reach = 0.0, max_reach = 0.0;

  int num_joints() const { return limits.size(); }
};

/// A legged robot. Body frame B: x forward, y left, z up, origin at the base link.
struct RobotModel {
  std::string name;
  LinkModel base;
  LegArray<LegModel> legs;         ///< in the order of LegId
  double foot_radius = 0.0;        ///< spherical feet [m]
  double mass = 0.0;               ///< all links [kg]
  Vector3 p_BM = Vector3::Zero();  ///< centre of mass in the nominal stance [m]
  /// About it, in that stance, axes of B [kg m²].
  Matrix3 inertia_M_B = Matrix3::Zero();

  int num_legs() const { return legs.size(); }
};

}  // namespace hexagait
