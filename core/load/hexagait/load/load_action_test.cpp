// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/load/load_action.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait::action {
namespace {

using testing::argos;

Action parse(const std::string& text, const ActionVocabulary& vocabulary = {}) {
  return parse_action(text, "test.yaml", argos(), vocabulary);
}

/// The only command of the only step.
template <class Motion>
Motion leg_command(const std::string& entry) {
  const Action action = parse("steps:\n- step:\n  - " + entry + "\n");
  EXPECT_EQ(action.steps.size(), 1U);
  EXPECT_EQ(action.steps.at(0).legs.size(), 1U);
  return std::get<Motion>(action.steps.at(0).legs.at(0).motion);
}

template <class Motion>
Motion base_command(const std::string& entry) {
  const Action action = parse("steps:\n- step:\n  - " + entry + "\n");
  return std::get<Motion>(action.steps.at(0).base.value().motion);
}

// [FG16] IV-A as it is printed: options stand beside their command, `&foot` is on nothing.
constexpr const char* kPushUpAsPrinted = R"(steps:
- step:
  - base_auto:
- step:
  - end_effector_target:
    name: RF_LEG
    ignore_contact: true
    target_position:
      frame: footprint
      position: [0.39, -0.24, 0.20]
- step:
  - base_auto:
    height: 0.38
    ignore_timing_of_leg_motion: true
  - end_effector_target: &foot
    name: RF_LEG
    ignore_contact: true
    ignore_for_pose_adaptation: true
    target_position:
      frame: footprint
      position: [0.39, -0.24, 0.20]
- step:
  - base_auto:
    height: 0.45
    ignore_timing_of_leg_motion: true
  - end_effector_target: *foot
- step:
  - footstep:
    name: RF_LEG
    profile_type: straight
    target:
      frame: footprint
      position: [0.32, -0.24, 0.0]
- step:
  - base_auto:
)";

// The same with the options one level deeper.
constexpr const char* kPushUpNested = R"(steps:
  - step:
      - base_auto:
  - step:
      - end_effector_target:
          name: RF
          ignore_contact: true
          target_position: {frame: footprint, position: [0.39, -0.24, 0.20]}
  - step:
      - base_auto: {height: 0.38, ignore_timing_of_leg_motion: true}
      - end_effector_target: &foot
          name: RF
          ignore_contact: true
          ignore_for_pose_adaptation: true
          target_position: {frame: footprint, position: [0.39, -0.24, 0.20]}
  - step:
      - base_auto: {height: 0.45, ignore_timing_of_leg_motion: true}
      - end_effector_target: *foot
  - step:
      - footstep: {name: RF, profile_type: straight,
                   target: {frame: footprint, position: [0.32, -0.24, 0.0]}}
  - step:
      - base_auto:
)";

void expect_push_up(const Action& action) {
  ASSERT_EQ(action.steps.size(), 6U);
  const auto foot = [&](std::size_t step) {
    return std::get<EndEffectorTarget>(action.steps[step].legs.at(0).motion);
  };
  for (const std::size_t step : {1U, 2U, 3U}) {
    EXPECT_EQ(foot(step).leg, 1);
    EXPECT_EQ(foot(step).target.frame, kFootprint);
    EXPECT_EQ(foot(step).target.p, Vector3(0.39, -0.24, 0.20));
    EXPECT_TRUE(foot(step).ignore_contact);
    EXPECT_EQ(foot(step).ignore_for_pose_adaptation, step > 1);
  }
  const auto base = [&](std::size_t step) {
    return std::get<BaseAuto>(action.steps[step].base.value().motion);
  };
  EXPECT_EQ(base(0).height, std::nullopt);
  EXPECT_FALSE(base(0).ignore_timing_of_leg_motion);
  EXPECT_EQ(base(2).height, 0.38);
  EXPECT_EQ(base(3).height, 0.45);
  EXPECT_TRUE(base(3).ignore_timing_of_leg_motion);
  EXPECT_TRUE(action.steps[5].legs.empty());
  const auto step = std::get<Footstep>(action.steps[4].legs.at(0).motion);
  EXPECT_EQ(step.profile, SwingProfile::straight);
  EXPECT_EQ(step.target.p, Vector3(0.32, -0.24, 0.0));
}

TEST(LoadAction, ReadsThePushUpOfThePaperAsItIsPrinted) { expect_push_up(parse(kPushUpAsPrinted)); }

TEST(LoadAction, ReadsThePushUpWithOptionsUnderTheirCommands) {
  expect_push_up(parse(kPushUpNested));
}

