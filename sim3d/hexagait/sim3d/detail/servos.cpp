// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/sim3d/detail/servos.hpp>

namespace hexagait::sim3d::detail {
namespace {

// A motor commanded to be this fast is far beyond any effort limit; faster could overflow [rad/s].
constexpr double kFastestMotor = 1e3;

}  // namespace

Servos::Servos(const WorldParams& params, const LegArray<LegJoints>& q)
    : kp_(params.servo_kp),
      gain_(params.servo_kd + params.physics_dt * params.servo_kp),
      q_(q),
      efforts_(q.size(), Vector3::Zero()),
      targets_{q, efforts_, efforts_} {}

void Servos::add(dJointID hinge, LegId leg, Eigen::Index joint, const JointLimits& limits) {
  dJointSetHingeParam(hinge, dParamCFM, 1.0 / gain_);
  servos_.push_back({hinge, leg, joint, limits});
}

void Servos::command(double age) {
  for (Servo& servo : servos_) {
    const auto of = [&servo](const LegArray<LegJoints>& all) {
      return all[servo.leg][servo.joint];
    };
    const double qd = of(targets_.qd);
    const double target =
        std::clamp(of(targets_.q) + age * qd, servo.limits.lower, servo.limits.upper);
    const double v = qd + (kp_ * (target - of(q_)) + of(targets_.effort)) / gain_;
    servo.v = std::clamp(v, -kFastestMotor, kFastestMotor);
    dJointSetHingeParam(servo.hinge, dParamVel, servo.v);
  }
}

void Servos::bound(double fraction) {
  for (Servo& servo : servos_) {
    const double last = std::abs(efforts_[servo.leg][servo.joint]);
    servo.bounded = last >= fraction * servo.limits.effort;
    dJointSetHingeParam(servo.hinge, dParamFMax, servo.bounded ? servo.limits.effort : dInfinity);
  }
}

void Servos::read_efforts() {
  for (const Servo& servo : servos_) {
    const double limit = servo.bounded ? servo.limits.effort : dInfinity;
    const double effort = gain_ * (servo.v - dJointGetHingeAngleRate(servo.hinge));
    efforts_[servo.leg][servo.joint] = std::clamp(effort, -limit, limit);
  }
}

bool Servos::some_effort_too_large() const {
  return std::ranges::any_of(servos_, [this](const Servo& servo) {
    return !(std::abs(efforts_[servo.leg][servo.joint]) <= servo.limits.effort);
  });
}

void Servos::read_positions() {
  for (const Servo& servo : servos_) {
    double& q = q_[servo.leg][servo.joint];
    q += wrap_angle(dJointGetHingeAngle(servo.hinge) - q);
  }
}

}  // namespace hexagait::sim3d::detail
