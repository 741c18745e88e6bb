// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <hexagait/load/detail/action_commands.hpp>

namespace hexagait::action {
namespace {

BaseAuto read_base_auto(YamlReader& yaml, const YamlFields& options) {
  BaseAuto command;
  if (const auto height = yaml.find(options, "height"))
    command.height = yaml.number(*height, kHeight);
  command.ignore_timing_of_leg_motion = yaml.flag_or(options, "ignore_timing_of_leg_motion", false);
  command.average_linear_velocity =
      yaml.number_or(options, "average_linear_velocity", command.average_linear_velocity, kSpeed);
  command.average_angular_velocity = yaml.number_or(options, "average_angular_velocity",
                                                    command.average_angular_velocity, kTurnRate);
  command.support_margin =
      yaml.number_or(options, "support_margin", command.support_margin, kHeight);
  return command;
}

BaseTarget read_base_target(YamlReader& yaml, const ActionWords& words, const YamlFields& options) {
  BaseTarget command;
  if (const auto target = yaml.require(options, "target")) {
    const YamlFields fields = yaml.fields(*target, kPoseMap);
    command.frame = read_frame(yaml, words, fields);
    command.X_AB = read_pose(yaml, fields);
  }
  command.ignore_timing_of_leg_motion = yaml.flag_or(options, "ignore_timing_of_leg_motion", false);
  command.average_linear_velocity =
      yaml.number_or(options, "average_linear_velocity", command.average_linear_velocity, kSpeed);
  command.average_angular_velocity = yaml.number_or(options, "average_angular_velocity",
                                                    command.average_angular_velocity, kTurnRate);
  return command;
}

// The sub-tree under `command` as text; empty if there is none.
std::string read_command_text(YamlReader& yaml, const YamlField& field) {
  constexpr std::size_t kMaxSize = 100'000;
  const std::size_t size = yaml_size(yaml.tree(), field.node, kMaxSize);
  if (size == kMaxSize) {
    yaml.refuse(
        field.mark,
        fmt::format("command: has more than {} letters, or is nested deeper than 64", kMaxSize));
    return {};
  }
  yaml.count(size);
  return yaml_text(yaml.tree(), field.node);
}

CustomCommand read_custom(YamlReader& yaml, const ActionWords& words, const YamlFields& options) {
  CustomCommand command;
  if (const auto type = yaml.require(options, "type")) {
    const auto handler = yaml.word(*type, words.vocabulary.custom_types);
    if (handler) {
      command.handler = static_cast<int>(*handler);
      command.type = words.vocabulary.custom_types[*handler];
    }
  }
  command.duration = yaml.number_or(options, "duration", command.duration, kTime);
  if (const auto text = yaml.find(options, "command"))
    command.command = read_command_text(yaml, *text);
  return command;
}

Wait read_wait(YamlReader& yaml, const YamlFields& options) {
  Wait wait;
  if (const auto duration = yaml.require(options, "duration"))
    wait.duration = yaml.number(*duration, kPositiveTime).value_or(wait.duration);
  return wait;
}

}  // namespace

BaseTrajectory read_pose_trajectory(YamlReader& yaml, const ActionWords& words,
                                    const YamlFields& options) {
  BaseTrajectory command;
  const std::optional<YamlField> field = yaml.require(options, "trajectory");
  if (!field) return command;
  const YamlFields trajectory = yaml.fields(*field, kBaseTrajectoryMap);
  command.frame = read_frame(yaml, words, trajectory);
  for (const YamlField& item : read_knots(yaml, trajectory)) {
    const YamlFields fields = yaml.fields(item, kBaseKnotMap);
    const double before = command.knots.empty() ? 0.0 : command.knots.back().time;
    command.knots.push_back({read_time(yaml, fields, before), read_pose(yaml, fields)});
  }
  return command;
}

AnyCommand read_command(YamlReader& yaml, const ActionWords& words, const YamlFields& options) {
  const std::string_view name = options.allowed->of;
  const Mark& mark = options.mark;
  if (name == "footstep") return LegCommand{read_footstep(yaml, words, options), mark};
  if (name == "end_effector_target")
    return LegCommand{read_end_effector_target(yaml, words, options), mark};
  if (name == "end_effector_trajectory")
    return LegCommand{read_end_effector_trajectory(yaml, words, options), mark};
  if (name == "joint_target") return LegCommand{read_joint_target(yaml, words, options), mark};
  if (name == "joint_trajectory")
    return LegCommand{read_joint_trajectory(yaml, words, options), mark};
  if (name == "leg_mode") return LegCommand{read_leg_mode(yaml, words, options), mark};
  if (name == "base_auto") return BaseCommand{read_base_auto(yaml, options), mark};
  if (name == "base_target") return BaseCommand{read_base_target(yaml, words, options), mark};
  if (name == "base_trajectory")
    return BaseCommand{read_pose_trajectory(yaml, words, options), mark};
  if (name == "custom_command") return read_custom(yaml, words, options);
  assert(name == "wait");
  return read_wait(yaml, options);
}

}  // namespace hexagait::action
