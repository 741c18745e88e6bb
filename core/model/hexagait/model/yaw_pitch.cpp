// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/model/yaw_and_pitches.hpp>
#include <hexagait/model/yaw_pitch.hpp>

namespace hexagait {
namespace {

constexpr double kSineRounding = 1e-9;  // tolerated excess of a sine over its range

double reach(const LegModel& leg, const LegTrig& trig) { return leg.coxa + leg.femur * trig.c[1]; }

// The angle in [−π/2, π/2] whose sine is closest to s.
struct Arcsine {
  double angle = 0.0;
  bool exact = false;
};

Arcsine arcsine(double s) {
  const double inside = std::clamp(s, -1.0, 1.0);
  return {portable::atan2(inside, std::sqrt(1.0 - inside * inside)),
          std::abs(s) <= 1.0 + kSineRounding};
}

// The joint value of a canonical angle, moved into its limits; is that exact?
struct LimitedJoint {
  double q = 0.0;
  bool within = false;
};

LimitedJoint limited_joint(const LegModel& leg, int joint, double k) {
  const JointLimits& limits = leg.limits[joint];
  const double q = detail::joint_value(leg, joint, k);
  return {std::clamp(q, limits.lower, limits.upper), within(limits, q)};
}

}  // namespace

LegTrig YawPitchLeg::leg_trig(const LegModel& leg, const LegJoints& q) noexcept {
  LegTrig trig;
  for (int i = 0; i < 2; ++i) {
    const auto [s, c] = portable::sincos(detail::canonical(leg, i, q[i]));
    trig.c[i] = c;
    trig.s[i] = s;
  }
  return trig;
}

Vector3 YawPitchLeg::foot_position(const LegModel& leg, const LegTrig& trig) noexcept {
  const double r = reach(leg, trig);
  return leg.X_BH * Vector3(r * trig.c[0], r * trig.s[0], -leg.femur * trig.s[1]);
}

LegJacobian YawPitchLeg::foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept {
  const double r = reach(leg, trig), h = -leg.femur * trig.s[1];
  LegJacobian J = LegJacobian::Zero();
  J.col(0) = leg.joint_sign[0] * (leg.X_BH.R * Vector3(-r * trig.s[0], r * trig.c[0], 0.0));
  J.col(1) = leg.joint_sign[1] *
             (leg.X_BH.R * Vector3(h * trig.c[0], h * trig.s[0], -leg.femur * trig.c[1]));
  return J;
}

LegJoints YawPitchLeg::foot_effort(const LegModel& leg, const LegTrig& trig,
                                   const Vector3& force_B) noexcept {
  return foot_jacobian(leg, trig).transpose() * force_B;
}

Matrix3 YawPitchLeg::tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept {
  return detail::last_link_rotation(leg, {trig.s[0], trig.c[0]}, {trig.s[1], trig.c[1]});
}

Vector3 YawPitchLeg::tibia_turn(const LegModel& leg, const LegTrig& trig,
                                const LegJoints& dq) noexcept {
  return detail::last_link_turn(leg, {trig.s[0], trig.c[0]}, leg.joint_sign[0] * dq[0],
                                leg.joint_sign[1] * dq[1]);
}

LegSolution YawPitchLeg::inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                            const LegJoints&) noexcept {
  const Vector3 p_HF = leg.X_BH.R.transpose() * (p_BF - leg.X_BH.p);
  const Arcsine pitch = arcsine(-p_HF.z() / leg.femur);
  const LimitedJoint lowered = limited_joint(leg, 1, pitch.angle);

  // How far out the foot is at this height, and the yaw that puts it there fore and aft.
  LegSolution solution;
  solution.q[1] = lowered.q;
  const double r = reach(leg, leg_trig(leg, solution.q));
  const Arcsine yaw = arcsine(r > 0.0 ? p_HF.y() / r : 0.0);
  const LimitedJoint swung = limited_joint(leg, 0, yaw.angle);
  solution.q[0] = swung.q;
  solution.trig = leg_trig(leg, solution.q);
  solution.reachable = pitch.exact && yaw.exact && lowered.within && swung.within && r > 0.0;
  return solution;
}

LegSolution YawPitchLeg::inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                            const LegJoints& near, const LegTrig&) noexcept {
  return inverse_kinematics(leg, p_BF, near);
}

}  // namespace hexagait
