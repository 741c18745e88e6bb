// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <console_bridge/console.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <sstream>

namespace hexagait {
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
  std::ifstream file(HEXAGAIT_SOURCE_DIR "/robots/argos.urdf");
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
      {"", "robot.urdf: URDF: Error document empty"},
      {"no xml", "robot.urdf: URDF: Error document empty.; it must be XML with a <robot> element"},
      {"<robot name='x'>", "robot.urdf: URDF: Error reading Element value"},
      {"<html/>", "robot.urdf: URDF: Could not find the 'robot' element"},
      {"<robot name='x'/>", "robot.urdf: URDF: No link elements found"},
      {"<robot name='x'><link name='a'/></robot>", "robot.urdf: robot: has 0 legs; need an even"}};
  for (const auto& [text, message] : texts) EXPECT_THAT(refusal(text), testing::HasSubstr(message));
}

TEST(ParseUrdf, RefusesNumbersThatAreNone) {
  const std::string knee = "name=\"LF_knee\"", femur = "link name=\"LF_femur\"";
  const Fault faults[] = {
      {"lower=\"0.0\"", "lower=\"nan\"", "lower value (nan) is not a valid float", knee},
      {"upper=\"2.76\"", "upper=\"inf\"", "upper value (inf) is not a valid float", knee},
      {"xyz=\"0.28 0 0\"", "xyz=\"nan 0 0\"", "origin element for joint [LF_knee]", knee},
      {"xyz=\"0.28 0 0\"", "xyz=\"0.28 0\"", "2 elements but 3 expected", knee},
      {"xyz=\"0.28 0 0\"", "xyz=\"1e300 0 0\"", "LF", knee},
      {"xyz=\"0 1 0\"", "xyz=\"0 nan 0\"", "Malformed axis element for joint [LF_knee]", knee},
      {"mass value=\"1.2\"", "mass value=\"nan\"", "inertial element for Link [LF_femur]", femur},
      {"mass value=\"1.2\"", "mass value=\"1.2 kg\"", "mass [1.2 kg] is not a float", femur},
      {"mass value=\"1.2\"", "mass value=\"1e308\"", "link LF_femur: ", femur},
      {"xyz=\"0.14 0 0\"", "xyz=\"1e200 0 0\"",
       "link LF_femur: mass, inertia or origin is not a finite number", femur},
      {"izz=\"0.0080275\"", "izz=\"nan\"", "inertia element izz is not a valid double", femur}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                testing::HasSubstr(fault.message));
}

TEST(ParseUrdf, RefusesImpossibleMassesAndShapes) {
  const std::string femur = "link name=\"LF_femur\"", foot = "link name=\"LF_foot\"";
  const Fault faults[] = {
      {"mass value=\"1.2\"", "mass value=\"-1.2\"", "link LF_femur: mass is -1.2 kg; it must be",
       femur},
      {"mass value=\"1.2\"", "mass value=\"0\"", "link LF_femur: mass is 0 kg; it must be", femur},
      {"mass value=\"0.02\"", "mass value=\"-0.1\"", "link LF_foot: mass is -0.1 kg", foot},
      {"izz=\"0.0080275\"", "izz=\"-1\"",
       "link LF_femur: smallest principal moment of inertia is -1 kg m^2; it must be", femur},
      {"radius=\"0.025\"", "radius=\"0\"",
       "link LF_femur: collision size is 0 m; it must be positive",
       "<collision>\n      <origin xyz=\"0.14"},
      {"<sphere radius=\"0.02\"/>", "<sphere radius=\"-0.02\"/>",
       "link LF_foot: collision size is -0.02 m", "<collision>\n      <geometry><sphere"},
      {"<sphere radius=\"0.02\"/>", "<sphere radius=\"0.03\"/>",
       "robot: foot radii range from 0.02 m (LM_tibia) to 0.03 m (LF_tibia); all feet must be "
       "alike",
       "<collision>\n      <geometry><sphere"},
      {"<sphere radius=\"0.02\"/>", "<box size=\"0.04 0.04 0.04\"/>",
       "link LF_tibia: has no collision sphere; a leg ends in a spherical foot",
       "<collision>\n      <geometry><sphere"}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                testing::HasSubstr(fault.message));
}

