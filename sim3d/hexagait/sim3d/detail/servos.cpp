// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/sim3d/detail/servos.hpp>

namespace hexagait::sim3d::detail {
namespace {

// Bound on commanded motor speeds: far beyond any effort limit, and prevents overflow [rad/s].
constexpr double kFastestMotor = 1e3;

// Gain of a drive at its velocity limit, in those of its servo.
constexpr double kSteepness = 10.0;

// A motor beside the servo's, about the hinge's axis and with its sign.
dJointID add_row(dWorldID world, dJointID hinge) {
  const dJointID motor = dJointCreateAMotor(world, nullptr);
  dJointAttach(motor, dJointGetBody(hinge, 0), dJointGetBody(hinge, 1));
  dVector3 axis;
  dJointGetHingeAxis(hinge, axis);
  dJointSetAMotorMode(motor, dAMotorUser);
  dJointSetAMotorNumAxes(motor, 1);
  constexpr int kWithFirstBody = 1;
  dJointSetAMotorAxis(motor, 0, kWithFirstBody, axis[0], axis[1], axis[2]);
  dJointSetAMotorParam(motor, dParamVel, 0.0);
  return motor;
}

Eigen::Quaterniond rotation_of(dBodyID body) {
  const dReal* q = dBodyGetQuaternion(body);
  return {q[0], q[1], q[2], q[3]};
}

}  // namespace

Servos::Servos(const WorldParams& params, const LegArray<LegJoints>& q)
    : h_(params.physics_dt),
      kp_(params.servo_kp),
      gain_(params.servo_kd + params.physics_dt * params.servo_kp),
      kv_(params.servo_kv),
      friction_(params.servo_friction),
      limit_gain_(params.velocity_limits ? kSteepness * std::max({gain_, kv_, friction_}) : 0.0),
      share_(h_ / (params.servo_lag + h_)),
      armature_(params.armature),
      drive_friction_(params.drive_friction),
      half_play_(0.5 * params.backlash),
      q_(q),
      efforts_(q.size(), LegJoints::Zero()),
      targets_{q, efforts_, efforts_},
      q_wanted_(q),
      qd_wanted_(efforts_),
      effort_wanted_(efforts_) {}

void Servos::add(dWorldID world, dJointID hinge, LegId leg, Eigen::Index joint,
                 const JointLimits& limits) {
  const Eigen::Quaterniond child = rotation_of(dJointGetBody(hinge, 0));
  dVector3 axis_W;
  dJointGetHingeAxis(hinge, axis_W);
  Servo servo{.hinge = hinge,
              .zero = rotation_of(dJointGetBody(hinge, 1)).conjugate() * child,
              .axis = child.conjugate() * from_ode(axis_W),
              .leg = leg,
              .joint = joint,
              .limits = limits};
  servo.own.gain = servo.row.gain = gain_;
  dJointSetHingeParam(hinge, dParamCFM, 1.0 / gain_);
  if (armature_ > 0.0) {
    servo.rotor = add_row(world, hinge);
    dJointSetAMotorParam(servo.rotor, dParamCFM, h_ / armature_);
    dJointSetAMotorParam(servo.rotor, dParamFMax, dInfinity);
  }
  if (drive_friction_ > 0.0) {
    servo.brake = add_row(world, hinge);
    dJointSetAMotorParam(servo.brake, dParamFMax, drive_friction_);
  }
  servos_.push_back(servo);
}

void Servos::cut(LegId leg) {
  for (const Servo& servo : servos_) {
    if (servo.leg != leg) continue;
    for (const dJointID joint : {servo.hinge, servo.rotor, servo.brake})
      if (joint != nullptr) dJointDestroy(joint);
    efforts_[servo.leg][servo.joint] = 0.0;
  }
  std::erase_if(servos_, [leg](const Servo& servo) { return servo.leg == leg; });
}

void Servos::weaken(LegId leg, Eigen::Index joint, double share) {
  for (Servo& servo : servos_)
    if (servo.leg == leg && servo.joint == joint) servo.limits.effort *= share;
}

void Servos::command(double to_come) {
  follow_targets(to_come);
  for (Servo& servo : servos_) {
    servo.own = motor_of(servo);
    servo.own.v = std::clamp(servo.own.v, -kFastestMotor, kFastestMotor);
    use(servo, servo.at_limit);
    if (servo.rotor != nullptr)
      dJointSetAMotorParam(servo.rotor, dParamVel, dJointGetHingeAngleRate(servo.hinge));
  }
}

// The targets at this time; those of a servo with lag come closer by the implicit rule, which is
// stable for any step.
void Servos::follow_targets(double to_come) {
  for (const Servo& servo : servos_) {
    const auto follow = [&](LegArray<LegJoints>& wanted, double target) {
      double& value = wanted[servo.leg][servo.joint];
      value = share_ < 1.0 ? value + share_ * (target - value) : target;
    };
    const auto of = [&](const LegArray<LegJoints>& all) { return all[servo.leg][servo.joint]; };
    const double q = of(targets_.q) - to_come * of(targets_.qd);
    follow(q_wanted_, std::clamp(q, servo.limits.lower, servo.limits.upper));
    follow(qd_wanted_, of(targets_.qd));
    follow(effort_wanted_, of(targets_.effort));
  }
}

Servos::Motor Servos::motor_of(const Servo& servo) const {
  const auto of = [&servo](const LegArray<LegJoints>& all) { return all[servo.leg][servo.joint]; };
  const double q = of(q_), qd = of(qd_wanted_), effort = of(effort_wanted_);
  const bool moded = servo.leg < targets_.mode.size();
  const ControlMode mode = moded ? targets_.mode[servo.leg] : ControlMode::position;
  if (mode == ControlMode::position) {
    const double error = of(q_wanted_) - q;
    const double beyond = error - std::clamp(error, -half_play_, half_play_);
    if (half_play_ > 0.0 && beyond == 0.0) return {qd, friction_};
    return {qd + (kp_ * beyond + effort) / gain_, gain_};
  }

  // A joint driven against its limit is held there by the position servo.
  const bool by_velocity = mode == ControlMode::velocity;
  const double drive = by_velocity ? qd : effort;
  if (drive > 0.0 ? q >= servo.limits.upper : q <= servo.limits.lower)
    return {kp_ * (std::clamp(q, servo.limits.lower, servo.limits.upper) - q) / gain_, gain_};
  return by_velocity ? Motor{qd + effort / kv_, kv_} : Motor{effort / friction_, friction_};
}

Servos::Motor Servos::limit_of(const Servo& servo, int side) const {
  return {side * servo.limits.velocity, limit_gain_};
}

void Servos::use(Servo& servo, int at_limit) {
  servo.at_limit = at_limit;
  const Motor row = at_limit == 0 ? servo.own : limit_of(servo, at_limit);
  dJointSetHingeParam(servo.hinge, dParamVel, row.v);
  if (row.gain != servo.row.gain) dJointSetHingeParam(servo.hinge, dParamCFM, 1.0 / row.gain);
  servo.row = row;
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
    const double effort = servo.row.gain * (servo.row.v - dJointGetHingeAngleRate(servo.hinge));
    efforts_[servo.leg][servo.joint] = std::clamp(effort, -limit, limit);
  }
}

