// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/load/load_action.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <span>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait::action {
namespace {

using ::testing::AllOf;
using testing::argos;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// What the loader says against a text; empty if nothing.
std::string refusal(const std::string& text, const ActionVocabulary& vocabulary = {}) {
  try {
    (void)parse_action(text, "bad.yaml", argos(), vocabulary);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

std::string refusal_of(const std::string& command) {
  return refusal("steps:\n- step:\n  - " + command + "\n");
}

struct Fault {
  std::string text, message;
};

void expect_refusals(std::span<const Fault> faults) {
  for (const auto& [command, message] : faults)
    EXPECT_THAT(refusal_of(command), HasSubstr(message)) << command;
}

constexpr const char* kTarget = "target: {frame: odom, position: [0, 0, 0]}";

TEST(LoadActionRefuses, WordsThatItDoesNotKnowAndNamesTheNearest) {
  const std::string target = kTarget;
  const Fault faults[] = {
      {"base_auto: {hieght: 0.1}",
       "bad.yaml:3:17: unknown key of base_auto \"hieght\"; did you mean \"height\"?"},
      {"base_outo:", "bad.yaml:3:5: unknown command \"base_outo\"; did you mean \"base_auto\"?"},
      {"footstep: {name: FR_LEG, " + target + "}",
       "bad.yaml:3:22: unknown leg \"FR_LEG\"; known: LF, RF, LM, RM, LR, RR"},
      {"footstep: {name: rf, " + target + "}", "unknown leg \"rf\""},
      {"footstep: {name: RF, target: {frame: footprnt, position: [0, 0, 0]}}",
       "bad.yaml:3:42: unknown frame \"footprnt\"; did you mean \"footprint\"?"},
      {"footstep: {name: RF, target: {frame: base_lnk, position: [0, 0, 0]}}",
       "did you mean \"base_link\"?"},
      {"footstep: {name: RF, profile_type: trianle, " + target + "}",
       "bad.yaml:3:40: unknown profile_type \"trianle\"; did you mean \"triangle\"?"},
      {"joint_target: {name: LF, target: {joint_names: [LF_yaw, LF_hip, LF_kne], "
       "positions: [0, 0, 0]}}",
       "bad.yaml:3:69: unknown joint of LF \"LF_kne\"; did you mean \"LF_knee\"?"},
      {"custom_command: {type: lamp}", "bad.yaml:3:28: unknown type \"lamp\"; none is known"}};
  expect_refusals(faults);
  ActionVocabulary vocabulary;
  vocabulary.custom_types = {"lamp"};
  EXPECT_THAT(refusal("steps: [step: [custom_command: {type: lammp}]]", vocabulary),
              HasSubstr("unknown type \"lammp\"; did you mean \"lamp\"?"));
}

// Four faults in one file, each on its line.
TEST(LoadActionRefuses, EverythingAtOnce) {
  EXPECT_EQ(
      refusal("steps:\n"
              "- step:\n"
              "  - base_auto: {height: -0.1}\n"
              "- step:\n"
              "  - footstep: {name: XX, target: {frame: odom, position: [0, 0]}}\n"
              "  - wait: {}\n"),
      "bad.yaml:3:25: height: is \"-0.1\"; it must be a length such as 0.05, 5cm or 50mm, of 0 or "
      "more\n"
      "bad.yaml:5:22: unknown leg \"XX\"; known: LF, RF, LM, RM, LR, RR\n"
      "bad.yaml:5:58: position: is a list of 2; it must be a list of 3 numbers\n"
      "bad.yaml:6:5: wait: the key \"duration\" is missing");
}

TEST(LoadActionRefuses, NumbersThatAreNone) {
  const std::string target = kTarget;
  const Fault faults[] = {
      {"base_auto: {height: .nan}", "height: '.nan' is not a length such as 0.05, 5cm or 50mm"},
      {"base_auto: {height: inf}", "height: 'inf' is not"},
      {"base_auto: {height: 1e999}", "height: '1e999' is not"},
      {"base_auto: {height: high}", "height: 'high' is not"},
      {"base_auto: {height: }", "height: is nothing"},
      {"base_auto: {height: [1]}", "height: is a list of 1"},
      {"base_auto: {height: 0.1s}", "height: '0.1s' is not a length"},
      {"base_auto: {height: deg(10)}", "height: 'deg(10)' is not"},
      {"base_auto: {average_linear_velocity: 0}", "it must be a finite number of more than 0"},
      {"base_auto: {average_angular_velocity: deg(-3)}", "or 0.5 (radians), of more than 0"},
      {"base_auto: {support_margin: -1}", "support_margin: is \"-1\""},
      {"base_auto: {ignore_timing_of_leg_motion: yes}", "is \"yes\"; it must be true or false"},
      {"footstep: {name: RF, average_velocity: -1, " + target + "}", "average_velocity: is \"-1\""},
      {"footstep: {name: RF, profile_height: -0.1, " + target + "}", "profile_height: is \"-0.1\""},
      {"leg_mode: {name: RF, duration: 0}", "duration: is \"0\""},
      {"wait: {duration: 0}", "duration: is \"0\""},
      {"footstep: {name: RF, surface_normal: {frame: odom, vector: [0, 0, 0]}, " + target + "}",
       "vector: is 0; a surface normal must have a direction"},
      {"joint_target: {name: RF, position: [0, deg(x), 0]}",
       "position: 'deg(x)' is not a finite angle such as 30deg, 0.5rad or 0.5 (radians)"},
      {"base_target: {target: {frame: odom, position: [0, 0, 0], orientation: [0, 0, 0, 1.01]}}",
       "orientation: is a quaternion of length 1.01; x, y, z, w must have length 1"},
      {"base_target: {target: {frame: odom, position: [0, 0, 0], orientation: [0, 0]}}",
       "orientation: is a list of 2; it must be a list of 3 or 4 numbers"}};
  expect_refusals(faults);
}

// Finite as they stand, but what is made of them is not: 1e200² and 1 / 1e-200⁵ overflow.
TEST(LoadActionRefuses, NumbersOfWhichMotionsWouldOverflow) {
  const std::string knots =
      "end_effector_trajectory: {name: RF, trajectory: {frame: odom, knots: [";
  const Fault faults[] = {
      {knots + "{time: 1e200, position: [0, 0, 0]}]}}",
       "time: '1e200' is out of range; at most 1e9"},
      {knots + "{time: 1e-200, position: [0, 0, 0]}]}}", "time: \"1e-200\" is too small"},
      {knots + "{time: 1, position: [0, 0, 0]}, {time: 1.0000000001, position: [0, 0, 0]}]}}",
       "it must be later than the knot before"},
      {knots + "{time: 1, position: [0, 0, 0], velocity: [0, -1e200, 0]}]}}",
       "velocity: '-1e200' is out of range"},
      {"footstep: {name: RF, target: {frame: odom, position: [1e200, 0, 0]}}",
       "position: '1e200' is out of range"},
      {"footstep: {name: RF, average_velocity: 1e-200, " + std::string(kTarget) + "}",
       "average_velocity: \"1e-200\" is too small"},
      {"joint_target: {name: RF, velocity: [1e200, 0, 0]}", "velocity: '1e200' is out of range"},
      {"wait: {duration: 1e10}", "duration: '1e10' is out of range"}};
  expect_refusals(faults);
}

// `@` stands for the number: at its bound it is read, beyond it refused.
TEST(LoadActionRefuses, NumbersThatNoRobotComesNear) {
  const std::string foot = "end_effector_target: {name: RF, target_position: {frame: odom, ";
  const std::string place = foot + "position: [0, 0, 0]}, ", knee = "joint_target: {name: RF, ";
  const std::string knots = "joint_trajectory: {name: LF, trajectory: {joint_names: [LF_yaw, ";
  const std::string base = "base_target: {target: {frame: odom, ";
  struct Bound {
    std::string command, most, beyond, message;
  };
  const Bound bounds[] = {
      {foot + "position: [0, @, 0]}}", "-1e7", "-1.1e7", "at most 1e+07 m is read"},
      {place + "target_velocity: [0, @, 0]}", "100", "101", "at most 100 is read"},
      {place + "target_acceleration: [0, @, 0]}", "-1e4", "-10001", "at most 10000 is read"},
      {place + "target_force: [0, @, 0]}", "1e6", "1000001", "at most 1e+06 is read"},
      {place + "average_velocity: @}", "100", "101", "at most 100 is read"},
      {knee + "position: [0, @, 0]}", "36000deg", "36001deg", "at most 628.319 rad is read"},
      {knee + "velocity: [0, @, 0]}", "1e4", "10001", "at most 10000 is read"},
      {knee + "acceleration: [0, @, 0]}", "1e6", "1000001", "at most 1e+06 is read"},
      {knee + "effort: [0, @, 0]}", "1e6", "1000001", "at most 1e+06 is read"},
      {knots + "LF_hip, LF_knee], knots: [{time: @, positions: [0, 0, 0]}]}}", "1440min", "1441min",
       "time: \"1441min\" is out of range; at most 86400 s is read"},
      {base + "position: [0, 0, @], orientation: [0, 0, 0]}}", "1e7", "1.1e7", "at most 1e+07 m"},
      {base + "position: [0, 0, 0], orientation: [0, 0, @]}}", "36000deg", "36001deg",
       "at most 628.319 rad"},
      {"base_auto: {height: @}", "100", "10001cm", "height: \"10001cm\" is out of range"},
      {"wait: {duration: @}", "86400", "86401", "at most 86400 s is read"}};
  for (const Bound& bound : bounds) {
    const auto with = [&bound](const std::string& number) {
      std::string command = bound.command;
      return command.replace(command.find('@'), 1, number);
    };
    EXPECT_EQ(refusal_of(with(bound.most)), "") << bound.command;
    EXPECT_THAT(refusal_of(with(bound.beyond)), HasSubstr(bound.message)) << bound.command;
  }
}

// Poses of frames are bounded like all others.
TEST(LoadActionRefuses, FramesOutOfRange) {
  EXPECT_THAT(
      refusal("adapt_coordinates:\n- transform: {source_frame: footprint, target_frame: map, "
              "transform_in_source_frame: {position: [1e8, 0, 0], orientation: [0, 0, 0]}}\n"
              "steps: [step: [base_auto: ]]"),
      HasSubstr("bad.yaml:2:98: position: \"1e8\" is out of range; at most 1e+07 m"));
}

// A curve begins where the foot, the joints or the base are: a knot at 0 would be left out.
TEST(LoadActionRefuses, KnotsAtTimeZero) {
  const Fault faults[] = {
      {"end_effector_trajectory: {name: RF, trajectory: {frame: odom, knots: [{time: 0, position: "
       "[0, 0, 0]}]}}",
       "time: is \"0\"; it must be a time such as"},
      {"base_trajectory: {trajectory: {frame: odom, knots: [{time: 0, position: [0, 0, 0], "
       "orientation: [0, 0, 0]}]}}",
       "of more than 0"},
      {"joint_trajectory: {name: LF, trajectory: {joint_names: [LF_yaw, LF_hip, LF_knee], knots: "
       "[{time: 0, positions: [0, 0, 0]}]}}",
       "of more than 0"}};
  expect_refusals(faults);
}

TEST(LoadActionRefuses, BareAnglesThatMustBeDegrees) {
  const Fault faults[] = {
      {"joint_target: {name: RF, position: [0, 45, 0]}",
       "position: '45': an angle without a unit is in radians and at most 2π; write 45deg"},
      {"base_target: {target: {frame: odom, position: [0, 0, 0], orientation: [0, 0, -90]}}",
       "orientation: '-90': an angle without a unit is in radians"}};
  expect_refusals(faults);
  EXPECT_EQ(refusal_of("joint_target: {name: RF, position: [0, 45deg, 0.5rad]}"), "");
  EXPECT_EQ(refusal_of("joint_target: {name: RF, velocity: [0, 8, 0]}"), "")
      << "a rate may be more";
  EXPECT_EQ(refusal_of("base_auto: {height: 30cm}"), "");
  EXPECT_EQ(refusal_of("wait: {duration: 500ms}"), "");
}

TEST(LoadActionRefuses, WhatIsMissing) {
  const Fault faults[] = {
      {"footstep:", "bad.yaml:3:5: footstep: the key \"name\" is missing"},
      {"footstep:", "bad.yaml:3:5: footstep: the key \"target\" is missing"},
      {"footstep: {name: LF, target: {position: [0, 0, 0]}}",
       "foot target: the key \"frame\" is missing"},
      {"end_effector_target: {name: LF}", "the key \"target_position\" is missing"},
      {"joint_target: {name: LF}", "joint_target: says nothing"},
      {"base_target: {}", "base_target: the key \"target\" is missing"},
      {"base_target: {target: {frame: odom, position: [0, 0, 0]}}",
       "base pose: the key \"orientation\" is missing"},
      {"custom_command: {duration: 1}", "custom_command: the key \"type\" is missing"}};
  expect_refusals(faults);
}

TEST(LoadActionRefuses, TrajectoriesThatCannotBeFollowed) {
  const std::string base = "base_trajectory: {trajectory: {frame: odom, knots: ";
  const std::string pose = ", position: [0, 0, 0], orientation: [0, 0, 0]}";
  const std::string leg = "joint_trajectory: {name: LF, trajectory: {";
  const std::string names = "joint_names: [LF_yaw, LF_hip, LF_knee], ";
  const Fault faults[] = {
      {base + "[]}}", "knots: is an empty list; a trajectory needs at least one knot"},
      {base + "[{time: -1" + pose + "]}}",
       "time: is \"-1\"; it must be a time such as 2, 2s, 20ms or 1min, of more than 0"},
      {base + "[{time: 1" + pose + ", {time: 1" + pose + "]}}",
       "time: is 1 s; it must be later than the knot before, at 1 s"},
      {base + "{}}}", "knots: is a map; it must be a list"},
      {leg + "knots: []}}", "the key \"joint_names\" is missing"},
      {leg + "joint_names: [LF_yaw, LF_hip], knots: [{time: 1, positions: [0, 0, 0]}]}}",
       "joint_names: is a list of 2; it must be all joints of LF: LF_yaw, LF_hip, LF_knee"},
      {leg + "joint_names: [LF_yaw, LF_hip, LF_yaw], knots: [{time: 1, positions: [0, 0, 0]}]}}",
       "joint \"LF_yaw\" stands here a second time"},
      {leg + "joint_names: [RF_yaw, RF_hip, RF_knee], knots: [{time: 1, positions: [0, 0, 0]}]}}",
       "unknown joint of LF \"RF_yaw\""},
      {leg + names + "knots: [{time: 1}]}}", "joint knot: says nothing"},
      {leg + names + "knots: [{time: 1, positions: [0, 0]}]}}", "positions: is a list of 2"},
      {leg + names + "knots: [{time: 1, positions: [0, 0, 0]}, {time: 2, efforts: [0, 0, 0]}]}}",
       "positions: stand in some knots and not in others"}};
  expect_refusals(faults);
}

TEST(LoadActionRefuses, TwoMotionsOfOneLegOrOfTheBaseInAStep) {
  EXPECT_EQ(refusal("steps:\n- step:\n  - leg_mode: {name: LF}\n  - leg_mode: {name: RF}\n"
                    "  - leg_mode: {name: LF_LEG}\n  - base_auto:\n  - base_auto: {height: 1}\n"),
            "bad.yaml:5:5: leg LF has a motion in this step already, at 3:5; a step has one at "
            "most\n"
            "bad.yaml:7:5: the base has a motion in this step already, at 6:5; a step has one at "
            "most");
}

TEST(LoadActionRefuses, WrongShapes) {
  const Fault faults[] = {{"", "command, such as base_auto:"},
                          {"base_auto", "base_auto: a command ends in a colon"},
                          {"[base_auto]", "is a list of 1; it must be a command"},
                          {"base_auto: 3", "base_auto: is \"3\"; it must be a map of options"},
                          {"{base_auto: , wait: {duration: 1}}", "stands in one entry with"},
                          {"base_auto: {height: 1}\n    support_margin: 0",
                           "base_auto: has options under it and beside it; it must be either"},
                          {"base_auto: {height: 1, height: 2}",
                           "bad.yaml:3:28: the key \"height\" stands here a second time; the "
                           "first is at 3:17"},
                          {"base_auto:\n    height: 1\n    height: 2", "bad.yaml:5:5: the key"},
                          {"base_auto: {[1]: 2}", "a key is a list of 1; it must be a word"},
                          {"leg_mode: [name, LF]", "leg_mode: is a list of 2"}};
  expect_refusals(faults);
  const Fault files[] = {
      {"", "bad.yaml:1:1: action: is nothing; it must be a map of name, robot, placeholders, "},
      {"steps: []", "steps: is empty"},
      {"step: []", "unknown key of action \"step\"; did you mean \"steps\"?"},
      {"steps:\n- step:", "bad.yaml:2:3: step: is empty"},
      {"steps:\n- step: []", "bad.yaml:2:3: step: is empty"},
      {"steps:\n- step: {base_auto: }", "step: is a map; it must be a list"},
      {"steps:\n- stop:", "unknown key of entry of steps \"stop\"; did you mean \"step\"?"},
      {"steps: [3]", "is \"3\"; it must be a map of step, repeat"},
      {"steps: [{}]", "is an empty map; it must be step: or repeat:"},
      {"- steps", "is a list of 1; it must be a map"}};
  for (const auto& [text, message] : files) EXPECT_THAT(refusal(text), HasSubstr(message)) << text;
}

TEST(LoadActionRefuses, WhatIsNotYaml) {
  EXPECT_THAT(refusal("steps: [1, 2"), StartsWith("bad.yaml:1:1: not YAML: end of sequence"));
  EXPECT_THAT(refusal("steps: *foot"), StartsWith("bad.yaml:1:8: not YAML: "));
  EXPECT_THAT(refusal("a: 1\n---\nb: 2"), HasSubstr("more than one YAML document"));
  EXPECT_THAT(refusal("steps: &a [*a]"), HasSubstr("1:12: refers to what it is itself a part of"));
  EXPECT_THAT(refusal(std::string(2'000, '[')), HasSubstr("not YAML"));
}

TEST(LoadActionRefuses, PlaceholdersWithoutAValue) {
  EXPECT_THAT(refusal("placeholders: {height: 1}\nsteps: [step: [base_auto: {height: $hieght}]]"),
              HasSubstr("bad.yaml:2:36: unknown placeholder \"hieght\"; did you mean \"height\"?"));
  EXPECT_THAT(refusal("placeholders: {a: {b: c}}\nsteps: [step: [base_auto: ]]"),
              HasSubstr("placeholder \"a\": is a map; it must be a value or a list"));
  EXPECT_THAT(refusal("placeholders: {a: [1]}\nname: x$a\nsteps: [step: [base_auto: ]]"),
              HasSubstr("placeholder \"a\": is a list; it can't be a part of \"x$a\""));
  EXPECT_THAT(refusal("placeholders: {h: -1}\nsteps: [step: [base_auto: {height: $h}]]"),
              HasSubstr("bad.yaml:2:36: height: is \"-1\""));
}

TEST(LoadActionRefuses, AdaptationsThatAreNone) {
  const auto of = [](const std::string& list) {
    return refusal("adapt_coordinates: [" + list + "]\nsteps: [step: [base_auto: ]]");
  };
  EXPECT_THAT(of("transform: {source_frame: map, target_frame: map}"), HasSubstr("are the same"));
  EXPECT_THAT(of("transform: {source_frame: map}"), HasSubstr("\"target_frame\" is missing"));
  EXPECT_THAT(of("transform: {source_frame: map, target_frame: odom}, "
                 "transform: {source_frame: map, target_frame: base}"),
              HasSubstr("of frame map there is one already"));
  EXPECT_THAT(of("yaw_only: true"), HasSubstr("the key \"transform\" is missing"));
}

TEST(LoadActionRefuses, MoreThanItCanHold) {
  const std::string step = "[step: [base_auto: ]]";
  const auto repeat = [](const std::string& count, const std::string& steps) {
    return "[repeat: {count: " + count + ", steps: " + steps + "}]";
  };
  EXPECT_EQ(refusal("steps: " + repeat("100", repeat("100", step))), "");
  EXPECT_THAT(refusal("steps: " + repeat("101", repeat("100", step))),
              HasSubstr("makes more than 10000 steps, 10000 commands or 100000 knots"));
  EXPECT_THAT(refusal("steps: " + repeat("1.5", step)), HasSubstr("a whole number from 1 to"));
  EXPECT_THAT(refusal("steps: " + repeat("0", step)), HasSubstr("count: is \"0\""));
  std::string nested = step;
  for (int i = 0; i < 17; ++i) nested = repeat("1", nested);
  EXPECT_THAT(refusal("steps: " + nested), HasSubstr("repeat: is nested deeper than 16"));
  EXPECT_THAT(refusal(std::string(1'000'001, ' ')), HasSubstr("has 1000001 bytes"));
}

// Nine lists of nine references each to the one before: 9⁹ values in 300 bytes.
TEST(LoadActionRefuses, ReferencesThatMultiplyWithoutBound) {
  std::string bomb = "name: &x0 [x]\nplaceholders: {}\nadapt_coordinates: []\nsteps:\n";
  std::string steps = "- &s0 {step: [custom_command: {type: lamp, command: &c0 [a, a, a]}]}\n";
  for (int i = 1; i < 10; ++i) {
    const std::string n = std::to_string(i), c = "*c" + std::to_string(i - 1);
    std::string list = c;
    for (int k = 1; k < 9; ++k) list.append(", ").append(c);
    steps += "- step: [custom_command: {type: lamp, command: &c" + n + " [" + list + "]}]\n";
  }
  ActionVocabulary vocabulary;
  vocabulary.custom_types = {"lamp"};
  EXPECT_THAT(refusal("steps:\n" + steps, vocabulary), HasSubstr("has more than 100000 letters"));

  // Repetitions of repetitions by reference, of which none is nested.
  std::string repeats = "steps:\n- repeat: &r0 {count: 1, steps: [step: [base_auto: ]]}\n";
  for (int i = 1; i < 14; ++i) {
    const std::string r = "repeat: *r" + std::to_string(i - 1);
    repeats += "- repeat: &r" + std::to_string(i) + " {count: 1, steps: [{" + r + "}, {" + r +
               "}, {" + r + "}]}\n";
  }
  EXPECT_THAT(refusal(repeats), AllOf(HasSubstr("bad.yaml:"), HasSubstr("more than")));
}

// 15 repeats in one another, each with a reference to all that stands before it in its list: 2¹⁵
// times 10 000 steps in a few kB. Read on after the first list that is too long, it takes minutes.
TEST(LoadActionRefuses, RepeatsThatMultiplyByNestedReferences) {
  std::string steps = "[step: [base_auto: ]]";
  for (int i = 0; i < 15; ++i) {
    std::string list = "[&r" + std::to_string(i);
    list.append(" {repeat: {count: 10000, steps: ").append(steps).append("}}, *r");
    steps = list.append(std::to_string(i)).append("]");
  }
  const std::string message = refusal("steps: " + steps);
  EXPECT_THAT(message, HasSubstr("makes more than 10000 steps"));
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << "it stops at the first";
}

TEST(LoadActionRefuses, NoMoreThanAHundredTimes) {
  std::string text = "steps:\n- step:\n";
  for (int i = 0; i < 300; ++i) text += "  - base_auto: {height: -1}\n";
  const std::string lines = refusal(text);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 100);
}

TEST(LoadActionRefuses, FilesThatCannotBeRead) {
  for (const std::string& path : {std::string("no/such/file.yaml"), testing::source_path(".")}) {
    EXPECT_THROW((void)load_action(path, argos()), InvalidInput);
  }
}

}  // namespace
}  // namespace hexagait::action