TEST(ParseUrdf, RefusesALinkWithoutMass) {
  const std::string text = argos_text();
  const std::size_t link = text.find("link name=\"LF_femur\"");
  const std::size_t begin = text.find("<inertial>", link), end = text.find("<visual>", link);
  const std::string massless = text.substr(0, begin) + text.substr(end);
  EXPECT_EQ(refusal(massless),
            "robot.urdf: link LF_femur: has no mass; it needs an <inertial> element");
}

TEST(ParseUrdf, RefusesImpossibleLimits) {
  const std::string yaw = "name=\"LF_yaw\"", knee = "name=\"LF_knee\"";
  const Fault faults[] = {
      {"lower=\"0.0\"", "lower=\"3\"",
       "joint LF_knee: lower limit 3 rad, upper limit 2.76 rad; need finite lower < upper", knee},
      {"lower=\"0.0\"", "lower=\"2.76\"", "joint LF_knee: lower limit 2.76 rad", knee},
      {"velocity=\"8\"", "velocity=\"0\"", "joint LF_yaw: velocity limit is 0 rad/s; it must be",
       yaw},
      {"effort=\"120\"", "effort=\"-1\"", "joint LF_yaw: effort limit is -1 N m; it must be", yaw},
      {"effort=\"120\"", "", "limit element for joint [LF_yaw]", yaw},
      {"<limit lower=\"-1.0\" upper=\"1.0\" velocity=\"8\" effort=\"120\"/>", "",
       "Joint [LF_yaw] is of type REVOLUTE but it does not specify limits", yaw},
      {"lower=\"0.0\" upper=\"2.76\"", "lower=\"0\" upper=\"1\"",
       "leg LF: cannot take its nominal stance: foot 0.36 m out from the yaw axis, 0.3 m below the "
       "hip, yaw 0; joint LF_knee would be at 104.8°, its limits are 0° to 57.3°",
       knee},
      {"lower=\"-1.0\"", "lower=\"0.2\"",
       "joint LF_yaw would be at 0°, its limits are 11.5° to 57.3°", yaw},
      {"lower=\"0.0\" upper=\"2.76\"", "lower=\"-2\" upper=\"-1\"",
       "joint LF_knee: limits -2 to -1 rad never let the knee bend upwards", knee}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                testing::HasSubstr(fault.message));
  const std::string unlimited = edited(argos_text(),
                                       "<limit lower=\"-1.0\" upper=\"1.0\" "
                                       "velocity=\"8\" effort=\"120\"/>",
                                       "");
  EXPECT_THAT(refusal(edited(unlimited, "type=\"revolute\"", "type=\"continuous\"")),
              testing::HasSubstr("joint LF_yaw: has no <limit>; velocity and effort are needed"));
}

TEST(ParseUrdf, RefusesChainsThatAreNoLegs) {
  const std::string yaw = "name=\"LF_yaw\"", hip = "name=\"LF_hip\"", knee = "name=\"LF_knee\"";
  const std::string immobile = "leg LF: its joints cannot move the foot in all three directions";
  const Fault faults[] = {
      {"axis xyz=\"0 1 0\"", "axis xyz=\"0 0 0\"",
       "joint LF_hip: axis has length 0; it must be a direction", hip},
      {"axis xyz=\"0 0 1\"", "axis xyz=\"0 1 0\"", immobile, yaw},
      {"xyz=\"0.28 0 0\"", "xyz=\"0 0 0\"", immobile, knee},
      {"xyz=\"0.38 0 0\"", "xyz=\"0 0 0\"", immobile},
      {"type=\"revolute\"", "type=\"fixed\"", "leg LF: has 2 movable joints; a leg has 3 to 6",
       yaw},
      {"type=\"fixed\"", "type=\"continuous\"", "joint LF_ankle: has no <limit>"},
      {"type=\"revolute\"", "type=\"prismatic\"",
       "joint LF_yaw: moves, but is neither revolute nor continuous", yaw},
      {"type=\"revolute\"", "type=\"wobbly\"", "Joint [LF_yaw] has no known type [wobbly]", yaw},
      {"<limit", "<mimic joint=\"RF_yaw\"/><limit", "joint LF_yaw: mimics RF_yaw", yaw}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                testing::HasSubstr(fault.message));
}