bool Servos::correct() {
  bool again = some_effort_too_large();
  if (again) bound(0.0);
  if (limit_gain_ == 0.0) return again;
  for (Servo& servo : servos_) again = correct_speed(servo) || again;
  return again;
}

// The torque of a drive is that of its own row, but between those of the two limits. All three fall
// with the speed, that of its own row least.
bool Servos::correct_speed(Servo& servo) {
  const double speed = dJointGetHingeAngleRate(servo.hinge), most = servo.limits.effort;
  const auto torque = [&](const Motor& motor) {
    return std::clamp(motor.gain * (motor.v - speed), -most, most);
  };
  const double own = torque(servo.own);
  const int side = own > torque(limit_of(servo, 1))    ? 1
                   : own < torque(limit_of(servo, -1)) ? -1
                                                       : 0;
  if (side == servo.at_limit) return false;
  use(servo, side);
  return true;
}

bool Servos::some_effort_too_large() const {
  return std::ranges::any_of(servos_, [this](const Servo& servo) {
    return !(std::abs(efforts_[servo.leg][servo.joint]) <= servo.limits.effort);
  });
}

// ODE has this angle as well, by the C library's atan2, whose last bits depend on the processor.
double Servos::angle_of(const Servo& servo) {
  const Eigen::Quaterniond at_zero = rotation_of(dJointGetBody(servo.hinge, 1)) * servo.zero;
  const Eigen::Quaterniond turn = at_zero.conjugate() * rotation_of(dJointGetBody(servo.hinge, 0));
  return 2.0 * portable::atan2(turn.vec().dot(servo.axis), turn.w());
}

void Servos::read_positions() {
  for (const Servo& servo : servos_) {
    double& q = q_[servo.leg][servo.joint];
    q += wrap_angle(angle_of(servo) - q);
  }
}

}  // namespace hexagait::sim3d::detail
