// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/action.hpp>
#include <hexagait/model/robot_model.hpp>
#include <map>
#include <string>
#include <vector>

namespace hexagait::action {

/// The words that a program adds to those of action files.
struct ActionVocabulary {
  FrameNames frames;
  std::vector<std::string> custom_types;            ///< their indices are CustomCommand::handler
  std::map<std::string, std::string> placeholders;  ///< YAML of a value, or of a list of values
};

/// An action may have, after `repeat` and references are followed, this many steps, commands, and
/// knots with all else that is counted.
inline constexpr std::size_t kMaxSteps = 10'000;
inline constexpr std::size_t kMaxCommands = 10'000;
inline constexpr std::size_t kMaxKnots = 100'000;

/// Reads an action from a YAML file, in the language of [FG16] IV-A, which docs/actions.md tells
/// key by key:
///
///     steps:
///     - step:
///       - base_auto:
///     - step:
///       - footstep:
///           name: RF
///           target: {frame: footprint, position: [0.32, -0.24, 0]}
///
/// The options of a command stand under it, as here, or beside it as in the paper's own
/// indentation; an anchor on such a command (`- footstep: &foot`) means its options.
/// Everything is checked before anything is returned. What is not checked here is whether the robot
/// can do it: positions out of reach, joint positions out of limits.
/// @throws InvalidInput  with all that is wrong, each as `file:line:column: what, the value found,
///                       what would be right`, and with the word that was probably meant
[[nodiscard]] Action load_action(const std::string& path, const RobotModel& model,
                                 const ActionVocabulary& vocabulary = {});

/// The same from a text; `source` names it in messages, and its stem the action that has no name.
[[nodiscard]] Action parse_action(const std::string& text, const std::string& source,
                                  const RobotModel& model, const ActionVocabulary& vocabulary = {});

/// The robot that an action is written for, by its key `robot`; empty if it has none.
[[nodiscard]] std::string written_for(const std::string& text, const std::string& source);

}  // namespace hexagait::action
