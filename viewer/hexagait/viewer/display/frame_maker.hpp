// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/footstep_gen/tick_record.hpp>
#include <hexagait/gait_state/stepper.hpp>
#include <hexagait/script/action_runner.hpp>
#include <hexagait/sim/ground_truth.hpp>
#include <hexagait/viewer/display/pose_frame.hpp>

namespace hexagait::viewer {

/// The flags of a frame that tell the gait.
[[nodiscard]] std::uint8_t gait_flags(gait_state::Stepping stepping);

/// A tick of an action in the words of a walk: without heading and gait.
[[nodiscard]] footstep_gen::TickRecord as_walk(const ActionRecord& action);

/// Makes pose frames of what the loop of a walk knows, and keeps what needs more than one tick:
/// velocity, way and power. The same for a walk that is steered and for one that is recorded.
class FrameMaker {
 public:
  /// @param robot  must outlive it
  FrameMaker(const RobotModel& robot, double control_dt) : robot_(&robot), dt_(control_dt) {}

  /// Takes the robot over where it is: no way so far.
  void start(const GroundTruth& truth, const LegArray<LegJoints>& q);

  /// After each control period.
  /// @param q        joint positions at the time of `truth` [rad]
  /// @param efforts  of the servos [N m]
  void observe(const GroundTruth& truth, const LegArray<LegJoints>& q,
               const LegArray<LegJoints>& efforts);

  /// Since start() [s].
  [[nodiscard]] double time() const { return ticks_ * dt_; }

  /// The frame of the last observe(): scene, holder, lateral, gait and flags of the session are not set.
  /// @param record  what the controller made of it
  [[nodiscard]] PoseFrame frame(const footstep_gen::TickRecord& record) const;

 private:
  [[nodiscard]] Vector3 centre_of_mass() const;
  void show_heading(const footstep_gen::TickRecord& record, PoseFrame& frame) const;
  void show_gait(const footstep_gen::TickRecord& record, PoseFrame& frame) const;
  void show_legs(const footstep_gen::TickRecord& record, PoseFrame& frame) const;

  const RobotModel* robot_;
  double dt_;
  GroundTruth truth_;
  LegArray<LegJoints> q_;
  PlanarTwist velocity_;  // smoothed, axes of the body
  double power_ = 0.0, way_ = 0.0;
  std::uint32_t ticks_ = 0;
};

}  // namespace hexagait::viewer