// Line 26 of the listing: the reference is written there, what it refers to on line 15.
TEST(LoadAction, MarksACommandWhereItIsWritten) {
  const Action action = parse(kPushUpAsPrinted);
  EXPECT_EQ(action.steps[3].legs[0].mark.line, 26);
  EXPECT_EQ(action.steps[3].legs[0].mark.column, 5);
  EXPECT_EQ(action.steps[2].legs[0].mark.line, 15);
  EXPECT_EQ(action.steps[3].base->mark.line, 23);
  EXPECT_EQ(action.steps[3].mark.line, 22);
}

TEST(LoadAction, GivesDefaultsToWhatIsLeftOut) {
  const auto step =
      leg_command<Footstep>("footstep: {name: LM, target: {frame: odom, position: [1, 2, 3]}}");
  EXPECT_EQ(step.leg, 2);
  EXPECT_TRUE(is_derived(step.profile_height));
  EXPECT_EQ(step.profile, SwingProfile::triangle);
  EXPECT_TRUE(is_derived(step.average_velocity));
  EXPECT_EQ(step.duration, std::nullopt);
  EXPECT_FALSE(step.ignore_contact);
  EXPECT_EQ(step.surface_normal.v, Vector3::UnitZ());
  const auto base = base_command<BaseAuto>("base_auto:");
  EXPECT_TRUE(is_derived(base.average_linear_velocity));
  EXPECT_TRUE(is_derived(base.average_angular_velocity));
  EXPECT_TRUE(is_derived(base.support_margin));
  EXPECT_TRUE(is_derived(leg_command<LegMode>("leg_mode: {name: LF}").duration));
}

TEST(LoadAction, ReadsEveryOptionOfAFootstep) {
  const auto step = leg_command<Footstep>(
      "footstep: {name: RR_LEG, target: {frame: base_link, position: [1, 2, 3]}, "
      "profile_height: 0.1, profile_type: trapezoid, average_velocity: 0.2, "
      "surface_normal: {frame: map, vector: [0, 0.1, 1]}, ignore_contact: true, "
      "ignore_for_pose_adaptation: true}");
  EXPECT_EQ(step.leg, 5);
  EXPECT_EQ(step.target.frame, kBase);
  EXPECT_EQ(step.profile_height, 0.1);
  EXPECT_EQ(step.profile, SwingProfile::trapezoid);
  EXPECT_EQ(step.average_velocity, 0.2);
  EXPECT_EQ(step.surface_normal.frame, kMap);
  EXPECT_EQ(step.surface_normal.v, Vector3(0, 0.1, 1));
  EXPECT_TRUE(step.ignore_contact && step.ignore_for_pose_adaptation);
}

TEST(LoadAction, ReadsFeetInCartesianSpace) {
  const auto target = leg_command<EndEffectorTarget>(
      "end_effector_target: {name: LF, target_position: {frame: base, position: [1, 2, 3]}, "
      "target_velocity: [4, 5, 6], target_acceleration: [7, 8, 9], target_force: [0, 0, -20], "
      "average_velocity: 0.1}");
  EXPECT_EQ(target.velocity, Vector3(4, 5, 6));
  EXPECT_EQ(target.acceleration, Vector3(7, 8, 9));
  EXPECT_EQ(target.force, Vector3(0, 0, -20));
  EXPECT_EQ(target.average_velocity, 0.1);
  const auto trajectory = leg_command<EndEffectorTrajectory>(
      "end_effector_trajectory: {name: LF, trajectory: {frame: map, knots: ["
      "{time: 0.25, position: [1, 2, 3]}, {time: 0.5, position: [1, 2, 4], velocity: [0, 0, "
      "1]}]}}");
  EXPECT_EQ(trajectory.frame, kMap);
  ASSERT_EQ(trajectory.knots.size(), 2U);
  EXPECT_EQ(trajectory.knots[0].v, std::nullopt);
  EXPECT_EQ(trajectory.knots[1].time, 0.5);
  EXPECT_EQ(trajectory.knots[1].v, Vector3(0, 0, 1));
}

