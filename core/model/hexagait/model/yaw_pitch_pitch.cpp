// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/model/yaw_pitch_pitch.hpp>

namespace hexagait {
namespace {

constexpr double kRounding = 1e-9;  // tolerated excess over the reach [m]
constexpr double kOnAxis = 1e-12;   // feet closer to an axis count as on it [m]
constexpr double kFarAway = 1e6;    // targets are clamped to this, so that squares stay finite [m]

double canonical(const LegModel& leg, int joint, double q) {
  return leg.joint_sign[joint] * q + leg.joint_offset[joint];
}

/// The joint value of the canonical angle k, modulo 2π nearest to the middle of the limits.
double joint_value(const LegModel& leg, int joint, double k) {
  const JointLimits& limits = leg.limits[joint];
  const double q = leg.joint_sign[joint] * (k - leg.joint_offset[joint]);
  if (within(limits, q)) return q;
  const double middle = 0.5 * (limits.lower + limits.upper);
  return middle + wrap_angle(q - middle);
}

/// The vertical plane of the leg, and the foot in it.
struct LegPlane {
  double q = 0.0;           ///< yaw joint [rad]
  double c = 1.0, s = 0.0;  ///< of the canonical yaw
  double r = 0.0;           ///< distance of the foot from the yaw axis, in the plane [m]
  bool contains_foot = false;
};

LegPlane leg_plane(const LegModel& leg, double x, double y) {
  const double r = std::sqrt(x * x + y * y);
  const bool on_axis = r < kOnAxis;
  const double c = on_axis ? 1.0 : x / r, s = on_axis ? 0.0 : y / r;
  const double q = joint_value(leg, 0, on_axis ? 0.0 : portable::atan2(y, x));
  if (within(leg.limits[0], q)) return {q, c, s, r, true};

  const double q_back = joint_value(leg, 0, portable::atan2(-s, -c));
  if (within(leg.limits[0], q_back)) return {q_back, -c, -s, -r, true};

  const double q_limit = std::clamp(q, leg.limits[0].lower, leg.limits[0].upper);
  const double k = canonical(leg, 0, q_limit);
  const auto [s1, c1] = portable::sincos(k);
  return {q_limit, c1, s1, x * c1 + y * s1, on_axis};
}

bool inside(const JointLimits& limits, double q) { return limits.lower <= q && q <= limits.upper; }

/// Clamps the joints to their limits and updates the trig if that moved one.
void limit(const LegModel& leg, LegSolution& solution) {
  LegJoints& q = solution.q;
  if (inside(leg.limits[0], q[0]) && inside(leg.limits[1], q[1]) && inside(leg.limits[2], q[2]))
    return;
  for (int i = 0; i < 3; ++i) {
    solution.reachable = solution.reachable && within(leg.limits[i], q[i]);
    q[i] = std::clamp(q[i], leg.limits[i].lower, leg.limits[i].upper);
  }
  solution.trig = YawPitchPitchLeg::leg_trig(leg, q);
}

}  // namespace

LegTrig YawPitchPitchLeg::leg_trig(const LegModel& leg, const LegJoints& q) noexcept {
  const double k1 = canonical(leg, 0, q[0]), k2 = canonical(leg, 1, q[1]);
  const double k23 = k2 + canonical(leg, 2, q[2]);
  LegTrig trig;
  const portable::SinCos yaw = portable::sincos(k1), hip = portable::sincos(k2),
                         tibia = portable::sincos(k23);
  trig.c.head<3>() << yaw.c, hip.c, tibia.c;
  trig.s.head<3>() << yaw.s, hip.s, tibia.s;
  return trig;
}

Vector3 YawPitchPitchLeg::foot_position(const LegModel& leg, const LegTrig& trig) noexcept {
  const double r = leg.coxa + leg.femur * trig.c[1] + leg.tibia * trig.c[2];
  const double h = -leg.femur * trig.s[1] - leg.tibia * trig.s[2];
  return leg.X_BH * Vector3(r * trig.c[0], r * trig.s[0], h);
}

LegJacobian YawPitchPitchLeg::foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept {
  const double tibia_r = leg.tibia * trig.c[2], tibia_h = -leg.tibia * trig.s[2];
  const double pitch_r = leg.femur * trig.c[1] + tibia_r, h = -leg.femur * trig.s[1] + tibia_h;
  const double r = leg.coxa + pitch_r;

  // A pitch turns (r, h) in the leg's plane into (h, −r), measured from the axis it turns about.
  Matrix3 J_H;
  J_H << -r * trig.s[0], h * trig.c[0], tibia_h * trig.c[0],  //
      r * trig.c[0], h * trig.s[0], tibia_h * trig.s[0],      //
      0.0, -pitch_r, -tibia_r;
  LegJacobian J = LegJacobian::Zero();
  J.leftCols<3>() = leg.X_BH.R * J_H * leg.joint_sign.asDiagonal();
  return J;
}

Matrix3 YawPitchPitchLeg::tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept {
  Matrix3 R_HT;
  R_HT << trig.c[0] * trig.c[2], -trig.s[0], trig.c[0] * trig.s[2],  //
      trig.s[0] * trig.c[2], trig.c[0], trig.s[0] * trig.s[2],       //
      -trig.s[2], 0.0, trig.c[2];
  return leg.X_BH.R * R_HT;
}

Vector3 YawPitchPitchLeg::tibia_turn(const LegModel& leg, const LegTrig& trig,
                                     const LegJoints& dq) noexcept {
  const Vector3 dk = leg.joint_sign.cwiseProduct(dq.head<3>());
  // The pitch axis at half the yaw: the joints move together.
  const double half = 0.5 * dk[0];
  const Vector3 pitch_axis_H(-trig.s[0] - half * trig.c[0], trig.c[0] - half * trig.s[0], 0.0);
  return leg.X_BH.R * (dk[0] * Vector3::UnitZ() + (dk[1] + dk[2]) * pitch_axis_H);
}

LegSolution YawPitchPitchLeg::inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                                 const LegJoints&) noexcept {
  assert(0.0 < leg.min_reach && leg.min_reach <= leg.max_reach);
  const Vector3 p_HF =
      (leg.X_BH.R.transpose() * (p_BF - leg.X_BH.p)).cwiseMax(-kFarAway).cwiseMin(kFarAway);
  const LegPlane plane = leg_plane(leg, p_HF.x(), p_HF.y());

  // The foot relative to the hip-pitch axis: a outwards, b down, at the distance d.
  double a = plane.r - leg.coxa, b = -p_HF.z();
  const double asked = std::sqrt(a * a + b * b);
  const double d = std::clamp(asked, leg.min_reach, leg.max_reach);
  if (d != asked) {
    a = asked < kOnAxis ? 0.0 : a * (d / asked);
    b = asked < kOnAxis ? d : b * (d / asked);
  }

  // The knee by the law of cosines; the hip by rotating the bent leg (A, B) onto (a, b).
  const double f = leg.femur, t = leg.tibia;
  const double c3 = std::clamp((d * d - f * f - t * t) / (2.0 * f * t), -1.0, 1.0);
  const double s3 = std::sqrt(1.0 - c3 * c3);
  const double A = f + t * c3, B = t * s3;
  const double c2 = (A * a + B * b) / (d * d), s2 = (A * b - B * a) / (d * d);

  LegSolution solution;
  solution.q.head<3>() << plane.q, joint_value(leg, 1, portable::atan2(s2, c2)),
      joint_value(leg, 2, portable::atan2(s3, c3));
  solution.trig.c.head<3>() << plane.c, c2, c2 * c3 - s2 * s3;
  solution.trig.s.head<3>() << plane.s, s2, s2 * c3 + c2 * s3;
  solution.reachable = plane.contains_foot && std::abs(d - asked) < kRounding;
  limit(leg, solution);
  return solution;
}

}  // namespace hexagait
