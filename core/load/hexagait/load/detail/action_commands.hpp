// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/load/detail/action_values.hpp>
#include <variant>

namespace hexagait::action {

/// What an entry of a step may be.
using AnyCommand = std::variant<LegCommand, BaseCommand, CustomCommand, Wait>;

/// Reads a command from its options; fields.allowed is one of kCommands and says which it is.
[[nodiscard]] AnyCommand read_command(YamlReader& yaml, const ActionWords& words,
                                      const YamlFields& options);

/// Those of a leg in joint space, and in Cartesian space.
[[nodiscard]] JointTarget read_joint_target(YamlReader& yaml, const ActionWords& words,
                                            const YamlFields& options);
[[nodiscard]] JointTrajectory read_joint_trajectory(YamlReader& yaml, const ActionWords& words,
                                                    const YamlFields& options);
[[nodiscard]] LegMode read_leg_mode(YamlReader& yaml, const ActionWords& words,
                                    const YamlFields& options);
[[nodiscard]] Footstep read_footstep(YamlReader& yaml, const ActionWords& words,
                                     const YamlFields& options);
[[nodiscard]] EndEffectorTarget read_end_effector_target(YamlReader& yaml, const ActionWords& words,
                                                         const YamlFields& options);
[[nodiscard]] EndEffectorTrajectory read_end_effector_trajectory(YamlReader& yaml,
                                                                 const ActionWords& words,
                                                                 const YamlFields& options);

/// What stands under `trajectory`, for a foot and for the base.
[[nodiscard]] EndEffectorTrajectory read_foot_trajectory(YamlReader& yaml, const ActionWords& words,
                                                         const YamlFields& options);
[[nodiscard]] BaseTrajectory read_pose_trajectory(YamlReader& yaml, const ActionWords& words,
                                                  const YamlFields& options);

/// Leg, surface normal and flags, as far as the command has them.
[[nodiscard]] LegMotion read_leg_motion(YamlReader& yaml, const ActionWords& words,
                                        const YamlFields& options);

}  // namespace hexagait::action
