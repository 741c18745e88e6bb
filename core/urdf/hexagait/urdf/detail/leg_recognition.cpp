// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/urdf/detail/leg_recognition.hpp>

namespace hexagait {
namespace {

constexpr double kTolerance = 1e-4;  // [rad] between axes, [m] off the leg's plane

/// Sine of the angle between two unit vectors, sense ignored.
double misalignment(const Vector3& a, const Vector3& b) { return a.cross(b).norm(); }

/// "LF" of LF_yaw, LF_hip, LF_knee: what the joint names begin with; else the first one's name.
std::string leg_name(const SerialChain& chain) {
  const std::string& first = chain.joints.front().name;
  std::size_t common = first.size();
  for (const TreeJoint& joint : chain.joints) {
    const auto end =
        std::mismatch(first.begin(), first.end(), joint.name.begin(), joint.name.end());
    common = std::min(common, static_cast<std::size_t>(end.first - first.begin()));
  }
  const std::string name = first.substr(0, common);
  const std::size_t last = name.find_last_not_of("_-./ ");
  return last == std::string::npos ? first : name.substr(0, last + 1);
}

/// Three joints, and the directions of their axes are those of yaw, pitch, pitch.
bool has_yaw_pitch_pitch_axes(const SerialChain& chain) {
  if (chain.joints.size() != 3) return false;
  const Vector3 &yaw = chain.joints[0].axis_B0, &hip = chain.joints[1].axis_B0,
                &knee = chain.joints[2].axis_B0;
  return misalignment(yaw, Vector3::UnitZ()) < kTolerance && std::abs(hip.z()) < kTolerance &&
         misalignment(hip, knee) < kTolerance;
}

/// Two joints: yaw about the vertical, then a level pitch axis.
bool has_yaw_pitch_axes(const SerialChain& chain) {
  return chain.joints.size() == 2 &&
         misalignment(chain.joints[0].axis_B0, Vector3::UnitZ()) < kTolerance &&
         std::abs(chain.joints[1].axis_B0.z()) < kTolerance;
}

/// x_H: horizontal, normal to the pitch axis, outwards.
Vector3 outward_direction(const SerialChain& chain) {
  const Vector3 yaw = chain.joints[0].p_BJ0, hip = chain.joints[1].p_BJ0;
  const Vector3 pitch_axis = chain.joints[1].axis_B0;
  Vector3 x = Vector3(pitch_axis.y(), -pitch_axis.x(), 0.0).normalized();
  for (const Vector3& outwards : {Vector3(hip - yaw), Vector3(chain.foot->p_BF0 - yaw), yaw}) {
    const double along = outwards.dot(x);
    if (std::abs(along) < kTolerance) continue;
    if (along < 0.0) x = -x;
    break;
  }
  return x;
}

/// The angle of the direction (x, z) below x: positive downwards [rad].
double pitch_of(const Vector3& v_H) { return portable::atan2(-v_H.z(), v_H.x()); }

/// The hip frame of a leg that begins with yaw and pitch.
void derive_hip(const SerialChain& chain, LegModel& leg) {
  const Vector3 x = outward_direction(chain), z = Vector3::UnitZ();
  leg.X_BH.R << x, z.cross(x), z;
  leg.X_BH.p << chain.joints[0].p_BJ0.head<2>(), chain.joints[1].p_BJ0.z();
  for (int i = 0; i < leg.num_joints(); ++i) {
    const Vector3& axis = chain.joints[static_cast<std::size_t>(i)].axis_B0;
    leg.joint_sign[i] = axis.dot(leg.X_BH.R.col(i == 0 ? 2 : 1)) > 0.0 ? 1.0 : -1.0;
  }
}

/// Of a leg of two joints.
void derive_short_geometry(const SerialChain& chain, LegModel& leg) {
  leg.kind = LegKind::yaw_pitch;
  derive_hip(chain, leg);
  const Pose X_HB = leg.X_BH.inverse();
  leg.coxa = (X_HB * chain.joints[1].p_BJ0).x();
  const Vector3 p_PF = X_HB * leg.p_BF0 - Vector3(leg.coxa, 0.0, 0.0);
  leg.femur = portable::hypot(p_PF.x(), p_PF.z());
  leg.joint_offset = {0.0, pitch_of(p_PF), 0.0};
}

/// Lengths, signs and offsets from the axes and points at zero.
void derive_geometry(const SerialChain& chain, LegModel& leg) {
  derive_hip(chain, leg);
  const TreeJoint &hip = chain.joints[1], &knee = chain.joints[2];
  const Vector3 x = leg.X_BH.R.col(0);

  const Pose X_HB = leg.X_BH.inverse();
  const Vector3 p_HK = X_HB * knee.p_BJ0, p_HF = X_HB * leg.p_BF0;
  const Vector3 p_HP(x.dot(hip.p_BJ0 - leg.X_BH.p), 0.0, 0.0);  // in the leg's plane, as K and F
  leg.coxa = p_HP.x();
  leg.femur = portable::hypot(p_HK.x() - p_HP.x(), p_HK.z());
  leg.tibia = portable::hypot(p_HF.x() - p_HK.x(), p_HF.z() - p_HK.z());

  const double femur_pitch = pitch_of(p_HK - p_HP), tibia_pitch = pitch_of(p_HF - p_HK);
  leg.joint_offset = {0.0, femur_pitch, wrap_angle(tibia_pitch - femur_pitch)};
}

bool has_shape_of_its_kind(const LegModel& leg) {
  const double off_plane = (leg.X_BH.inverse() * leg.p_BF0).y();
  const bool has_tibia = leg.kind == LegKind::yaw_pitch || leg.tibia > kTolerance;
  return std::abs(off_plane) < kTolerance && leg.femur > kTolerance && has_tibia;
}

/// The hip frame of any other leg.
Pose serial_hip(const LegModel& leg) {
  const Vector3 p_BH =
      nearest_points(leg.p_BJ0[0], leg.axis_B0[0], leg.p_BJ0[1], leg.axis_B0[1]).on_first;
  Vector3 x = leg.p_BF0 - p_BH;
  x.z() = 0.0;
  // A leg that hangs straight down, or one whose foot is in front of its hip, stands to its side.
  const bool lies_flat = std::abs(leg.axis_B0[0].z()) < 0.7;
  if (lies_flat || x.norm() < kTolerance) x = Vector3(0.0, p_BH.y() < 0.0 ? -1.0 : 1.0, 0.0);
  x.normalize();
  Pose X_BH;
  X_BH.R << x, Vector3::UnitZ().cross(x), Vector3::UnitZ();
  X_BH.p = p_BH;
  return X_BH;
}

LegModel with_joints_of(const SerialChain& chain) {
  LegModel leg;
  leg.name = leg_name(chain);
  const int n = static_cast<int>(chain.joints.size());
  leg.joint_names = JointArray<std::string>(n);
  leg.limits = JointArray<JointLimits>(n);
  leg.links = JointArray<LinkModel>(n);
  leg.p_BJ0 = leg.axis_B0 = JointArray<Vector3>(n);
  for (int i = 0; i < n; ++i) {
    const TreeJoint& joint = chain.joints[static_cast<std::size_t>(i)];
    leg.joint_names[i] = joint.name;
    leg.limits[i] = joint.limits;
    leg.links[i] = chain.links[static_cast<std::size_t>(i)];
    leg.p_BJ0[i] = joint.p_BJ0;
    leg.axis_B0[i] = joint.axis_B0;
  }
  leg.p_BF0 = chain.foot->p_BF0;
  return leg;
}

}  // namespace

LegModel recognise_leg(const SerialChain& chain) {
  LegModel leg = with_joints_of(chain);
  if (has_yaw_pitch_pitch_axes(chain)) {
    derive_geometry(chain, leg);
    if (has_shape_of_its_kind(leg)) return leg;
  }
  if (has_yaw_pitch_axes(chain)) {
    derive_short_geometry(chain, leg);
    if (has_shape_of_its_kind(leg)) return leg;
  }
  LegModel serial = with_joints_of(chain);
  serial.kind = LegKind::serial;
  serial.X_BH = serial_hip(serial);
  return serial;
}

}  // namespace hexagait
