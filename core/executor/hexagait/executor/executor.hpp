// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/balance/whole_body.hpp>
#include <hexagait/executor/base_lane.hpp>
#include <hexagait/executor/discrete_displacement.hpp>
#include <hexagait/executor/foothold_watch.hpp>
#include <hexagait/executor/lag_watch.hpp>
#include <hexagait/executor/leg_lane.hpp>
#include <hexagait/model/stance.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/plant/plant.hpp>
#include <hexagait/plant/robot_state.hpp>

namespace hexagait {

/// What is kDerived follows from the robot's model.
struct ExecutorParams {
  SwingParams swing;
  BaseParams base;
  double gravity = kStandardGravity;  ///< [m/s²]; 0 turns the load feed-forward off
  WholeBodyController controller = WholeBodyController::kinematic;
  VirtualModelParams virtual_model;
};

/// Sets what is kDerived to what follows from the robot's model.
[[nodiscard]] ExecutorParams completed(ExecutorParams params, const RobotModel& model);

/// The Free Gait executor ([FG16] II): one lane per leg and one for the base, which move
/// independently of each other. The gait generator streams commands into it; a Sequencer adds steps
/// that wait for each other.
///
/// Every foot has a set point p_BF in the body frame. When the base moves with twist V, the ground
/// and all feet on it move the other way:
///
///     p_BF ← exp(−V dt) p_BF                                                          (executor 1)
///
/// so that the feet in support keep their distances ([PC04] eq. 5, 8). Feet in the air move along
/// and add their own motion over the ground. The set point of a foot in support starts where its
/// swing ended and is continuous.
///
/// Scripts send plans, motions over time, to the same lanes. A LegPlan in odom is tracked against
/// odometry; one in the body frame or in joints moves with the body. No joint target ever changes
/// by more than its velocity limit allows in a tick, and no effort is more than the joint's limit.
///
/// With BaseParams::displacement_period the base of a gait generator moves in discrete displacements
/// (discrete_displacement.hpp): what it does next is decided at the end of each, and legs that stand
/// move along straight lines in joint space. Plans of scripts and the virtual model stay smooth.
///
/// Targets are finite whatever is commanded: if they would not be, the executor has failed(). If the
/// program of the virtual model's contact forces has no solution in a tick (contact_forces()), the
/// efforts of that tick are those of the kinematic controller, and all joints are driven by position.
///
/// A value: copy it to preview or to branch. advance() neither throws nor allocates. The robot
/// model must outlive the executor.
class Executor {
 public:
  Executor(const RobotModel& model, const ExecutorParams& params);
  Executor(const RobotModel&&, const ExecutorParams&) = delete;

  /// Starts from the present state: all legs in support (on hold if the robot rests on its belly),
  /// set points at the measured feet, base at rest. Keeps the space that was reserved.
  void reset(const RobotState& state, RestsOn rests_on = RestsOn::feet);

  // Commands of a gait generator. They take effect in the next advance().
  void command(const FootstepCommand& step, const RobotState& state) noexcept;
  void command(const BaseAutoCommand& base) noexcept { base_command_ = base; }

  // Plans of scripts. A plan with more knots than reserve() allowed for allocates.
  // `begin` is the time at which the plan starts: by how much the previous step has overrun [s].
  void command(LegId leg, const LegPlan& plan, const RobotState& state,
               double begin = 0.0) noexcept;
  void command(const BasePlan& plan, double begin = 0.0) noexcept;
  void reserve(int foot_knots, int joint_knots, int base_knots);

  /// Where the feet stand best from now on; until then, and after construction, that of the model.
  /// reset() keeps it.
  /// @pre check_stance() accepts it
  void set_stance(const Stance& stance) noexcept { stance_ = stance; }
  [[nodiscard]] const Stance& stance() const { return stance_; }

  /// The leg takes no part from now on: it never supports, commands to it do nothing, and it is tucked
  /// up, if it can be. reset() keeps it so.
  void lose(LegId leg) noexcept;
  [[nodiscard]] LegSet lost() const { return lost_; }
  /// Lets these feet, if they are up, descend at once, and not go on to their footholds.
  void put_down(LegSet legs) noexcept;
  /// Legs that begin no step of their own until told otherwise; after construction and reset() there are none.
  /// One that loses its contact looks for it where it stands, and stays there if it is blocked.
  void set_staying(LegSet legs) noexcept { staying_ = legs; }
  /// Where the centre of mass of a robot with all its legs is from now on [m]. Until then, and after
  /// construction, where the model has it in the nominal stance. reset() keeps it.
  void set_centre_of_mass(const Vector3& p_BM) noexcept { posture_shift_ = p_BM - model_->p_BM; }
  /// Centre of mass: as set; with a lost leg, in the nominal stance, half-way from the model's to where it
  /// is without the leg, of which nobody knows whether it hangs or is gone [m].
  [[nodiscard]] Vector3 p_BM() const {
    return model_->p_BM + (lost_.empty() ? posture_shift_ : lost_shift_);
  }

