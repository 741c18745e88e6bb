// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/plant/plant.hpp>
#include <hexagait/sim3d/detail/ode.hpp>
#include <hexagait/sim3d/world.hpp>
#include <vector>

namespace hexagait::sim3d::detail {

/// The servos of all joints, as the motors of ODE hinges. A motor's row in the solver is
///
///     q̇₊ + CFM · τ = v,   |τ| ≤ FMax
///
/// With CFM = 1/(Kd + h Kp) and v = q̇* + (Kp (q* − q) + τ*)/(Kd + h Kp) it is an implicit
/// spring-damper, which is stable for any Kp and Kd:
///
///     τ = (Kd + h Kp)(v − q̇₊) = Kp (q* + h q̇* − q − h q̇₊) + Kd (q̇* − q̇₊) + τ*
///
/// with q*, q̇*, τ* the targets, q the position before and q₊ = q + h q̇₊, q̇₊ the state after the
/// step. In velocity mode CFM = 1/Kv and v = q̇* + τ*/Kv. In effort mode CFM = 1/D and v = τ*/D,
/// with D the friction of the drive, which gives τ = τ* − D q̇₊.
///
/// With play b in the gear the position servo holds its side of it: e = q* − q counts as far as it
/// is beyond ± b/2, and within that nothing but the friction D holds the joint.
///
/// A drive at its velocity limit is a row with v = ± limit and a gain G that is greater than any
/// other. Which of its three rows a servo needs, its own or one of these, shows after the step: see
/// correct(). A rotor of inertia I is a row of its own, τ = I (q̇ − q̇₊)/h, and so is dry friction:
/// v = 0, with FMax the friction.
class Servos {
 public:
  /// Servos that hold q.
  Servos(const WorldParams& params, const LegArray<LegJoints>& q);

  /// Adds the servo of a hinge between two bodies, child first, that are at the joint's zero.
  void add(dWorldID world, dJointID hinge, LegId leg, Eigen::Index joint,
           const JointLimits& limits);

  /// Takes the servos of a leg and their hinges out of the world; their positions stay as they are.
  void cut(LegId leg);

  /// Leaves a servo this share of its effort limit.
  void weaken(LegId leg, Eigen::Index joint, double share);

  /// Sets the targets; positions reach `targets.q` at the end of the control period, at
  /// `targets.qd`.
  void set_targets(const JointTargets& targets) { targets_ = targets; }

  /// Commands the motors for one physics step, `to_come` [s] before the end of the control period.
  void command(double to_come);

  /// Makes the solver enforce the effort limits of exactly those servos whose last effort was at
  /// least this fraction of their limit.
  void bound(double fraction);

  /// Reads the effort of each servo after a step.
  void read_efforts();

  /// Did the last step not keep to what the servos can do: an effort beyond a limit that was not
  /// enforced, a speed beyond a limit, a speed limit where none was reached? Then the rows are
  /// changed, and the step is to be taken again.
  [[nodiscard]] bool correct();

  /// Reads the joint positions after a step; they are continuous past ±π.
  void read_positions();

  [[nodiscard]] const LegArray<LegJoints>& q() const { return q_; }              ///< [rad]
  [[nodiscard]] const LegArray<LegJoints>& efforts() const { return efforts_; }  ///< [N m]

 private:
  struct Motor {
    double v = 0.0;     // speed [rad/s]
    double gain = 0.0;  // 1/CFM [N m s/rad]
  };
  struct Servo {
    dJointID hinge = nullptr;
    Eigen::Quaterniond zero;  // of the child relative to the parent, at the joint's zero
    Vector3 axis;             // in the child's axes
    LegId leg = 0;
    Eigen::Index joint = 0;
    JointLimits limits;
    dJointID rotor = nullptr, brake = nullptr;  // rows of their own, if there are such
    Motor own = {};                             // as commanded, without a velocity limit
    Motor row = {};                             // in the solver
    int at_limit = 0;                           // ±1: the row is that of the velocity limit
    bool bounded = false;                       // does the solver enforce the effort limit?
  };

  [[nodiscard]] static double angle_of(const Servo& servo);
  [[nodiscard]] Motor motor_of(const Servo& servo) const;
  void follow_targets(double to_come);
  void use(Servo& servo, int at_limit);
  [[nodiscard]] Motor limit_of(const Servo& servo, int side) const;
  [[nodiscard]] bool correct_speed(Servo& servo);
  [[nodiscard]] bool some_effort_too_large() const;

  double h_;          // physics step [s]
  double kp_, gain_;  // gain = Kd + h Kp
  double kv_, friction_;
  double limit_gain_;  // G of velocity limits; 0: there are none
  double share_;       // of the way to a target that a servo with lag goes in a step
  double armature_, drive_friction_;
  double half_play_;  // of the gears [rad]
  std::vector<Servo> servos_;
  LegArray<LegJoints> q_, efforts_;
  JointTargets targets_;
  LegArray<LegJoints> q_wanted_, qd_wanted_, effort_wanted_;  // now, with lag
};

}  // namespace hexagait::sim3d::detail