TEST(ParseUrdf, RefusesWhatIsNotATree) {
  const std::string tail =
      "<link name='t'/><joint name='tail' type='revolute'><parent link='LF_femur'"
      "/><child link='t'/><limit lower='0' upper='1' effort='1' velocity='1'/>"
      "</joint></robot>";
  const std::string second =
      "<joint name='again' type='fixed'><parent link='base_link'/>"
      "<child link='LF_foot'/></joint></robot>";
  const Fault faults[] = {
      {"link name=\"RF_coxa\"", "link name=\"LF_coxa\"", "link 'LF_coxa' is not unique"},
      {"joint name=\"RF_yaw\"", "joint name=\"LF_yaw\"", "joint 'LF_yaw' is not unique"},
      {"child link=\"LF_coxa\"", "child link=\"nowhere\"",
       "child link [nowhere] of joint [LF_yaw]"},
      {"child link=\"RF_foot\"", "child link=\"LF_foot\"", "Two root links found"},
      {"parent link=\"LF_tibia\"", "parent link=\"LF_foot\"",
       "robot argos: 1 of 25 links do not hang from the root link"},
      {"</robot>", second, "link LF_foot: has two parents, by the joints "},
      {"</robot>", tail,
       "link LF_femur: carries 2 movable joints; in a serial leg it carries at most"}};
  for (const Fault& fault : faults)
    EXPECT_THAT(refusal(edited(argos_text(), fault.from, fault.to, fault.after)),
                testing::HasSubstr(fault.message));
}

TEST(ParseUrdf, RefusesAnyNumberOfLegsThatDoesNotPair) {
  std::string stiff = argos_text();
  for (const char* joint : {"LM_yaw", "LM_hip", "LM_knee"})
    stiff = edited(stiff, "revolute", "fixed", "name=\"" + std::string(joint) + "\"");
  EXPECT_EQ(refusal(stiff), "robot.urdf: robot: has 5 legs; need an even number from 4 to 12");

  EXPECT_EQ(refusal(edited(argos_text(), "xyz=\"0 0.17 0\"", "xyz=\"0 -0.27 0\"")),
            "robot.urdf: robot: has 2 legs on the left and 4 on the right; need as many");
  EXPECT_THAT(
      refusal(edited(argos_text(), "xyz=\"0 0.17 0\"", "xyz=\"0 0 0\"")),
      testing::HasSubstr("leg LM: hip is at y = 0 m; it must be left or right of the middle"));
}

TEST(ParseUrdf, ListsAllViolationsAtOnceALineEach) {
  std::string text = edited(argos_text(), "mass value=\"1.2\"", "mass value=\"-1.2\"");
  text = edited(text, "lower=\"0.0\"", "lower=\"3\"", "name=\"RR_knee\"");
  text = edited(text, "type=\"revolute\"", "type=\"fixed\"", "name=\"LM_yaw\"");
  EXPECT_EQ(
      refusal(text),
      "robot.urdf: link LF_femur: mass is -1.2 kg; it must be positive\n"
      "robot.urdf: joint RR_knee: lower limit 3 rad, upper limit 2.76 rad; need finite lower < "
      "upper\n"
      "robot.urdf: leg LM: has 2 movable joints; a leg has 3 to 6");
}

