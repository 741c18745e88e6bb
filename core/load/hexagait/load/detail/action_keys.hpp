// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/yaml/yaml_reader.hpp>

namespace hexagait::action {

// Every key of action files. docs/actions.md has a table for each of these maps; a test holds the
// two together.

inline constexpr std::string_view kActionKeys[] = {"name", "robot", "placeholders",
                                                   "adapt_coordinates", "steps"};
inline constexpr std::string_view kStepItemKeys[] = {"step", "repeat"};
inline constexpr std::string_view kRepeatKeys[] = {"count", "steps"};
inline constexpr std::string_view kAdaptationKeys[] = {"transform", "yaw_only"};
inline constexpr std::string_view kTransformKeys[] = {"source_frame", "target_frame",
                                                      "transform_in_source_frame"};

inline constexpr std::string_view kPositionKeys[] = {"frame", "position"};
inline constexpr std::string_view kNormalKeys[] = {"frame", "vector"};
inline constexpr std::string_view kPoseKeys[] = {"frame", "position", "orientation"};
inline constexpr std::string_view kTransformPoseKeys[] = {"position", "orientation"};
inline constexpr std::string_view kJointStateKeys[] = {"joint_names", "positions", "velocities",
                                                       "accelerations", "efforts"};
inline constexpr std::string_view kFootTrajectoryKeys[] = {"frame", "knots"};
inline constexpr std::string_view kFootKnotKeys[] = {"time", "position", "velocity"};
inline constexpr std::string_view kJointTrajectoryKeys[] = {"joint_names", "knots"};
inline constexpr std::string_view kJointKnotKeys[] = {"time", "positions", "velocities",
                                                      "accelerations", "efforts"};
inline constexpr std::string_view kBaseTrajectoryKeys[] = {"frame", "knots"};
inline constexpr std::string_view kBaseKnotKeys[] = {"time", "position", "orientation"};

inline constexpr std::string_view kFootstepOptions[] = {"name",
                                                        "target",
                                                        "profile_height",
                                                        "profile_type",
                                                        "average_velocity",
                                                        "surface_normal",
                                                        "ignore_contact",
                                                        "ignore_for_pose_adaptation"};
inline constexpr std::string_view kEndEffectorTargetOptions[] = {"name",
                                                                 "target_position",
                                                                 "target_velocity",
                                                                 "target_acceleration",
                                                                 "target_force",
                                                                 "average_velocity",
                                                                 "surface_normal",
                                                                 "ignore_contact",
                                                                 "ignore_for_pose_adaptation"};
inline constexpr std::string_view kLegTrajectoryOptions[] = {
    "name", "trajectory", "surface_normal", "ignore_contact", "ignore_for_pose_adaptation"};
inline constexpr std::string_view kJointTargetOptions[] = {
    "name",   "target",           "position",       "velocity",       "acceleration",
    "effort", "average_velocity", "surface_normal", "ignore_contact", "ignore_for_pose_adaptation"};
inline constexpr std::string_view kLegModeOptions[] = {
    "name", "support_leg", "duration", "surface_normal", "ignore_for_pose_adaptation"};
inline constexpr std::string_view kBaseAutoOptions[] = {
    "height", "ignore_timing_of_leg_motion", "average_linear_velocity", "average_angular_velocity",
    "support_margin"};
inline constexpr std::string_view kBaseTargetOptions[] = {
    "target", "ignore_timing_of_leg_motion", "average_linear_velocity", "average_angular_velocity"};
inline constexpr std::string_view kBaseTrajectoryOptions[] = {"trajectory"};
inline constexpr std::string_view kCustomOptions[] = {"type", "duration", "command"};
inline constexpr std::string_view kWaitOptions[] = {"duration"};

/// The commands of a step, by the names they have in files.
inline constexpr YamlKeys kCommands[] = {{"footstep", kFootstepOptions},
                                         {"end_effector_target", kEndEffectorTargetOptions},
                                         {"end_effector_trajectory", kLegTrajectoryOptions},
                                         {"joint_target", kJointTargetOptions},
                                         {"joint_trajectory", kLegTrajectoryOptions},
                                         {"leg_mode", kLegModeOptions},
                                         {"base_auto", kBaseAutoOptions},
                                         {"base_target", kBaseTargetOptions},
                                         {"base_trajectory", kBaseTrajectoryOptions},
                                         {"custom_command", kCustomOptions},
                                         {"wait", kWaitOptions}};

/// All other maps, by the names they have in docs/actions.md and in messages.
inline constexpr YamlKeys kActionMap = {"action", kActionKeys};
inline constexpr YamlKeys kStepItemMap = {"entry of steps", kStepItemKeys};
inline constexpr YamlKeys kRepeatMap = {"repeat", kRepeatKeys};
inline constexpr YamlKeys kAdaptationMap = {"adaptation", kAdaptationKeys};
inline constexpr YamlKeys kTransformMap = {"transform", kTransformKeys};
inline constexpr YamlKeys kTransformPoseMap = {"transform in source frame", kTransformPoseKeys};
inline constexpr YamlKeys kPositionMap = {"foot target", kPositionKeys};
inline constexpr YamlKeys kNormalMap = {"surface normal", kNormalKeys};
inline constexpr YamlKeys kPoseMap = {"base pose", kPoseKeys};
inline constexpr YamlKeys kJointStateMap = {"joint state", kJointStateKeys};
inline constexpr YamlKeys kFootTrajectoryMap = {"foot trajectory", kFootTrajectoryKeys};
inline constexpr YamlKeys kFootKnotMap = {"foot knot", kFootKnotKeys};
inline constexpr YamlKeys kLegTrajectoryMap = {"trajectory of joints", kJointTrajectoryKeys};
inline constexpr YamlKeys kJointKnotMap = {"joint knot", kJointKnotKeys};
inline constexpr YamlKeys kBaseTrajectoryMap = {"trajectory of the base", kBaseTrajectoryKeys};
inline constexpr YamlKeys kBaseKnotMap = {"base knot", kBaseKnotKeys};

inline constexpr const YamlKeys* kMaps[] = {
    &kActionMap,        &kStepItemMap,      &kRepeatMap,         &kAdaptationMap,
    &kTransformMap,     &kTransformPoseMap, &kPositionMap,       &kNormalMap,
    &kPoseMap,          &kJointStateMap,    &kFootTrajectoryMap, &kFootKnotMap,
    &kLegTrajectoryMap, &kJointKnotMap,     &kBaseTrajectoryMap, &kBaseKnotMap};

}  // namespace hexagait::action
