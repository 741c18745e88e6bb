// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/step_frames.hpp>
#include <hexagait/balance/stance_pose.hpp>
#include <hexagait/executor/executor.hpp>

namespace hexagait {

/// How the base is best held over feet: optimise_stance(), or another strategy of the program
/// ([FG16] II-D: "should be adapted for different types of robots").
using StanceStrategy = StancePose (*)(const RobotModel&, const StanceProblem&);

struct PlannerParams {
  StanceStrategy stance = optimise_stance;
  double lift_off_speed = 0.1;            ///< of a footstep, along the normal [m/s]
  double touchdown_speed = 0.2;           ///< of a footstep, against the normal [m/s]
  double min_footstep_duration = 0.45;    ///< [s]
  double min_target_duration = 0.05;      ///< of a foot's or joints' target [s]
  double min_base_auto_duration = 0.1;    ///< [s]
  double min_base_target_duration = 0.7;  ///< [s]
  /// A step that leaves the centre of mass less than this inside the legs that stand is refused
  /// [m].
  double min_margin = 0.0;
  /// A step that would tip the robot or is out of reach fails; false: is begun all the same, as in
  /// a preview, which is to show everything that is wrong.
  bool refuses = true;
};

/// All that the commands of a step are resolved by: the moment in which it starts.
struct StepStart {
  const RobotModel& model;
  const Executor& executor;
  const RobotState& state;
  const Frames& frames;
  const StepFrames& step_frames;
};

/// Resolves the command of a leg: the plan from where the leg is now to where the command wants it.
/// Targets take the time of their average rate, trajectories their own.
/// @param knots  room for a trajectory in its new frame
/// @returns nothing but the plan's fields are written; no memory is allocated after reserve()
void plan_leg(LegPlan& plan, const action::LegCommand& command, const StepStart& start,
              const PlannerParams& params, std::vector<FootKnot>& knots) noexcept;

/// Does the command leave its time to the planner? Then the plan may be stretched.
[[nodiscard]] bool rate_based(const action::LegCommand& command) noexcept;

/// The same plan in a longer time.
void stretch(LegPlan& plan, const action::LegCommand& command, double duration,
             const StepStart& start, const PlannerParams& params) noexcept;

/// Where the foot is at the end of the plan, in odom [m].
[[nodiscard]] Vector3 end_in_odom(const LegPlan& plan, LegId leg, const StepStart& start) noexcept;

}  // namespace hexagait
