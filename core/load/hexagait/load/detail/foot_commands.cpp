// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/load/detail/action_commands.hpp>

namespace hexagait::action {
namespace {

bool has(const YamlFields& options, std::string_view key) {
  return std::ranges::find(options.allowed->keys, key) != options.allowed->keys.end();
}

}  // namespace

LegMotion read_leg_motion(YamlReader& yaml, const ActionWords& words, const YamlFields& options) {
  LegMotion motion;
  motion.leg = read_leg(yaml, words, options);
  if (const auto normal = yaml.find(options, "surface_normal"))
    motion.surface_normal = read_normal(yaml, words, *normal);
  if (has(options, "ignore_contact"))
    motion.ignore_contact = yaml.flag_or(options, "ignore_contact", false);
  motion.ignore_for_pose_adaptation = yaml.flag_or(options, "ignore_for_pose_adaptation", false);
  return motion;
}

Footstep read_footstep(YamlReader& yaml, const ActionWords& words, const YamlFields& options) {
  Footstep command{read_leg_motion(yaml, words, options), {}};
  if (const auto target = yaml.require(options, "target"))
    command.target = read_position(yaml, words, *target);
  command.profile_height =
      yaml.number_or(options, "profile_height", command.profile_height, kHeight);
  if (const auto type = yaml.find(options, "profile_type"))
    if (const auto profile = yaml.word(*type, kSwingProfiles))
      command.profile = static_cast<SwingProfile>(*profile);
  command.average_velocity =
      yaml.number_or(options, "average_velocity", command.average_velocity, kSpeed);
  return command;
}

EndEffectorTarget read_end_effector_target(YamlReader& yaml, const ActionWords& words,
                                           const YamlFields& options) {
  EndEffectorTarget command{read_leg_motion(yaml, words, options), {}};
  if (const auto target = yaml.require(options, "target_position"))
    command.target = read_position(yaml, words, *target);
  command.velocity = yaml.vector_or(options, "target_velocity", command.velocity, kVelocity);
  command.acceleration =
      yaml.vector_or(options, "target_acceleration", command.acceleration, kAcceleration);
  command.force = yaml.vector_or(options, "target_force", command.force, kForce);
  command.average_velocity =
      yaml.number_or(options, "average_velocity", command.average_velocity, kSpeed);
  return command;
}

EndEffectorTrajectory read_foot_trajectory(YamlReader& yaml, const ActionWords& words,
                                           const YamlFields& options) {
  EndEffectorTrajectory command;
  const std::optional<YamlField> field = yaml.require(options, "trajectory");
  if (!field) return command;
  const YamlFields trajectory = yaml.fields(*field, kFootTrajectoryMap);
  command.frame = read_frame(yaml, words, trajectory);
  for (const YamlField& item : read_knots(yaml, trajectory)) {
    const YamlFields fields = yaml.fields(item, kFootKnotMap);
    FootKnot knot;
    knot.time = read_time(yaml, fields, command.knots.empty() ? 0.0 : command.knots.back().time);
    if (const auto position = yaml.require(fields, "position"))
      knot.p = yaml.vector(*position, kPosition).value_or(knot.p);
    if (const auto velocity = yaml.find(fields, "velocity"))
      knot.v = yaml.vector(*velocity, kVelocity);
    command.knots.push_back(knot);
  }
  return command;
}

EndEffectorTrajectory read_end_effector_trajectory(YamlReader& yaml, const ActionWords& words,
                                                   const YamlFields& options) {
  const LegMotion motion = read_leg_motion(yaml, words, options);
  EndEffectorTrajectory command = read_foot_trajectory(yaml, words, options);
  static_cast<LegMotion&>(command) = motion;
  return command;
}

}  // namespace hexagait::action
