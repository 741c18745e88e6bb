// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/viewer/walking/breakage.hpp>
#include <testing/argos_walk.hpp>
#include <testing/source_path.hpp>

namespace hexagait::viewer::breakage_test {
namespace {

using ::testing::HasSubstr;
using walk::parse_part_fault;
using walk::PartFault;

const RobotModel& robot(const char* name) {
  static const RobotModel mite = load_urdf(hexagait::testing::source_path("robots/mite.urdf"));
  return std::string_view(name) == "mite" ? mite : testing::argos();
}

std::string refusal(const std::string& text, const std::vector<PartFault>& present = {},
                    const char* name = "argos") {
  try {
    (void)admitted(parse_part_fault(text), present, robot(name));
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "admitted";
}

TEST(Breakage, FindsLegAndJoint) {
  EXPECT_EQ(admitted(parse_part_fault("cut:RM"), {}, robot("argos")).leg, 3);
  const PartFault weak = admitted(parse_part_fault("weak:LF_knee:50%"), {}, robot("argos"));
  EXPECT_EQ(weak.leg, 0);
  EXPECT_EQ(weak.joint, 2);
  EXPECT_THAT(refusal("cut:LX"), HasSubstr("argos has no leg 'LX'"));
}

// 15 kg are a load for 50 kg, and not for 200 g.
TEST(Breakage, BoundsLoadsAndPushesByTheRobot) {
  EXPECT_EQ(refusal("load:15kg:0:0"), "admitted");
  EXPECT_THAT(refusal("load:15kg:0:0", {}, "mite"), HasSubstr("too heavy for mite; at most"));
  EXPECT_THAT(refusal("load:9000kg:0:0"), HasSubstr("too heavy for argos; at most"));
  EXPECT_EQ(refusal("push:50Ns:90deg"), "admitted");
  EXPECT_THAT(refusal("push:50Ns:90deg", {}, "mite"), HasSubstr("too hard for mite; at most"));
}

TEST(Breakage, RefusesWhatIsThereAndTooMany) {
  std::vector<PartFault> present = {parse_part_fault("cut:RM")};
  EXPECT_THAT(refusal("cut:RM", present), HasSubstr("'cut:RM': it is there already"));
  EXPECT_EQ(refusal("cut:LF", present), "admitted");
  for (std::size_t k = 0; k < kMostFaults; ++k)
    present.push_back(parse_part_fault(fmt::format("bias:LF_knee:{}mrad", k + 1)));
  EXPECT_THAT(refusal("cut:LF", present), HasSubstr("mend them first"));
}

// Whatever a page offers to begin with is a fault of this robot.
TEST(Breakage, ExamplesOfAllKindsAreAdmitted) {
  for (const char* const name : {"argos", "mite"})
    for (const walk::PartFaultWords& kind : walk::part_fault_kinds()) {
      const LegModel& leg = robot(name).legs[1];
      const std::string_view syntax = kind.syntax;
      std::string text(syntax.substr(0, syntax.find(':')));
      if (syntax.find(":LEG") != std::string_view::npos)
        text = fmt::format("{}:{}", text, short_leg_name(leg.name));
      if (syntax.find(":JOINT") != std::string_view::npos)
        text = fmt::format("{}:{}", text, leg.joint_names[1]);
      const std::string values = walk::example_values(kind.kind, robot(name));
      if (!values.empty()) text = fmt::format("{}:{}", text, values);
      EXPECT_EQ(refusal(text, {}, name), "admitted") << text;
    }
}

}  // namespace
}  // namespace hexagait::viewer::breakage_test
