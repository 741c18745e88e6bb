// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/step_frames.hpp>
#include <hexagait/balance/stance_pose.hpp>
#include <hexagait/executor/executor.hpp>

namespace hexagait {

/// Finds the best base pose over the feet: optimise_stance(), or a strategy of the program
/// ([FG16] II-D: "should be adapted for different types of robots").
using StanceStrategy = StancePose (*)(const RobotModel&, const StanceProblem&);

struct PlannerParams {
  StanceStrategy stance = optimise_stance;
  ScriptParams script;  ///< what is kDerived follows from the robot's model
  /// Steps that would reduce the stability margin below this are refused [m].
  double min_margin = 0.0;
  /// Do steps fail that are unstable or out of reach? A preview executes them all the same, to find
  /// every problem of an action.
  bool refuses = true;
};

/// The state at the start of a step, from which its commands are resolved.
struct StepStart {
  const RobotModel& model;
  const Executor& executor;
  const RobotState& state;
  const Frames& frames;
  const StepFrames& step_frames;
};

/// Resolves the command of a leg into a plan from the leg's present state. The duration of a target
/// follows from its average rate; trajectories have their own.
/// @param plan   receives the result; does not allocate after reserve()
/// @param knots  scratch space for a trajectory in its new frame
void plan_leg(LegPlan& plan, const action::LegCommand& command, const StepStart& start,
              const PlannerParams& params, std::vector<FootKnot>& knots) noexcept;

/// Does the command specify an average rate instead of times? Then its plan may be stretched.
[[nodiscard]] bool rate_based(const action::LegCommand& command) noexcept;

/// Resolves the command again with a longer duration [s].
void stretch(LegPlan& plan, const action::LegCommand& command, double duration,
             const StepStart& start, const PlannerParams& params) noexcept;

/// Where the foot is at the end of the plan, in odom [m].
[[nodiscard]] Vector3 end_in_odom(const LegPlan& plan, LegId leg, const StepStart& start) noexcept;

}  // namespace hexagait
