// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <hexagait/core/leg_recognition.hpp>

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

bool is_serial_leg(const SerialChain& chain, const std::string& element, Violations& violations) {
  if (chain.joints.size() != 3)
    violations.add(element, "has " + std::to_string(chain.joints.size()) +
                                " movable joints; a leg has three: yaw, hip pitch, knee pitch");
  if (!chain.foot)
    violations.add("link " + chain.links.back().name,
                   "has no collision sphere; a leg ends in a spherical foot");
  return chain.joints.size() == 3 && chain.foot;
}

/// Checks the directions of the three axes.
bool has_leg_axes(const SerialChain& chain, Violations& violations) {
  const TreeJoint &yaw = chain.joints[0], &hip = chain.joints[1], &knee = chain.joints[2];
  for (const TreeJoint& joint : chain.joints)
    if (joint.axis_B0.isZero()) return false;  // known since it was read

  const double tilt = misalignment(yaw.axis_B0, Vector3::UnitZ());
  const double slope = std::abs(hip.axis_B0.z());
  const double skew = misalignment(hip.axis_B0, knee.axis_B0);
  if (!(tilt < kTolerance))
    violations.add("joint " + yaw.name, "axis is " + in_words(std::asin(std::min(tilt, 1.0))) +
                                            " rad off the vertical; a leg begins with a yaw joint");
  if (!(slope < kTolerance))
    violations.add("joint " + hip.name, "axis is " + in_words(std::asin(std::min(slope, 1.0))) +
                                            " rad off the horizontal; the hip pitches");
  if (!(skew < kTolerance))
    violations.add("joint " + knee.name, "axis is " + in_words(std::asin(std::min(skew, 1.0))) +
                                             " rad off that of " + hip.name +
                                             "; hip and knee axes are parallel");
  return tilt < kTolerance && slope < kTolerance && skew < kTolerance;
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
double pitch_of(const Vector3& v_H) { return std::atan2(-v_H.z(), v_H.x()); }

/// Lengths, signs and offsets from the axes and points at zero.
void derive_geometry(const SerialChain& chain, LegModel& leg) {
  const Vector3 x = outward_direction(chain), z = Vector3::UnitZ(), y = z.cross(x);
  const TreeJoint &yaw = chain.joints[0], &hip = chain.joints[1], &knee = chain.joints[2];
  leg.X_BH.R << x, y, z;
  leg.X_BH.p << yaw.p_BJ0.head<2>(), hip.p_BJ0.z();

  const Pose X_HB = leg.X_BH.inverse();
  const Vector3 p_HK = X_HB * knee.p_BJ0, p_HF = X_HB * leg.p_BF0;
  const Vector3 p_HP(x.dot(hip.p_BJ0 - leg.X_BH.p), 0.0, 0.0);  // in the leg's plane, as K and F
  leg.coxa = p_HP.x();
  leg.femur = std::hypot(p_HK.x() - p_HP.x(), p_HK.z());
  leg.tibia = std::hypot(p_HF.x() - p_HK.x(), p_HF.z() - p_HK.z());

  for (int i = 0; i < 3; ++i) {
    const auto j = static_cast<std::size_t>(i);
    leg.joint_sign[i] = chain.joints[j].axis_B0.dot(i == 0 ? z : y) > 0.0 ? 1.0 : -1.0;
  }
  const double femur_pitch = pitch_of(p_HK - p_HP), tibia_pitch = pitch_of(p_HF - p_HK);
  leg.joint_offset = {0.0, femur_pitch, wrap_angle(tibia_pitch - femur_pitch)};
}

bool has_leg_shape(const LegModel& leg, Violations& violations) {
  const double off_plane = (leg.X_BH.inverse() * leg.p_BF0).y();
  if (!(std::abs(off_plane) < kTolerance))
    violations.add("leg " + leg.name, "foot is " + in_words(off_plane) +
                                          " m off the vertical plane of yaw axis and leg; it must "
                                          "lie in it");
  if (!(leg.femur > kTolerance))
    violations.add("link " + leg.links[1].name,
                   "femur has length " + in_words(leg.femur) +
                       " m between the pitch axes; it must be positive");
  if (!(leg.tibia > kTolerance))
    violations.add("link " + leg.links[2].name, "tibia has length " + in_words(leg.tibia) +
                                                    " m from knee to foot; it must be positive");
  return std::abs(off_plane) < kTolerance && leg.femur > kTolerance && leg.tibia > kTolerance;
}

}  // namespace

std::optional<LegModel> recognise_leg(const SerialChain& chain, Violations& violations) {
  LegModel leg;
  leg.name = leg_name(chain);
  if (!is_serial_leg(chain, "leg " + leg.name, violations)) return std::nullopt;
  if (!has_leg_axes(chain, violations)) return std::nullopt;

  for (std::size_t i = 0; i < 3; ++i) {
    leg.joint_names[i] = chain.joints[i].name;
    leg.limits[i] = chain.joints[i].limits;
    leg.links[i] = chain.links[i];
    leg.p_BJ0[i] = chain.joints[i].p_BJ0;
    leg.axis_B0[i] = chain.joints[i].axis_B0;
  }
  leg.p_BF0 = chain.foot->p_BF0;
  derive_geometry(chain, leg);
  if (!has_leg_shape(leg, violations)) return std::nullopt;
  return leg;
}

}  // namespace hexagait
