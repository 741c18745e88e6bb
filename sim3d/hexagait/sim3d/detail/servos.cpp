// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/sim3d/detail/servos.hpp>

namespace hexagait::sim3d::detail {
namespace {

// Bound on commanded motor speeds: far beyond any effort limit, and prevents overflow [rad/s].
constexpr double kFastestMotor = 1e3;

}  // namespace

Servos::Servos(const WorldParams& params, const LegArray<LegJoints>& q)
    : kp_(params.servo_kp),
      gain_(params.servo_kd + params.physics_dt * params.servo_kp),
      kv_(params.servo_kv),
      friction_(params.servo_friction),
      q_(q),
      efforts_(q.size(), LegJoints::Zero()),
      targets_{q, efforts_, efforts_} {}

void Servos::add(dJointID hinge, LegId leg, Eigen::Index joint, const JointLimits& limits) {
  dJointSetHingeParam(hinge, dParamCFM, 1.0 / gain_);
  servos_.push_back({.hinge = hinge, .leg = leg, .joint = joint, .limits = limits, .gain = gain_});
}

void Servos::command(double to_come) {
  for (Servo& servo : servos_) {
    const Motor motor = motor_of(servo, to_come);
    servo.v = std::clamp(motor.v, -kFastestMotor, kFastestMotor);
    dJointSetHingeParam(servo.hinge, dParamVel, servo.v);
    if (motor.gain == servo.gain) continue;
    servo.gain = motor.gain;
    dJointSetHingeParam(servo.hinge, dParamCFM, 1.0 / servo.gain);
  }
}

Servos::Motor Servos::motor_of(const Servo& servo, double to_come) const {
  const auto of = [&servo](const LegArray<LegJoints>& all) { return all[servo.leg][servo.joint]; };
  const double q = of(q_), qd = of(targets_.qd), effort = of(targets_.effort);
  const auto within = [&servo](double angle) {
    return std::clamp(angle, servo.limits.lower, servo.limits.upper);
  };
  const bool moded = servo.leg < targets_.mode.size();
  const ControlMode mode = moded ? targets_.mode[servo.leg] : ControlMode::position;
  if (mode == ControlMode::position)
    return {qd + (kp_ * (within(of(targets_.q) - to_come * qd) - q) + effort) / gain_, gain_};

  // A joint driven against its limit is held there by the position servo.
  const bool by_velocity = mode == ControlMode::velocity;
  const double drive = by_velocity ? qd : effort;
  if (drive > 0.0 ? q >= servo.limits.upper : q <= servo.limits.lower)
    return {kp_ * (within(q) - q) / gain_, gain_};
  return by_velocity ? Motor{qd + effort / kv_, kv_} : Motor{effort / friction_, friction_};
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
    const double effort = servo.gain * (servo.v - dJointGetHingeAngleRate(servo.hinge));
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
