// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/heading_control/path_arc.hpp>
#include <hexagait/plant/robot_state.hpp>

namespace hexagait::footstep_gen {

struct StepParams {
  /// Path between two landings of one foot, at the outermost leg [m]. Longer is faster until the
  /// workspaces end: half of it is the AEP's distance from the workspace centre.
  double stroke = 0.20;
  /// Clearance of the swing [m]. Higher steps up more and walks slower.
  double height = 0.10;
  /// Added for each metre by which another foot's last footprint is higher: who has just met a step
  /// expects another [m/m]. 0: an edge higher than the clearance is found by running into it.
  double roughness_gain = 1.0;
  double max_height = 0.22;  ///< of the swing, at most [m]
  /// Share of its workspace radius at which a leg's lag is urgent: the latch then lets go of its
  /// adjusted relations.
  double urgent_share = 0.8;
  /// The base waits before its centre of mass comes closer than this to the edge of the support
  /// polygon [m]. 0: crabbing at 45°, where the support triangle is narrow, tips the robot.
  double stability_margin = 0.03;
};

/// How long a step on flat ground takes, from the command to lift until the foot counts as support
/// [s]: T of (gait 5) until a step has been seen. The phases of a swing, each in its own words; the
/// rise to the height at which the foot may move sideways as 0.43 of the lift.
[[nodiscard]] double nominal_step_time(const SwingParams& swing, const StepParams& step) noexcept;

/// Lag, urgency and ground contact of each leg: what the gait state decides by.
[[nodiscard]] gait_state::GaitInput gait_input(const RobotModel& model,
                                               const heading_control::PathArc& arc,
                                               const Executor& executor,
                                               const StepParams& params) noexcept;

/// Path that the base will have advanced when every foot that is in the air now has come down on
/// its AEP [m]: the arc-restricted posture optimum ([PC04] 4) of that moment.
[[nodiscard]] double path_to_come(const heading_control::PathArc& arc, const Executor& executor,
                                  double half_step) noexcept;

/// The step of one leg: to its AEP ([PC04] eq. 3), taken along by the advance still to come, at the
/// height of its last footprint.
[[nodiscard]] Footstep footstep(const RobotModel& model, const heading_control::PathArc& arc,
                                const RobotState& state, LegId leg, double half_step,
                                double to_come, const StepParams& params) noexcept;

/// The base: along the path as a reaction to the legs ([PC04] 4), parallel to the ground under the
/// feet, back to the commanded curve, and not beyond any support leg's workspace nor the edge of
/// the support polygon.
[[nodiscard]] BaseAuto base_auto(const RobotModel& model, const heading_control::PathArc& arc,
                                 const Executor& executor, const PlanarTwist& deviation,
                                 const StepParams& params) noexcept;

}  // namespace hexagait::footstep_gen