  /// Rate of the plans' time: 1 as planned, 0 paused.
  void set_rate(double rate) noexcept { rate_ = rate; }

  /// Ends the leg's plan. A foot in the air is lowered to the ground if `to_stand`.
  void interrupt(LegId leg, bool to_stand) noexcept { hexagait::interrupt(legs_[leg], to_stand); }

  /// Ends the base's plan and brings the base to rest.
  void interrupt_base() noexcept;

  /// Takes note of the contacts. Called before decisions that need to know who stands; otherwise
  /// advance() does it.
  void sense(const RobotState& state, double dt) noexcept;

  /// One control period: base, legs, joints.
  const JointTargets& advance(const RobotState& state, double dt) noexcept;

  /// A control period without a measurement: base and feet go on as they were and brake, with their
  /// limits of acceleration, until they rest. Plans go on at their rate.
  /// @param state  the last one
  const JointTargets& coast(const RobotState& state, double dt) noexcept;

  /// Stops at once: velocities are set to 0, set points kept.
  void hold() noexcept;

  [[nodiscard]] const LegArray<LegLane>& legs() const { return legs_; }
  [[nodiscard]] const BaseLane& base() const { return base_; }
  [[nodiscard]] const BaseAutoCommand& base_command() const { return base_command_; }
  [[nodiscard]] const BaseGoal& base_goal() const { return base_goal_; }
  [[nodiscard]] const LegArray<LegPlan>& plans() const { return plans_; }
  /// Does the base follow a plan, or hold the pose at its end?
  [[nodiscard]] bool base_follows() const { return base_follows_; }
  [[nodiscard]] const BasePlan& base_plan() const { return base_plan_; }
  [[nodiscard]] double base_time() const { return base_time_; }
  /// Pose and twist of the base according to its plan, if it follows one.
  [[nodiscard]] const BaseState& base_planned() const { return base_planned_; }
  [[nodiscard]] bool reachable(LegId leg) const { return reachable_[leg]; }
  [[nodiscard]] const JointTargets& targets() const { return targets_; }
  /// Would targets not have been finite? Then a command or a parameter is not, or is absurd, and the
  /// set points are lost: the last good targets are held until reset().
  [[nodiscard]] bool failed() const { return failed_; }
  /// Was the program of the contact forces solved in the last tick? Always if kinematic.
  [[nodiscard]] QpStatus contact_forces() const { return contact_forces_; }
  /// Distance of a foot in the air from where a drive with lag has it, as of the last tick [m].
  [[nodiscard]] double tracking_error(LegId leg) const { return lag_.error(leg); }
  /// From its set point to the measured foot, in the body frame, as of the last tick [m].
  [[nodiscard]] const Vector3& off(LegId leg) const { return off_[leg]; }
  /// Lag of the drives, as estimated [s].
  [[nodiscard]] double drive_lag() const { return lag_.lag(); }
  /// The least lag of the drives, (lag 3) [s].
  [[nodiscard]] double least_drive_lag() const { return lag_.least_lag(); }
  [[nodiscard]] const ExecutorParams& params() const { return params_; }
  /// Do set points hold the robot, so that what a standing leg is off its own tells of its load? Not in scripts, whose feet
  /// may push against each other on purpose, with legs of two joints, whose feet slide, nor where efforts drive the legs.
  [[nodiscard]] bool held_by_set_points() const noexcept {
    return params_.swing.reflexes && !model_->legs[0].has_two_joints() &&
           params_.controller == WholeBodyController::kinematic;
  }

