// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <hexagait/walk/actions/action_check.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hexagait::viewer {

/// A problem of an action, found when it was read or played ahead.
struct ActionFinding {
  int line = 0, column = 0;  ///< from 1; 0: it is of the whole action
  bool is_error = true;      ///< otherwise a warning
  std::string text;          ///< what is wrong, and what would be right
  std::string source;        ///< the line of the action
};

/// An action that was checked for a robot.
struct CheckedAction {
  std::optional<action::Action> action;  ///< none: it is refused
  std::string why;                       ///< it is refused, in a sentence
  std::vector<ActionFinding> findings;   ///< kMostFindings at most
  static constexpr std::size_t kMostFindings = 100;
};

/// What an action is checked for.
struct ActionCheck {
  RobotModel robot;
  RunnerParams runner;
  walk::RobotOfName load_robot;  ///< that the action may be written for
};

/// The longest action that is performed: what takes longer is refused [s].
inline constexpr double kLongestAction = 300.0;

/// Reads an action, and plays it ahead from the robot's nominal stance, as `hexagait run` does. Takes up to
/// some seconds; any thread may do it.
/// @param cancelled  once true it returns early: without an action
[[nodiscard]] CheckedAction check_action(const std::string& yaml, const ActionCheck& check,
                                         const std::atomic<bool>& cancelled);

}  // namespace hexagait::viewer
