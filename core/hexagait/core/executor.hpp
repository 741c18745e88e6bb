// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/core/base_lane.hpp>
#include <hexagait/core/leg_lane.hpp>
#include <hexagait/core/plant.hpp>
#include <hexagait/core/robot_state.hpp>

namespace hexagait {

struct ExecutorParams {
  SwingParams swing;
  BaseParams base;
  double gravity = 9.81;  ///< [m/s²]; 0 feeds no load forward
};

/// The Free Gait executor for a stream of commands: a lane per leg and one for the base ([FG16]
/// II), without barriers between them.
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
/// A value: copy it to preview or to branch. advance() neither throws nor allocates.
class Executor {
 public:
  Executor(const RobotModel& model, const ExecutorParams& params);

  /// All legs in support, set points at the measured feet, base at rest.
  void reset(const RobotState& state);

  /// Takes effect in the next advance().
  void command(const Footstep& step, const RobotState& state) noexcept;
  void command(const BaseAuto& base) noexcept { base_command_ = base; }

  /// One tick: base, legs, joints.
  const JointTargets& advance(const RobotState& state, double dt) noexcept;

  /// Stops everything where it is: velocities zero, set points kept.
  void hold() noexcept;

  [[nodiscard]] const LegArray<LegLane>& legs() const { return legs_; }
  [[nodiscard]] const BaseLane& base() const { return base_; }
  [[nodiscard]] const BaseAuto& base_command() const { return base_command_; }
  [[nodiscard]] const BaseGoal& base_goal() const { return base_goal_; }
  [[nodiscard]] const JointTargets& targets() const { return targets_; }
  [[nodiscard]] const ExecutorParams& params() const { return params_; }

  /// Legs on the ground to the controller's knowledge.
  [[nodiscard]] LegSet support() const noexcept;
  /// How far odometry may rely on each foot, 0 … 1: its load, if it stands.
  [[nodiscard]] LegArray<double> footing() const noexcept;
  [[nodiscard]] PoseAdaptationInput pose_adaptation_input(const RobotState& state) const noexcept;

 private:
  void carry_with_ground(const RobotState& state, double dt) noexcept;
  void set_joints(double dt) noexcept;
  void set_efforts(const RobotState& state) noexcept;

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
};

}  // namespace hexagait