TEST(LoadAction, WantsAsManyNumbersAsTheLegHasJoints) {
  const RobotModel model = load_urdf(testing::source_path("robots/hexapod_4dof.urdf"));
  const auto load = [&](const std::string& position) {
    return parse_action(
        "steps:\n- step:\n  - joint_target: {name: LM, position: " + position + "}\n", "test.yaml",
        model, {});
  };
  const auto target = std::get<JointTarget>(load("[0.1, 0.2, 0.3, 0.4]").steps[0].legs[0].motion);
  EXPECT_EQ(target.target.q, leg_joints({0.1, 0.2, 0.3, 0.4}));
  for (const auto& [position, found] :
       {std::pair("[0.1, 0.2, 0.3]", "3"), std::pair("[0.1, 0.2, 0.3, 0.4, 0.5]", "5")}) {
    try {
      (void)load(position);
      ADD_FAILURE() << position;
    } catch (const InvalidInput& error) {
      const std::string message =
          "position: is a list of " + std::string(found) + "; it must be a list of 4 numbers";
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
}

// deg(180) is π; values that are not given are NaN.
TEST(LoadAction, ReadsJointTargetsFromHipToFoot) {
  const auto command = leg_command<JointTarget>(
      "joint_target: {name: LF, position: [0.1, deg(180), -0.3], effort: [1, 2, 3], "
      "average_velocity: deg(90)}");
  EXPECT_EQ(command.target.q, leg_joints({0.1, std::numbers::pi, -0.3}));
  EXPECT_EQ(command.target.effort, leg_joints({1, 2, 3}));
  EXPECT_TRUE(std::isnan(command.target.qd[0]) && std::isnan(command.target.qdd[2]));
  EXPECT_EQ(command.average_velocity, std::numbers::pi / 2.0);
}

TEST(LoadAction, PutsJointsWhereTheirNamesSay) {
  const auto target = leg_command<JointTarget>(
      "joint_target: {name: LF, target: {joint_names: [LF_knee, LF_yaw, LF_hip], "
      "positions: [0.3, 0.1, 0.2], velocities: [3, 1, 2]}}");
  EXPECT_EQ(target.target.q, leg_joints({0.1, 0.2, 0.3}));
  EXPECT_EQ(target.target.qd, leg_joints({1, 2, 3}));
  const auto trajectory = leg_command<JointTrajectory>(
      "joint_trajectory: {name: RM_LEG, trajectory: {joint_names: [RM_hip, RM_knee, RM_yaw], "
      "knots: [{time: 0.5, positions: [2, 3, 1], velocities: [5, 6, 4], "
      "accelerations: [8, 9, 7], efforts: [11, 12, 10]}]}}");
  ASSERT_EQ(trajectory.knots.size(), 1U);
  EXPECT_EQ(trajectory.leg, 3);
  EXPECT_EQ(trajectory.knots[0].time, 0.5);
  EXPECT_EQ(trajectory.knots[0].q, leg_joints({1, 2, 3}));
  EXPECT_EQ(trajectory.knots[0].qd, leg_joints({4, 5, 6}));
  EXPECT_EQ(trajectory.knots[0].qdd, leg_joints({7, 8, 9}));
  EXPECT_EQ(trajectory.knots[0].effort, leg_joints({10, 11, 12}));
}

// R = Rz(yaw) Ry(pitch) Rx(roll): read back by its inverse. A quarter turn about z is the
// quaternion (0, 0, sin 45°, cos 45°).
TEST(LoadAction, ReadsOrientationsInBothForms) {
  const auto target = base_command<BaseTarget>(
      "base_target: {target: {frame: odom, position: [1, 2, 3], "
      "orientation: [deg(10), -0.2, 0.3]}, ignore_timing_of_leg_motion: true, "
      "average_linear_velocity: 0.01, average_angular_velocity: 0.02}");
  const Vector3 rpy(std::numbers::pi / 18.0, -0.2, 0.3);
  EXPECT_TRUE(roll_pitch_yaw(target.X_AB.R).isApprox(rpy, 1e-12));
  EXPECT_EQ(target.X_AB.p, Vector3(1, 2, 3));
  EXPECT_EQ(target.average_linear_velocity, 0.01);
  EXPECT_EQ(target.average_angular_velocity, 0.02);
  EXPECT_TRUE(target.ignore_timing_of_leg_motion);
  const auto trajectory = base_command<BaseTrajectory>(
      "base_trajectory: {trajectory: {frame: footprint, knots: ["
      "{time: 1, position: [0, 0, 1], orientation: [0, 0, 0.7071, 0.7071]}]}}");
  EXPECT_EQ(trajectory.frame, kFootprint);
  ASSERT_EQ(trajectory.knots.size(), 1U);
  EXPECT_TRUE(trajectory.knots[0].X_AB.R.isApprox(rotation_z(std::numbers::pi / 2.0), 1e-12));
}

TEST(LoadAction, HandsCustomCommandsOverAsText) {
  ActionVocabulary vocabulary;
  vocabulary.custom_types = {"lamp", "gripper"};
  vocabulary.placeholders = {{"force", "20"}};
  const Action action = parse(
      "steps:\n- step:\n  - custom_command:\n      type: gripper\n      duration: 1.5\n"
      "      command:\n        close: true\n        at: [1, \"2\", $force]\n        all: &a {b: "
      "~}\n"
      "        again: *a\n  - wait: {duration: 2}\n",
      vocabulary);
  ASSERT_EQ(action.steps.at(0).custom.size(), 1U);
  const CustomCommand& custom = action.steps[0].custom[0];
  EXPECT_EQ(custom.handler, 1);
  EXPECT_EQ(custom.type, "gripper");
  EXPECT_EQ(custom.duration, 1.5);
  EXPECT_EQ(custom.command, R"({close: true, at: [1, "2", 20], all: {b: ~}, again: {b: ~}})");
  EXPECT_EQ(action.steps[0].wait.duration, 2.0);
}

// 2 × (1 + 3) = 8 steps.
TEST(LoadAction, RepeatsStepsAlsoWithinRepetitions) {
  const Action action = parse(
      "steps:\n- repeat:\n    count: 2\n    steps:\n    - step: [base_auto: {height: 0.1}]\n"
      "    - repeat:\n      count: 3\n      steps:\n      - step:\n        - base_auto:\n"
      "          height: 0.2\n");
  ASSERT_EQ(action.steps.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(std::get<BaseAuto>(action.steps[i].base->motion).height, i % 4 == 0 ? 0.1 : 0.2);
}

// The program's values win; a list may stand for all of a value; `$` alone is a letter.
TEST(LoadAction, PutsValuesInThePlaceOfPlaceholders) {
  const std::string text =
      "name: costs $ 5\n"
      "placeholders: {side: L, height: 0.1, hold: [0.1, 0.2, 0.3]}\n"
      "steps:\n- step:\n  - footstep:\n    name: ${side}F\n    profile_height: $height\n"
      "    target: {frame: odom, position: $hold}\n";
  const Action own = parse(text);
  EXPECT_EQ(own.id, "costs $ 5");
  EXPECT_EQ(leg_motion(own.steps[0].legs[0]).leg, 0);
  const auto step = std::get<Footstep>(own.steps[0].legs[0].motion);
  EXPECT_EQ(step.profile_height, 0.1);
  EXPECT_EQ(step.target.p, Vector3(0.1, 0.2, 0.3));

  ActionVocabulary vocabulary;
  vocabulary.placeholders = {{"side", "R"}, {"hold", "[4, 5, 6]"}};
  const Action given = parse(text, vocabulary);
  EXPECT_EQ(leg_motion(given.steps[0].legs[0]).leg, 1);
  EXPECT_EQ(std::get<Footstep>(given.steps[0].legs[0].motion).target.p, Vector3(4, 5, 6));
}

TEST(LoadAction, ReadsWhereItsCommandsAreMeant) {
  ActionVocabulary vocabulary;
  const FrameId door = vocabulary.frames.add("door");
  const Action action = parse(
      "adapt_coordinates:\n"
      "- transform:\n    source_frame: footprint\n    target_frame: door\n"
      "    transform_in_source_frame: {position: [1, 2, 3], orientation: [0, 0, deg(90)]}\n"
      "  yaw_only: true\n"
      "- transform: {source_frame: map, target_frame: odom}\n"
      "steps: [step: [base_auto: ]]\n",
      vocabulary);
  ASSERT_EQ(action.adapt_coordinates.size(), 2U);
  EXPECT_EQ(action.adapt_coordinates[0].source, kFootprint);
  EXPECT_EQ(action.adapt_coordinates[0].target, door);
  EXPECT_EQ(action.adapt_coordinates[0].X_S.p, Vector3(1, 2, 3));
  EXPECT_TRUE(
      action.adapt_coordinates[0].X_S.R.isApprox(rotation_z(std::numbers::pi / 2.0), 1e-12));
  EXPECT_TRUE(action.adapt_coordinates[0].yaw_only);
  EXPECT_FALSE(action.adapt_coordinates[1].yaw_only);
  EXPECT_EQ(action.adapt_coordinates[1].X_S.R, Matrix3::Identity());
}

TEST(LoadAction, IsNamedAfterItsFileIfItHasNoName) {
  const char* text = "steps: [step: [base_auto: ]]";
  EXPECT_EQ(parse_action(text, "some/where/push_up.yaml", argos()).id, "push_up");
  EXPECT_EQ(parse(std::string("name: Push up\n") + text).id, "Push up");
}

// Steps, and commands in them, may be referred to as a whole.
TEST(LoadAction, FollowsReferencesToAnything) {
  const Action action = parse(
      "steps:\n- &first\n  step:\n  - &rise\n    base_auto: {height: 0.2}\n"
      "- step: [*rise]\n- *first\n- step: &list\n  - base_auto:\n- step: *list\n");
  ASSERT_EQ(action.steps.size(), 5U);
  for (const std::size_t i : {0U, 1U, 2U})
    EXPECT_EQ(std::get<BaseAuto>(action.steps[i].base->motion).height, 0.2);
  EXPECT_EQ(std::get<BaseAuto>(action.steps[4].base->motion).height, std::nullopt);
}

}  // namespace
}  // namespace hexagait::action