// Commands would go to the first of them.
TEST(ParseUrdf, RefusesTwoLegsOfOneName) {
  std::string text = argos_text();
  int number = 0;
  for (const std::string leg : {"LF", "RF"})
    for (const char* joint : {"_yaw", "_hip", "_knee"})
      text = edited(text, "joint name=\"" + leg + joint,
                    "joint name=\"joint_" + std::to_string(++number));
  EXPECT_EQ(
      refusal(text),
      "robot.urdf: leg joint: is the name of two legs, that of joint joint_1 and that of joint "
      "joint_4; what the joints' names of a leg begin with must be its own, as LF in LF_yaw, "
      "LF_hip, LF_knee");
}

// LF in an action may mean LF_leg.
TEST(ParseUrdf, RefusesTwoLegsThatDifferOnlyBySuffix) {
  std::string text = argos_text();
  for (const char* joint : {"_yaw", "_hip", "_knee"})
    text = edited(text, std::string("joint name=\"RM") + joint,
                  std::string("joint name=\"LF_leg") + joint);
  EXPECT_EQ(refusal(text),
            "robot.urdf: leg LF_leg: and leg LF differ only by what actions may leave out, _leg or "
            "_LEG");
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// Read on, urdfdom calls itself 300 000 times, in quadratic time, until the stack is full.
TEST(ParseUrdf, RefusesElementsThatAreNestedTooDeep) {
  const std::string bomb = "<robot name='x'>\n" + repeated("<a>", 300'000);
  EXPECT_EQ(refusal(bomb), "robot.urdf: URDF: line 2: elements are nested deeper than 64");
  const auto nested = [](int depth) {
    return edited(argos_text(), "</robot>",
                  repeated("<a b='/>'>", depth) + repeated("</a>", depth) + "</robot>");
  };
  EXPECT_EQ(refusal(nested(63)), "");
  EXPECT_THAT(refusal(nested(64)), testing::HasSubstr("nested deeper than 64"));
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
              testing::HasSubstr("has more than 100000 elements"));
  EXPECT_THAT(refusal(std::string(10'000'001, ' ')),
              testing::HasSubstr("has 10000001 bytes; at most 10000000 are read"));
}

// 999 links without a mass are not 999 lines.
TEST(ParseUrdf, ListsAHundredViolationsAtMost) {
  std::string text = "<robot name='x'><link name='base'/>";
  for (int i = 0; i < 999; ++i) {
    const std::string n = std::to_string(i);
    text += "<link name='l" + n + "'/><joint name='j" + n +
            "' type='floating'><parent link='base'/><child link='l" + n + "'/></joint>";
  }
  const std::string lines = refusal(text + "</robot>");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 100);
}

TEST(ParseUrdf, KeepsUrdfdomFromPrinting) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  (void)refusal("<html/>");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

// console_bridge remembers two handlers, the one in use and the one before. That of the loader is
// gone with it.
TEST(ParseUrdf, LeavesNoHandlerBehind) {
  struct Silent : console_bridge::OutputHandler {
    void log(const std::string&, console_bridge::LogLevel, const char*, int) override {}
  } before, used;
  console_bridge::OutputHandler* const original = console_bridge::getOutputHandler();
  console_bridge::useOutputHandler(&before);
  console_bridge::useOutputHandler(&used);
  (void)refusal("<html/>");
  EXPECT_EQ(console_bridge::getOutputHandler(), &used);
  console_bridge::restorePreviousOutputHandler();
  EXPECT_EQ(console_bridge::getOutputHandler(), &before);
  console_bridge::useOutputHandler(original);
  console_bridge::useOutputHandler(original);
}

TEST(LoadUrdf, RefusesAFileThatCannotBeRead) {
  for (const auto& [path, reason] :
       {std::pair("/no/such.urdf", "can't be read: No such file or directory"),
        std::pair(HEXAGAIT_SOURCE_DIR, "is a directory")}) {
    try {
      (void)load_urdf(path);
      ADD_FAILURE() << path;
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.what(), std::string(path) + ": " + reason + "; a URDF is expected");
    }
  }
}

}  // namespace
}  // namespace hexagait
