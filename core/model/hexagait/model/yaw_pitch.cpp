// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/model/yaw_pitch.hpp>

namespace hexagait {
namespace {

constexpr double kRounding = 1e-9;  // tolerated excess of a sine over its range

double reach(const LegModel& leg, const LegTrig& trig) { return leg.coxa + leg.femur * trig.c[1]; }

// The angle in [−π/2, π/2] whose sine is closest to s.
struct Arcsine {
  double angle = 0.0;
  bool exact = false;
};

Arcsine arcsine(double s) {
  const double inside = std::clamp(s, -1.0, 1.0);
  return {portable::atan2(inside, std::sqrt(1.0 - inside * inside)),
          std::abs(s) <= 1.0 + kRounding};
}

// The joint value of a canonical angle, moved into its limits; is that exact?
struct JointValue {
  double q = 0.0;
  bool within = false;
};

JointValue joint_value(const LegModel& leg, int joint, double k) {
  const JointLimits& limits = leg.limits[joint];
  const double middle = 0.5 * (limits.lower + limits.upper);
  const double asked = leg.joint_sign[joint] * (k - leg.joint_offset[joint]);
  const double q = within(limits, asked) ? asked : middle + wrap_angle(asked - middle);
  return {std::clamp(q, limits.lower, limits.upper), within(limits, q)};
}

}  // namespace

LegTrig YawPitchLeg::leg_trig(const LegModel& leg, const LegJoints& q) noexcept {
  LegTrig trig;
  for (int i = 0; i < 2; ++i) {
    const auto [s, c] = portable::sincos(leg.joint_sign[i] * q[i] + leg.joint_offset[i]);
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
  Matrix3 R_HT;
  R_HT << trig.c[0] * trig.c[1], -trig.s[0], trig.c[0] * trig.s[1],  //
      trig.s[0] * trig.c[1], trig.c[0], trig.s[0] * trig.s[1],       //
      -trig.s[1], 0.0, trig.c[1];
  return leg.X_BH.R * R_HT;
}

Vector3 YawPitchLeg::tibia_turn(const LegModel& leg, const LegTrig& trig,
                                const LegJoints& dq) noexcept {
  const double yaw = leg.joint_sign[0] * dq[0], pitch = leg.joint_sign[1] * dq[1];
  // The pitch axis at half the yaw: the joints move together.
  const double half = 0.5 * yaw;
  const Vector3 pitch_axis_H(-trig.s[0] - half * trig.c[0], trig.c[0] - half * trig.s[0], 0.0);
  return leg.X_BH.R * (yaw * Vector3::UnitZ() + pitch * pitch_axis_H);
}

LegSolution YawPitchLeg::inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                            const LegJoints&) noexcept {
  const Vector3 p_HF = leg.X_BH.R.transpose() * (p_BF - leg.X_BH.p);
  const Arcsine pitch = arcsine(-p_HF.z() / leg.femur);
  const JointValue lowered = joint_value(leg, 1, pitch.angle);

  // How far out the foot is at this height, and the yaw that puts it there fore and aft.
  LegSolution solution;
  solution.q[1] = lowered.q;
  const double r = reach(leg, leg_trig(leg, solution.q));
  const Arcsine yaw = arcsine(r > 0.0 ? p_HF.y() / r : 0.0);
  const JointValue swung = joint_value(leg, 0, yaw.angle);
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
