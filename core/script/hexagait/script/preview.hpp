// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/script/action_runner.hpp>

namespace hexagait {

/// Something about an action that people should know before it moves a robot.
struct Finding {
  enum class Kind : std::uint8_t {
    out_of_reach,  ///< a foot is to be where its leg doesn't reach, or a joint beyond its limit
    unstable,      ///< the centre of mass leaves the feet that carry
    narrow,        ///< the margin is less than PreviewParams::narrow_margin
    too_fast,      ///< a joint would have to be faster than it can
    no_result,     ///< the action does not end within PreviewParams::most_seconds
  };
  Kind kind = Kind::out_of_reach;
  bool is_error = true;  ///< else a warning
  int step = 0;          ///< from 1
  action::Mark mark;     ///< of the command that is to blame
  std::string text;      ///< what and where, with the value and what would be right
};

struct PreviewParams {
  RunnerParams runner;
  RestsOn rests_on = RestsOn::feet;  ///< when the action starts
  double narrow_margin = 0.01;       ///< [m]
  double most_seconds = 3600.0;
};

struct Preview {
  ActionResult result;
  double seconds = 0.0;           ///< that the action takes, if the ground is as expected
  double least_margin = 0.0;      ///< of stability [m]
  int least_margin_step = 0;      ///< in which it occurs
  std::vector<Finding> findings;  ///< in the order of the steps
};

/// Plays an action ahead: the very controller that runs it, on a robot that does what it is told
/// and ground that is where each foot expects it. Nothing is left out because something before it
/// is wrong: steps that a robot would refuse are shown all the same.
/// @param joints   from where the action starts [rad]
/// @param observe  called after every tick, may be empty
[[nodiscard]] Preview preview(const RobotModel& model, const LegArray<LegJoints>& joints,
                              const action::Action& action, const PreviewParams& params,
                              const std::function<void(const ActionRecord&)>& observe = {});

/// Joint values of the nominal stance [rad].
[[nodiscard]] LegArray<LegJoints> nominal_joints(const RobotModel& model);

/// "file:line:column: error: text", as compilers write it.
[[nodiscard]] std::string in_words(const Finding& finding, const std::string& source);

}  // namespace hexagait
