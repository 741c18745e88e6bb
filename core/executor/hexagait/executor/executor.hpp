// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/balance/whole_body.hpp>
#include <hexagait/executor/base_lane.hpp>
#include <hexagait/executor/leg_lane.hpp>
#include <hexagait/plant/plant.hpp>
#include <hexagait/plant/robot_state.hpp>

namespace hexagait {

struct ExecutorParams {
  SwingParams swing;
  BaseParams base;
  double gravity = 9.81;  ///< [m/s²]; 0 feeds no load forward
  WholeBodyController controller = WholeBodyController::kinematic;
  VirtualModelParams virtual_model;
};

/// The Free Gait executor: a lane per leg and one for the base ([FG16] II), without barriers
/// between them: the gait generator streams commands into it. Steps that wait for each other:
/// Sequencer.
///
/// Every foot has a set point p_BF in the body frame. When the base is to move with twist V, the
/// ground, and with it every foot, goes the other way:
///
///     p_BF ← exp(−V dt) p_BF                                                          (executor 1)
///
/// so that the feet in support keep their distances ([PC04] eq. 5, 8), and a foot in the air is
/// carried along; what it does over the ground comes on top. The set point of a foot in support
/// starts where its swing ended and is continuous by construction.
///
/// Scripts send plans, motions over time, to the same lanes; a LegPlan in odom is tracked against
/// odometry, one in the body frame or in joints moves with the body. No joint target ever changes
/// by more than its velocity limit allows in a tick, whatever is commanded when.
///
/// A value: copy it to preview or to branch. advance() neither throws nor allocates.
class Executor {
 public:
  Executor(const RobotModel& model, const ExecutorParams& params);

  /// All legs in support, or of a robot that lies on hold; set points at the measured feet, base at
  /// rest.
  void reset(const RobotState& state, RestsOn rests_on = RestsOn::feet);

  /// Takes effect in the next advance().
  void command(const Footstep& step, const RobotState& state) noexcept;
  void command(const BaseAuto& base) noexcept { base_command_ = base; }

  // Motions over time, of scripts. A plan that needs more room than reserve() made would allocate.
  // `begin` is the time in the plan at which it starts: what a step before it has overshot [s].
  void command(LegId leg, const LegPlan& plan, const RobotState& state,
               double begin = 0.0) noexcept;
  void command(const BasePlan& plan, double begin = 0.0) noexcept;
  void reserve(int foot_knots, int joint_knots, int base_knots);

  /// How fast the time of plans goes: 0 stands still, 1 as planned.
  void set_rate(double rate) noexcept { rate_ = rate; }

  /// Ends the leg's plan where it is: in the air, the foot goes down if it is to stand.
  void interrupt(LegId leg, bool to_stand) noexcept { hexagait::interrupt(legs_[leg], to_stand); }

  /// Ends the base's plan: the base comes to rest.
  void interrupt_base() noexcept;

  /// One tick: base, legs, joints.
  const JointTargets& advance(const RobotState& state, double dt) noexcept;

  /// Stops everything where it is: velocities zero, set points kept.
  void hold() noexcept;

  [[nodiscard]] const LegArray<LegLane>& legs() const { return legs_; }
  [[nodiscard]] const BaseLane& base() const { return base_; }
  [[nodiscard]] const BaseAuto& base_command() const { return base_command_; }
  [[nodiscard]] const BaseGoal& base_goal() const { return base_goal_; }
  [[nodiscard]] const LegArray<LegPlan>& plans() const { return plans_; }
  /// The base follows a plan, or holds the pose at its end.
  [[nodiscard]] bool base_follows() const { return base_follows_; }
  [[nodiscard]] const BasePlan& base_plan() const { return base_plan_; }
  [[nodiscard]] double base_time() const { return base_time_; }
  /// Where its plan wants the base now, if it follows one.
  [[nodiscard]] const BaseState& base_planned() const { return base_planned_; }
  [[nodiscard]] bool reachable(LegId leg) const { return reachable_[leg]; }
  [[nodiscard]] const JointTargets& targets() const { return targets_; }
  [[nodiscard]] const ExecutorParams& params() const { return params_; }

  /// Legs on the ground to the controller's knowledge.
  [[nodiscard]] LegSet support() const noexcept;
  /// How far odometry may rely on each foot, 0 … 1: its load, if it stands.
  [[nodiscard]] LegArray<double> footing() const noexcept;
  [[nodiscard]] PoseAdaptationInput pose_adaptation_input(const RobotState& state) const noexcept;

 private:
  void carry_with_ground(const RobotState& state, double dt) noexcept;
  void move_base(const RobotState& state, double dt) noexcept;
  void follow_base(const RobotState& state, double dt) noexcept;
  void move_legs(const RobotState& state, double dt) noexcept;
  void set_joints(const RobotState& state, double dt) noexcept;
  void set_efforts(const RobotState& state, double dt) noexcept;
  void stretch_springs(const RobotState& state, double dt) noexcept;
  [[nodiscard]] bool led_by_joints(LegId leg) const noexcept;
  [[nodiscard]] LegSolution wanted_joints(LegId leg, const RobotState& state) noexcept;
  [[nodiscard]] LegJoints planned_effort(LegId leg, const RobotState& state) const noexcept;

  const RobotModel* model_;
  ExecutorParams params_;
  LegArray<LegLane> legs_;
  LegArray<LegTrig> trig_;           ///< of the joint targets
  LegArray<LegJoints> last_change_;  ///< of the joint targets, in the last tick [rad]
  LegArray<bool> reachable_;
  BaseLane base_;
  BaseAuto base_command_;
  BaseGoal base_goal_;
  JointTargets targets_;

  double rate_ = 1.0;
  LegArray<LegPlan> plans_;
  LegArray<LegJoints> planned_effort_;  ///< as it has ramped so far [N m]
  BasePlan base_plan_;
  bool base_follows_ = false;
  double base_time_ = 0.0;  ///< in its plan [s]
  BaseState base_planned_;  ///< at that time

  // Of the virtual model: the base as it is to be, by its plan or, without one, held and moved on
  // from where that left it.
  Pose X_OD_;
  BaseError base_error_;
};

}  // namespace hexagait
