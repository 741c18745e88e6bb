// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/script/action_runner.hpp>

namespace hexagait {

/// A problem of an action that its author should know before it moves a robot.
struct Finding {
  enum class Kind : std::uint8_t {
    out_of_reach,  ///< a foot's target is out of its leg's reach, or a joint's beyond its limit
    unstable,      ///< the centre of mass leaves the support polygon
    narrow,        ///< the stability margin is less than ScriptParams::narrow_margin
    too_fast,      ///< a joint would have to exceed its velocity limit
    not_finite,    ///< a number is none, or so large that the motion is not finite
    no_result,     ///< the action does not end within PreviewParams::most_seconds
  };
  Kind kind = Kind::out_of_reach;
  bool is_error = true;  ///< otherwise a warning
  int step = 0;          ///< from 1
  action::Mark mark;     ///< of the command that causes it
  std::string text;      ///< what and where, with the value and what it should be
};

struct PreviewParams {
  RunnerParams runner;
  RestsOn rests_on = RestsOn::feet;  ///< when the action starts
  double most_seconds = 3600.0;
};

struct Preview {
  ActionResult result;
  double seconds = 0.0;           ///< duration of the action if the ground is as expected
  double least_margin = 0.0;      ///< least stability margin [m]
  int least_margin_step = 0;      ///< step in which it occurs
  std::vector<Finding> findings;  ///< in the order of the steps
};

/// Runs an action ahead of time with the same controller, on a robot that follows its targets
/// exactly and ground that is where each foot expects it. Continues after a problem: steps that a
/// robot would refuse are executed all the same.
/// @param joints   joint positions at the start [rad]
/// @param observe  called after every tick; may be empty
[[nodiscard]] Preview preview(const RobotModel& model, const LegArray<LegJoints>& joints,
                              const action::Action& action, const PreviewParams& params,
                              const std::function<void(const ActionRecord&)>& observe = {});

/// Joint values of the nominal stance of all legs [rad].
[[nodiscard]] LegArray<LegJoints> nominal_joints(const RobotModel& model);

/// "file:line:column: error: text", in the format of compilers.
[[nodiscard]] std::string in_words(const Finding& finding, const std::string& source);

}  // namespace hexagait
