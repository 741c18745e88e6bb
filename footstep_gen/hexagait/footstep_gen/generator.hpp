// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/heading_control/path_arc.hpp>
#include <hexagait/plant/robot_state.hpp>

namespace hexagait::footstep_gen {

/// Duration of a step on flat ground, from the command to lift until the foot counts as support
/// [s]: T of (gait 5) before the first step has been measured. Sum of the phases of a swing, with
/// 0.43 of lift_time for the rise to the height at which the foot moves sideways.
[[nodiscard]] double nominal_step_time(const SwingParams& swing, const StepParams& step) noexcept;

/// The input of the gait state: lag, urgency and support of each leg. A leg on a foothold that does not stop
/// giving way lags more than all others, so that it steps first; not while the robot crawls.
/// @param X_BG  pose on the commanded path for which legs step, in the body frame: while a robot
///              crawls its body sways about its path, and its footholds must not; null: the body's
[[nodiscard]] gait_state::GaitInput gait_input(const heading_control::PathArc& arc,
                                               const Executor& executor, const StepParams& params,
                                               const Pose* X_BG = nullptr) noexcept;

/// Path by which the base will have advanced when all feet now in the air have landed on their AEPs
/// [m]: the posture optimum along the path ([PC04] 4) at that time.
[[nodiscard]] double path_to_come(const heading_control::PathArc& arc, const Executor& executor,
                                  double half_step, const Pose* X_BG = nullptr) noexcept;

/// The step of one leg (step 1): to its AEP ([PC04] eq. 3) plus the advance still to come, at the
/// height of its last footprint; or, where a leg's first joint ends near its workspace, as far on the way
/// there from the workspace centre as it turns, from where the body is now: the body may have to wait
/// for the foot.
/// @param half_step  [m of path]
/// @param to_come    advance of the base until the foot lands [m of path]
[[nodiscard]] FootstepCommand footstep(const RobotModel& model, const Stance& stance,
                                       const heading_control::PathArc& arc, const RobotState& state,
                                       LegId leg, double half_step, double to_come,
                                       const StepParams& params,
                                       const Pose* X_BG = nullptr) noexcept;

/// The advance to come of a foot on its way down, which lands before the base has made all of it: on level ground
/// no more than until the foot leaves its workspace, (step 10).
/// @param half_step, to_come  as in footstep() [m of path]
[[nodiscard]] double to_come_coming_down(const Stance& stance, LegId leg, double half_step,
                                         double to_come, const StepParams& params) noexcept;

/// The motion of the base: along the path as the legs allow ([PC04] 4), parallel to the ground
/// under the feet, and back to the commanded curve; limited by the workspaces of the support legs
/// and by the edges of the support polygon, which is projected along gravity. On two feet the base
/// may pass the line between them by `stability_margin`, and on fewer it waits. A centre of mass that is
/// outside is moved back over the feet.
/// @param X_OB       the body in odom, whose z is up
/// @param deviation  displacement back to the commanded curve [m, rad]
/// @param margin     of the centre of mass from the edges; `stability_margin` if that is more [m]
[[nodiscard]] BaseAutoCommand base_auto(const RobotModel& model,
                                        const heading_control::PathArc& arc,
                                        const Executor& executor, const Pose& X_OB,
                                        const PlanarTwist& deviation, const StepParams& params,
                                        double margin = 0.0) noexcept;

}  // namespace hexagait::footstep_gen
