// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <sstream>
#include <testing/source_path.hpp>

namespace hexagait::urdf_refusal_test {
namespace {

// Each test spoils the text of Argos in one place and looks for the message.

/// `text` with the first `from` after `after` replaced by `to`.
std::string edited(std::string text, const std::string& from, const std::string& to,
                   const std::string& after = "") {
  const std::size_t start = text.find(after);
  const std::size_t at = text.find(from, start);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string argos_text() {
  std::ifstream file(testing::source_path("robots/argos.urdf"));
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What the loader says against a text; empty if nothing.
std::string refusal(const std::string& xml) {
  try {
    (void)parse_urdf(xml, "robot.urdf");
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

struct Fault {
  std::string from, to, message;
  std::string after = "";
};

TEST(ParseUrdf, RefusesWhatIsNotARobot) {
  const std::pair<const char*, const char*> texts[] = {
      {"", "robot.urdf: URDF: is no XML (XML_ERROR_EMPTY_DOCUMENT)"},
      {"no xml",
       "robot.urdf:1: URDF: is no XML (XML_ERROR_PARSING_TEXT); it must be XML with a <robot>"},
      {"<robot name='x'>", "robot.urdf:1: URDF: is no XML (XML_ERROR_MISMATCHED_ELEMENT)"},
      {"<html/>", "robot.urdf: URDF: has no <robot> element"},
      {"<robot name='x'/>", "robot.urdf:1: robot x: has no links"},
      {"<robot name='x'><link name='a'/></robot>", "robot.urdf: robot: has 0 legs; need an even"}};
  for (const auto& [text, message] : texts)
    EXPECT_THAT(refusal(text), ::testing::HasSubstr(message));
}

TEST(ParseUrdf, RefusesNumbersThatAreNone) {
  const std::string knee = "name=\"LF_knee\"", femur = "link name=\"LF_femur\"";
  const Fault faults[] = {
      {"lower=\"0.0\"", "lower=\"nan\"",
       "robot.urdf:93: joint LF_knee: limit lower is 'nan'; a number is needed", knee},
      {"upper=\"2.76\"", "upper=\"inf\"", "limit upper is 'inf'; a number is needed", knee},
      {"xyz=\"0.28 0 0\"", "xyz=\"nan 0 0\"", "joint LF_knee: origin xyz is 'nan 0 0'; 3 numbers",
       knee},
      {"xyz=\"0.28 0 0\"", "xyz=\"0.28 0\"", "origin xyz is '0.28 0'; 3 numbers are needed", knee},
      {"xyz=\"0.28 0 0\"", "xyz=\"1e300 0 0\"", "joint LF_knee: origin xyz is '1e300 0 0'", knee},
      {"xyz=\"0 1 0\"", "xyz=\"0 nan 0\"", "joint LF_knee: axis xyz is '0 nan 0'", knee},
      {"mass value=\"1.2\"", "mass value=\"nan\"", "link LF_femur: mass value is 'nan'", femur},
      {"mass value=\"1.2\"", "mass value=\"1.2 kg\"",
       "link LF_femur: mass value is '1.2 kg'; a number", femur},
      {"mass value=\"1.2\"", "mass value=\"1e308\"", "link LF_femur: mass value is '1e308'", femur},
      {"xyz=\"0.14 0 0\"", "xyz=\"1e200 0 0\"",
       "link LF_femur: origin xyz is '1e200 0 0'; 3 numbers are needed, at most 1e9", femur},
      {"izz=\"0.0080275\"", "izz=\"nan\"", "link LF_femur: inertia izz is 'nan'", femur}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                ::testing::HasSubstr(fault.message));
}

TEST(ParseUrdf, RefusesImpossibleMassesAndShapes) {
  const std::string femur = "link name=\"LF_femur\"", foot = "link name=\"LF_foot\"";
  const Fault faults[] = {
      {"mass value=\"1.2\"", "mass value=\"-1.2\"",
       "robot.urdf:73: link LF_femur: mass is -1.2 kg; it must be positive", femur},
      {"mass value=\"0.02\"", "mass value=\"-0.1\"", "link LF_foot: mass is -0.1 kg", foot},
      {"radius=\"0.025\"", "radius=\"0\"",
       "link LF_femur: collision size is 0 m; it must be positive",
       "<collision>\n      <origin xyz=\"0.14"},
      {"<sphere radius=\"0.02\"/>", "<sphere radius=\"-0.02\"/>",
       "link LF_foot: collision size is -0.02 m", "<collision>\n      <geometry><sphere"},
      {"<sphere radius=\"0.02\"/>", "<sphere radius=\"0.03\"/>",
       "robot.urdf:125: robot: foot radii range from 0.02 m (RF_tibia) to 0.03 m (LF_tibia); all "
       "feet must be "
       "alike (--foot-radius)",
       "<collision>\n      <geometry><sphere"}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                ::testing::HasSubstr(fault.message));
}

TEST(ParseUrdf, RefusesImpossibleLimits) {
  const std::string yaw = "name=\"LF_yaw\"", knee = "name=\"LF_knee\"";
  const Fault faults[] = {
      {"lower=\"0.0\"", "lower=\"3\"",
       "robot.urdf:88: joint LF_knee: lower limit 3 rad, upper limit 2.76 rad; need lower < upper",
       knee},
      {"lower=\"0.0\"", "lower=\"2.76\"", "joint LF_knee: lower limit 2.76 rad", knee},
      {"lower=\"0.0\" upper=\"2.76\"", "lower=\"0\" upper=\"0.7\"",
       "leg LF: cannot take its nominal stance: foot 0.36 m out from the yaw axis, 0.3 m below the "
       "hip, yaw 0; joint LF_knee would be at 104.8°, its limits are 0° to 40.1°",
       knee},
      {"lower=\"0.0\" upper=\"2.76\"", "lower=\"-2\" upper=\"-1\"",
       "joint LF_knee: limits -2 to -1 rad never let the knee bend upwards", knee}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                ::testing::HasSubstr(fault.message));
}

TEST(ParseUrdf, RefusesChainsThatAreNoLegs) {
  const std::string yaw = "name=\"LF_yaw\"", hip = "name=\"LF_hip\"", knee = "name=\"LF_knee\"";
  const std::string immobile = "leg LF: its joints cannot move the foot in all three directions";
  const Fault faults[] = {
      {"axis xyz=\"0 1 0\"", "axis xyz=\"0 0 0\"",
       "joint LF_hip: axis has length 0; it must be a direction", hip},
      {"axis xyz=\"0 0 1\"", "axis xyz=\"0 1 0\"", immobile, yaw},
      {"xyz=\"0.28 0 0\"", "xyz=\"0 0 0\"", immobile, knee},
      {"type=\"revolute\"", "type=\"fixed\"",
       "leg of joint LF_hip: has 2 movable joints, and the other legs have more", yaw},
      {"type=\"revolute\"", "type=\"prismatic\"",
       "joint LF_yaw: moves, but is neither revolute nor continuous", yaw},
      {"type=\"revolute\"", "type=\"wobbly\"", "joint LF_yaw: type is 'wobbly'; it must be fixed",
       yaw},
      {"<limit", "<mimic joint=\"RF_yaw\"/><limit", "joint LF_yaw: mimics RF_yaw", yaw}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                ::testing::HasSubstr(fault.message));
}

TEST(ParseUrdf, RefusesWhatIsNotATree) {
  const std::string second =
      "<joint name='again' type='fixed'><parent link='base_link'/>"
      "<child link='LF_foot'/></joint></robot>";
  const Fault faults[] = {
      {"link name=\"RF_coxa\"", "link name=\"LF_coxa\"",
       "robot.urdf:138: link LF_coxa: has the name of the link in line 49"},
      {"joint name=\"RF_yaw\"", "joint name=\"LF_yaw\"",
       "joint LF_yaw: has the name of the joint in line 42"},
      {"child link=\"LF_coxa\"", "child link=\"nowhere\"",
       "joint LF_yaw: child is 'nowhere'; there is no such link"},
      {"child link=\"RF_foot\"", "child link=\"LF_foot\"",
       "link RF_foot: has no parent, nor has base_link; a robot has one root"},
      {"parent link=\"LF_tibia\"", "parent link=\"LF_foot\"",
       "robot argos: 1 of 25 links do not hang from the root link"},
      {"</robot>", second, "link LF_foot: has two parents, by the joints LF_ankle and again"}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                ::testing::HasSubstr(fault.message));
}

TEST(ParseUrdf, HoldsWhatBranchesOffALeg) {
  const std::string tail =
      "<link name='t'/><joint name='tail' type='revolute'><parent link='LF_femur'"
      "/><child link='t'/><limit lower='0' upper='1' effort='1' velocity='1'/>"
      "</joint></robot>";
  const RobotModel robot = parse_urdf(edited(argos_text(), "</robot>", tail), "robot.urdf");
  ASSERT_EQ(robot.substitutions.size(), 1U);
  EXPECT_EQ(robot.substitutions[0].element, "joint tail");
  EXPECT_EQ(robot.substitutions[0].found, "branches off a leg");
}

TEST(ParseUrdf, RefusesAnyNumberOfLegsThatDoesNotPair) {
  std::string stiff = argos_text();
  for (const char* joint : {"LM_yaw", "LM_hip", "LM_knee"})
    stiff = edited(stiff, "revolute", "fixed", "name=\"" + std::string(joint) + "\"");
  EXPECT_EQ(refusal(stiff), "robot.urdf: robot: has 5 legs; need an even number from 4 to 12");

  EXPECT_EQ(refusal(edited(argos_text(), "xyz=\"0 0.17 0\"", "xyz=\"0 -0.27 0\"")),
            "robot.urdf: robot: has 2 legs on the left and 4 on the right; need as many (--front, "
            "--legs)");
  EXPECT_THAT(
      refusal(edited(argos_text(), "xyz=\"0 0.17 0\"", "xyz=\"0 0 0\"")),
      ::testing::HasSubstr("leg LM: hip is at y = 0 m; it must be left or right of the middle"));
}

TEST(ParseUrdf, ListsAllViolationsAtOnceALineEach) {
  std::string text = edited(argos_text(), "lower=\"0.0\"", "lower=\"3\"", "name=\"RR_knee\"");
  text = edited(text, "type=\"revolute\"", "type=\"fixed\"", "name=\"LM_yaw\"");
  EXPECT_EQ(refusal(text),
            "robot.urdf:243: leg of joint LM_hip: has 2 movable joints, and the other legs have "
            "more: give "
            "it as many, or leave it out (--legs)\n"
            "robot.urdf:533: joint RR_knee: lower limit 3 rad, upper limit 2.76 rad; need lower < "
            "upper");
  text = edited(text, "mass value=\"1.2\"", "mass value=\"-1.2\"");
  text = edited(text, "mass value=\"0.78\"", "mass value=\"a\"");
  EXPECT_EQ(refusal(text),
            "robot.urdf:73: link LF_femur: mass is -1.2 kg; it must be positive\n"
            "robot.urdf:98: link LF_tibia: mass value is 'a'; a number is needed, at most 1e9");
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// A parser that calls itself per level fills its stack.
TEST(ParseUrdf, RefusesElementsThatAreNestedTooDeep) {
  const std::string bomb = "<robot name='x'>\n" + repeated("<a>", 300'000);
  EXPECT_EQ(refusal(bomb), "robot.urdf: URDF: line 2: elements are nested deeper than 64");
  const auto nested = [](int depth) {
    return edited(argos_text(), "</robot>",
                  repeated("<a b='/>'>", depth) + repeated("</a>", depth) + "</robot>");
  };
  EXPECT_EQ(refusal(nested(63)), "");
  EXPECT_THAT(refusal(nested(64)), ::testing::HasSubstr("nested deeper than 64"));
}

TEST(ParseUrdf, ReadsCommentsOfAnyContent) {
  EXPECT_EQ(
      refusal(edited(argos_text(), "</robot>", "<!-- " + repeated("<a>", 100) + "--></robot>")),
      "");
}

TEST(ParseUrdf, RefusesMoreLinksAndElementsAndBytesThanARobotHas) {
  std::string chain = "<robot name='x'><link name='l0'/>";
  for (int i = 1; i <= 20'000; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    chain += "<link name='l" + n + "'/><joint name='j" + n + "' type='fixed'><parent link='l" +
             before + "'/><child link='l" + n + "'/></joint>";
  }
  EXPECT_EQ(refusal(chain + "</robot>"), "robot.urdf: URDF: line 1: has more than 1000 links");
  EXPECT_THAT(refusal("<robot name='x'>" + repeated("<a/>", 100'001) + "</robot>"),
              ::testing::HasSubstr("has more than 100000 elements"));
  // The parser compares each attribute with all before it: 200 000 of them took it two minutes.
  const auto with_attributes = [](int count) {
    std::string tag = "<odd";
    for (int i = 0; i < count; ++i) tag += " a" + std::to_string(i) + "='1'";
    return edited(argos_text(), "</robot>", tag + "/></robot>");
  };
  EXPECT_EQ(refusal(with_attributes(100)), "");
  EXPECT_THAT(refusal(with_attributes(200'000)),
              ::testing::HasSubstr("has an element of more than 100 attributes"));
  EXPECT_THAT(refusal(std::string(10'000'001, ' ')),
              ::testing::HasSubstr("has 10000001 bytes; at most 10000000 are read"));
}

// 999 bad joints are not 999 lines.
TEST(ParseUrdf, ListsAHundredViolationsAtMost) {
  std::string text = "<robot name='x'><link name='base'/>";
  for (int i = 0; i < 999; ++i) {
    const std::string n = std::to_string(i);
    text += "<link name='l" + n + "'/><joint name='j" + n +
            "' type='odd'><parent link='base'/><child link='l" + n + "'/></joint>";
  }
  const std::string lines = refusal(text + "</robot>");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 100);
}

TEST(LoadUrdf, RefusesAFileThatCannotBeRead) {
  for (const auto& [path, reason] :
       {std::pair(std::string("/no/such.urdf"), "can't be read: No such file or directory"),
        std::pair(testing::source_path("."), "is a directory")}) {
    try {
      (void)load_urdf(path);
      ADD_FAILURE() << path;
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.what(), std::string(path) + ": " + reason + "; a URDF is expected");
    }
  }
}

}  // namespace
}  // namespace hexagait::urdf_refusal_test