  /// Legs that count as standing.
  [[nodiscard]] LegSet support() const noexcept {
    LegSet support;
    for (LegId i = 0; i < legs_.size(); ++i) support.set(i, legs_[i].supports(params_.swing));
    return support;
  }
  /// Those of them that feel nothing, or have not yet for touch_time since they last did, or whose foothold gives way.
  [[nodiscard]] LegSet unsure() const noexcept;
  /// Legs whose foothold gives way: the foot slides, or rolls off an edge.
  [[nodiscard]] LegSet giving_way() const { return footholds_.giving_way(); }
  /// Legs on footholds that don't stop giving way.
  [[nodiscard]] LegSet bad_footholds() const { return footholds_.bad(); }
  /// Weight of each foot in odometry, 0 … 1: the fraction of its load that it carries.
  [[nodiscard]] LegArray<double> footing() const noexcept;
  [[nodiscard]] PoseAdaptationInput pose_adaptation_input(const RobotState& state) const noexcept;

 private:
  void carry_with_ground(const RobotState& state, double dt) noexcept;
  void move(const RobotState& state, double dt) noexcept;
  void move_base(const RobotState& state, double dt) noexcept;
  void take_base_on(const RobotState& state, double dt) noexcept;
  void begin_displacement(const RobotState& state, double dt) noexcept;
  void join_displacement(LegId leg, const RobotState& state, double time) noexcept;
  [[nodiscard]] LegSolution on_its_line(LegId leg, const RobotState& state, double dt) noexcept;
  [[nodiscard]] bool drags_a_foot() const noexcept;
  [[nodiscard]] bool runs_from_a_foot() const noexcept;
  void follow_base(const RobotState& state, double dt) noexcept;
  void go_on(const RobotState& state, double dt) noexcept;
  void note_tracking(const RobotState& state, double dt) noexcept;
  void move_legs(const RobotState& state, double dt) noexcept;
  [[nodiscard]] bool is_needed(LegId leg, const RobotState& state) const noexcept;
  void tuck(LegId leg, double dt) noexcept;
  void even_out_loads(const RobotState& state, double dt) noexcept;
  void stand_where_it_is(LegId leg, const RobotState& state) noexcept;
  void set_joints(const RobotState& state, double dt) noexcept;
  [[nodiscard]] bool pair_goes_on(LegId first, double dt) noexcept;
  void set_joints(LegId leg, const RobotState& state, double dt) noexcept;
  void set_efforts(const RobotState& state, double dt) noexcept;
  void add_planned_efforts(LegId leg, LegJoints& effort, const RobotState& state,
                           double dt) noexcept;
  void set_effort(LegId leg, const LegJoints& effort) noexcept;
  void update_base_error(const RobotState& state, double dt) noexcept;
  [[nodiscard]] bool led_by_joints(LegId leg) const noexcept;
  [[nodiscard]] bool is_discrete() const noexcept;
  [[nodiscard]] LegSolution wanted_joints(LegId leg, const RobotState& state) noexcept;
  [[nodiscard]] LegJoints planned_effort(LegId leg, const RobotState& state) const noexcept;

  const RobotModel* model_;
  ExecutorParams params_;
  Stance stance_;
  LegSet lost_, staying_;
  Vector3 posture_shift_ = Vector3::Zero();  ///< of the centre of mass [m]
  Vector3 lost_shift_ = Vector3::Zero();     ///< of the centre of mass, with legs lost [m]
  LegArray<LegLane> legs_;
  LegArray<LegTrig> trig_;           ///< of the joint targets
  LegArray<LegJoints> last_change_;  ///< of the joint targets in the last tick [rad]
  LegArray<bool> reachable_;
  LagWatch lag_;
  FootholdWatch footholds_;
  bool sensed_ = false;    ///< in this tick
  LegSet adds_effort_;     ///< legs whose planned_effort_ is not zero
  LegArray<Vector3> off_;  ///< from the last set points to the measured feet [m]
  BaseLane base_;
  DiscreteDisplacement displacement_;
  BaseAutoCommand base_command_;
  BaseGoal base_goal_;
  JointTargets targets_;

  bool failed_ = false;
  double rate_ = 1.0;
  LegArray<LegPlan> plans_;
  LegArray<LegJoints> planned_effort_;  ///< after ramping [N m]
  BasePlan base_plan_;
  bool base_follows_ = false;
  double base_time_ = 0.0;  ///< time in its plan [s]
  BaseState base_planned_;  ///< at that time

  // Virtual model: desired pose of the base, by its plan, or integrated from where the plan ended.
  Pose X_OD_;
  BaseError base_error_;
  QpStatus contact_forces_ = QpStatus::solved;

  int foot_knots_ = 0, joint_knots_ = 0, base_knots_ = 0;  ///< reserved
};

}  // namespace hexagait
