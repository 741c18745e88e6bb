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
/// so with CFM = 1/(Kd + h Kp) and v = q̇* + (Kp (q* − q) + τ*)/(Kd + h Kp) it is a spring-damper
/// that looks one step ahead, which makes it stable for any Kp and Kd:
///
///     τ = (Kd + h Kp)(v − q̇₊) = Kp (q* + h q̇* − q − h q̇₊) + Kd (q̇* − q̇₊) + τ*
///
/// with q*, q̇*, τ* the targets, q the state before and q₊ = q + h q̇₊, q̇₊ the one after the step.
/// By velocity CFM = 1/Kv and v = q̇* + τ*/Kv; by effort CFM = 1/D and v = τ*/D, D the friction of
/// the drive: what is left of the row is τ = τ* − D q̇₊.
class Servos {
 public:
  /// Servos that hold q.
  Servos(const WorldParams& params, const LegArray<LegJoints>& q);

  /// Takes charge of a hinge that reads zero where the joint does.
  void add(dJointID hinge, LegId leg, Eigen::Index joint, const JointLimits& limits);

  /// From now on the targets are these, and they move at `targets.qd`.
  void set_targets(const JointTargets& targets) { targets_ = targets; }

  /// Commands the motors for one physics step, `age` [s] after the targets were set.
  void command(double age);

  /// Tells the solver to watch the effort limits of all servos whose last effort was at least this
  /// fraction of their limit, and of no others.
  void bound(double fraction);

  /// After a step: what each servo did.
  void read_efforts();

  /// Did a servo that the solver did not watch exceed its limit (or fail to be a number)?
  [[nodiscard]] bool some_effort_too_large() const;

  /// After a step: joint positions from the hinges, counted on past ±π.
  void read_positions();

  [[nodiscard]] const LegArray<LegJoints>& q() const { return q_; }              ///< [rad]
  [[nodiscard]] const LegArray<LegJoints>& efforts() const { return efforts_; }  ///< [N m]

 private:
  struct Servo {
    dJointID hinge = nullptr;
    LegId leg = 0;
    Eigen::Index joint = 0;
    JointLimits limits;
    double v = 0.0;        // what the motor is commanded to do [rad/s]
    double gain = 0.0;     // 1/CFM [N m s/rad]
    bool bounded = false;  // does the solver watch the limit?
  };

  struct Motor {
    double v, gain;
  };
  [[nodiscard]] Motor motor_of(const Servo& servo, double age) const;

  double kp_, gain_;  // gain = Kd + h Kp
  double kv_, friction_;
  std::vector<Servo> servos_;
  LegArray<LegJoints> q_, efforts_;
  JointTargets targets_;
};

}  // namespace hexagait::sim3d::detail
