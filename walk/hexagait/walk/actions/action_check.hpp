// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/load/load_action.hpp>
#include <hexagait/params/robot_params.hpp>
#include <hexagait/script/preview.hpp>
#include <string>

namespace hexagait::walk {

/// The robot of a name. @throws InvalidInput  if there is none
using RobotOfName = std::function<RobotModel(const std::string& name)>;

/// Is the text a step goal of 2015, and no action?
[[nodiscard]] bool is_step_goal(const std::string& text);

/// Reads an action, or a step goal of 2015, for a robot. One that is written for another robot is made
/// for this one: for_robot().
/// @param source      names the text in messages
/// @param load_robot  asked for the robot that the action is written for, if that is another one
/// @throws InvalidInput  as action::parse_action() and for_robot()
[[nodiscard]] action::Action action_for(const std::string& text, const std::string& source,
                                        const RobotModel& robot,
                                        const action::ActionVocabulary& vocabulary,
                                        const RobotOfName& load_robot);

/// The runner of a robot with these parameters.
[[nodiscard]] RunnerParams runner_params(const RobotParams& robot);

/// Would the action not be carried out to its end?
[[nodiscard]] bool has_errors(const Preview& ahead);

/// Why an action failed, for people: "a foot found no ground".
[[nodiscard]] const char* in_words(Cause cause);

}  // namespace hexagait::walk
