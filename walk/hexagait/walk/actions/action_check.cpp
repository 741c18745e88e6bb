// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/load/load_step_goal.hpp>
#include <hexagait/walk/actions/action_check.hpp>
#include <hexagait/walk/actions/action_for_robot.hpp>

namespace hexagait::walk {

// Goals of 2015 number their steps; actions have no such key.
bool is_step_goal(const std::string& text) {
  return text.find("step_number:") != std::string::npos;
}

action::Action action_for(const std::string& text, const std::string& source,
                          const RobotModel& robot, const action::ActionVocabulary& vocabulary,
                          const RobotOfName& load_robot) {
  if (is_step_goal(text)) return action::parse_step_goal(text, source, robot).action;
  const std::string name = action::written_for(text, source);
  if (name.empty() || name == robot.name)
    return action::parse_action(text, source, robot, vocabulary);
  const RobotModel other = load_robot(name);
  return for_robot(action::parse_action(text, source, other, vocabulary), other, robot);
}

RunnerParams runner_params(const RobotParams& robot) {
  RunnerParams result;
  result.executor.swing = robot.swing;
  result.executor.base = robot.base;
  result.executor.virtual_model.frequency = robot.spring.frequency;
  result.executor.virtual_model.turn_frequency = robot.spring.turn_frequency;
  result.tolerance = robot.tolerance;
  result.sequencer.planner.script = robot.script;
  return result;
}

bool has_errors(const Preview& ahead) {
  return ahead.result.outcome != Outcome::succeeded ||
         std::ranges::any_of(ahead.findings, &Finding::is_error);
}

const char* in_words(Cause cause) {
  switch (cause) {
    case Cause::none:
      return "no cause";
    case Cause::no_contact:
      return "a foot found no ground";
    case Cause::lost_contact:
      return "a foot lost the ground and did not find it again";
    case Cause::out_of_reach:
      return "a foot or the base was to go where the legs don't reach";
    case Cause::unstable:
      return "the legs that would have stood don't carry the centre of mass";
    case Cause::not_finite:
      return "a number of a command, or of a frame's pose, is none or is absurd";
    case Cause::plant:
      return "the robot stopped";
  }
  return "?";
}

}  // namespace hexagait::walk
