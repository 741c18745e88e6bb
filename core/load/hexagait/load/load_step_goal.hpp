// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/load/load_action.hpp>

namespace hexagait::action {

// The Step API of the draft of 2015 ([FG15] 2), read as an action of today. docs/step_api_2015.md
// tells field by field what becomes of it.

/// Step.action Result, `status`.
enum class StepResult : std::int8_t { failed = -1, unknown = 0, reached = 1 };

/// Step.action Feedback, `status`.
enum class StepProgress : std::int8_t { paused = -1, unknown = 0, executing = 1 };

struct StepGoal {
  Action action;
  /// [i]: the step_number of which action.steps[i] is a part. A base shift before or after the
  /// swings is a step of its own today.
  std::vector<int> step_numbers;
};

/// Reads a goal of Step.action, written as YAML:
///
///     steps:
///     - step_number: 1
///       swing_data:
///       - name: leftFore
///         profile: {target: {frame: odom, position: [0.3, 0.2, 0]}, height: 0.05, duration: 1}
///       shift_data:
///       - name: pre_step
///         profile: {target: {frame: odom, position: [0, 0, 0.2], orientation: [0, 0, 0]}}
///
/// As the draft has it, 0 and an empty text mean the default, a normal of [0, 0, 0] that of flat
/// ground, and a trajectory with knots is used instead of the profile.
/// @throws InvalidInput  like load_action()
[[nodiscard]] StepGoal load_step_goal(const std::string& path, const RobotModel& model,
                                      const FrameNames& frames = {});
[[nodiscard]] StepGoal parse_step_goal(const std::string& text, const std::string& source,
                                       const RobotModel& model, const FrameNames& frames = {});

}  // namespace hexagait::action
