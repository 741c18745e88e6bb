// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <hexagait/load/load_params.hpp>
#include <hexagait/params/set_parameter.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <string>
#include <vector>

namespace hexagait::load_params_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string written(const std::string& name, const std::string& text) {
  const std::string path = ::testing::TempDir() + name;
  std::ofstream(path) << text;
  return path;
}

template <class F>
std::string refusal(F f) {
  try {
    f();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(SetParameter, TakesUnits) {
  RobotParams params;
  set_parameter(params, "step.height=4cm");
  set_parameter(params, "swing.lift_time=150ms");
  set_parameter(params, "plant.servo_kp=50");
  EXPECT_DOUBLE_EQ(params.step.height, 0.04);
  EXPECT_DOUBLE_EQ(params.swing.lift_time, 0.15);
  EXPECT_DOUBLE_EQ(params.plant.servo_kp, 50.0);
}

TEST(SetParameter, SaysWhatIsWrong) {
  RobotParams params;
  const auto set = [&](const char* text) { return refusal([&] { set_parameter(params, text); }); };
  EXPECT_THAT(set("step.hight=4cm"), HasSubstr("step.height"));
  EXPECT_THAT(set("step.height"), HasSubstr("NAME=VALUE"));
  EXPECT_THAT(set("step.height=-4cm"), HasSubstr("greater than 0"));
  EXPECT_THAT(set("step.height=high"), HasSubstr("step.height: "));
  EXPECT_THAT(set("step.height=nan"), HasSubstr("step.height"));
  EXPECT_TRUE(is_derived(params.step.height));
}

// Of those RobotParams says what 0 does; the others would divide by it, or never move.
TEST(SetParameter, TakesZeroWhereItSwitchesOff) {
  std::vector<std::string> taken;
  for (const Parameter& one : parameters()) {
    RobotParams params;
    if (!refusal([&] { set_parameter(params, std::string(one.name) + "=0"); }).empty()) continue;
    EXPECT_EQ(one.in(params), 0.0) << one.name;
    taken.emplace_back(one.name);
  }
  EXPECT_THAT(taken, ElementsAre("step.stability_margin", "swing.even_load_rate",
                                 "base.displacement_period", "tolerance.servo_stiffness"));

  RobotParams params;
  EXPECT_THAT(refusal([&] { set_parameter(params, "tolerance.servo_stiffness=-1mm"); }),
              HasSubstr("0 or greater"));
}

TEST(LoadParams, TakesZeroWhereItSwitchesOff) {
  RobotParams params;
  load_params(params, written("off.yaml", "tolerance: {servo_stiffness: 0}\n"));
  EXPECT_EQ(params.tolerance.servo_stiffness, 0.0);
  const std::string path = written("zero.yaml", "step: {stroke: 0}\n");
  EXPECT_THAT(refusal([&] { load_params(params, path); }), HasSubstr("stroke"));
}

TEST(LoadParams, SetsWhatTheFileHas) {
  RobotParams params;
  load_params(params, written("good.yaml", "step: {height: 4cm}\nswing:\n  descent_speed: 0.2\n"));
  EXPECT_DOUBLE_EQ(params.step.height, 0.04);
  EXPECT_DOUBLE_EQ(params.swing.descent_speed, 0.2);
  EXPECT_TRUE(is_derived(params.step.stroke));
}

TEST(LoadParams, NamesEverythingThatIsWrongWithItsLine) {
  RobotParams params;
  const std::string path =
      written("bad.yaml", "step: {height: -1cm}\nswing: {lift_tyme: 0.2}\nswim: {}\n");
  const std::string text = refusal([&] { load_params(params, path); });
  EXPECT_THAT(text, HasSubstr("height"));
  EXPECT_THAT(text, HasSubstr("lift_time"));
  EXPECT_THAT(text, HasSubstr("swim"));
}

TEST(LoadParams, FindsTheFileBesideTheRobot) {
  const std::string urdf = written("ant.urdf", "");
  std::filesystem::remove(::testing::TempDir() + "ant.params.yaml");
  EXPECT_EQ(params_beside(urdf), "");
  const std::string file = written("ant.params.yaml", "step: {height: 1cm}\n");
  EXPECT_EQ(params_beside(urdf), file);
}

}  // namespace
}  // namespace hexagait::load_params_test
