// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/model/yaw_pitch_pitch.hpp>

namespace hexagait {
namespace {

using detail::canonical;
using detail::joint_value;
using detail::twice_atan;

constexpr double kReachRounding = 1e-9;  // tolerated excess over the reach [m]
constexpr double kOnAxis = YawPitchPitchLeg::kOnAxis;

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

/// Are the three joints within their limits?
bool inside(const LegModel& leg, const LegJoints& q) {
  const auto inside = [&](int k) {
    return leg.limits[k].lower <= q[k] && q[k] <= leg.limits[k].upper;
  };
  return inside(0) && inside(1) && inside(2);
}

/// Clamps the joints to their limits and updates the trig if that moved one.
void limit(const LegModel& leg, LegSolution& solution) {
  LegJoints& q = solution.q;
  if (inside(leg, q)) return;
  for (int i = 0; i < 3; ++i) {
    solution.reachable = solution.reachable && within(leg.limits[i], q[i]);
    q[i] = std::clamp(q[i], leg.limits[i].lower, leg.limits[i].upper);
  }
  solution.trig = YawPitchPitchLeg::leg_trig(leg, q);
}

/// Hip and knee of a leg whose foot is a outwards and b down from the hip-pitch axis, within its
/// reach: the knee by the law of cosines, the hip by rotating the bent leg (A, B) onto (a, b).
struct Bend {
  double c2, s2, c3, s3;
};

inline Bend bend(const LegModel& leg, double a, double b) {
  const double f = leg.femur, t = leg.tibia, d2 = a * a + b * b;
  const double c3 = std::clamp((d2 - f * f - t * t) / (2.0 * f * t), -1.0, 1.0);
  const double s3 = std::sqrt(1.0 - c3 * c3);
  const double A = f + t * c3, B = t * s3;
  return {(A * a + B * b) / d2, (A * b - B * a) / d2, c3, s3};
}

/// @param c, s  of the canonical yaw
void set_trig(LegTrig& trig, double c, double s, const Bend& bend) {
  const auto& [c2, s2, c3, s3] = bend;
  trig.c.head<3>() << c, c2, c2 * c3 - s2 * s3;
  trig.s.head<3>() << s, s2, s2 * c3 + c2 * s3;
}

// Canonical angles, and one that stays 0: processors compute them in pairs.
using Angles = Eigen::Array4d;

/// Joint values of solution.trig, by how little they differ from those of `near`; false if they
/// differ by more.
bool turn_little(const LegModel& leg, const LegJoints& near, const LegTrig& near_trig,
                 LegSolution& solution) {
  const Angles c0 = near_trig.c.head<4>(), s0 = near_trig.s.head<4>();
  const Angles c1 = solution.trig.c.head<4>(), s1 = solution.trig.s.head<4>();
  const Angles u = (s1 * c0 - c1 * s0) / (1.0 + (c1 * c0 + s1 * s0));
  if (!(u.abs() <= YawPitchPitchLeg::kLittle).all()) return false;
  const Angles turn = twice_atan(u);
  solution.q.head<3>() =
      near.head<3>() + leg.joint_sign.cwiseProduct(Vector3(turn[0], turn[1], turn[2] - turn[1]));
  return true;
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
  return detail::last_link_rotation(leg, {trig.s[0], trig.c[0]}, {trig.s[2], trig.c[2]});
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

  const Bend bent = bend(leg, a, b);
  LegSolution solution;
  solution.q.head<3>() << plane.q, joint_value(leg, 1, portable::atan2(bent.s2, bent.c2)),
      joint_value(leg, 2, portable::atan2(bent.s3, bent.c3));
  set_trig(solution.trig, plane.c, plane.s, bent);
  solution.reachable = plane.contains_foot && std::abs(d - asked) < kReachRounding;
  limit(leg, solution);
  return solution;
}

LegSolution YawPitchPitchLeg::inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                                 const LegJoints& near,
                                                 const LegTrig& near_trig) noexcept {
  const Vector3 p_HF = leg.X_BH.R.transpose() * (p_BF - leg.X_BH.p);
  const double r = std::sqrt(p_HF.x() * p_HF.x() + p_HF.y() * p_HF.y());
  const double a = r - leg.coxa, b = -p_HF.z(), d2 = a * a + b * b;
  const bool usual =
      r >= kOnAxis && d2 >= leg.min_reach * leg.min_reach && d2 <= leg.max_reach * leg.max_reach;
  if (usual) {
    LegSolution solution;
    set_trig(solution.trig, p_HF.x() / r, p_HF.y() / r, bend(leg, a, b));
    solution.reachable = true;
    if (turn_little(leg, near, near_trig, solution) && inside(leg, solution.q)) return solution;
  }
  return inverse_kinematics(leg, p_BF, near);
}

}  // namespace hexagait
