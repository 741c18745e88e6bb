// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/schedule.hpp>

namespace hexagait::walk {
namespace {

using heading_control::Heading;
using heading_control::Turn;
using ::testing::AllOf;
using ::testing::HasSubstr;

// A file that lasts as long as the test.
class ScheduleFile {
 public:
  explicit ScheduleFile(const std::string& text)
      : path_(::testing::TempDir() + "schedule-" + std::to_string(getpid()) + ".yaml") {
    std::ofstream(path_) << text;
  }
  ~ScheduleFile() { std::filesystem::remove(path_); }
  ScheduleFile(const ScheduleFile&) = delete;
  ScheduleFile& operator=(const ScheduleFile&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string refusal(const std::string& text) {
  const ScheduleFile file(text);
  try {
    (void)load_schedule(file.path());
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.path()));
    return error.what();
  }
  return "accepted";
}

TEST(Schedule, ReadsEveryKindOfCommand) {
  const ScheduleFile file(
      "- {at: 0, radius: inf}\n"
      "- {at: 5, radius: -1.5, crab: 20deg}\n"
      "- {at: 9, spin: cw}\n"
      "- {at: 10.5, crab: 0.5}\n"
      "- {at: 12, stop: true}\n");
  const Schedule schedule = load_schedule(file.path());
  ASSERT_EQ(schedule.size(), 5U);
  EXPECT_EQ(schedule[0].heading, Heading::straight(0.0));
  EXPECT_EQ(schedule[1].heading, Heading::arc(-1.5, 20.0 * std::numbers::pi / 180.0));
  EXPECT_EQ(schedule[2].heading, Heading::spin(Turn::cw));
  EXPECT_EQ(schedule[3].heading, Heading::straight(0.5));
  EXPECT_EQ(schedule[3].time, 10.5);
  EXPECT_EQ(schedule[4].heading, Heading::stop());
}

// β belongs to a command of any kind, holds until another is given, and alone keeps the heading:
// straight on if there was none.
TEST(Schedule, ReadsDutyFactorsWithAndWithoutAHeading) {
  const ScheduleFile file(
      "- {at: 0, duty_factor: 0.5}\n"
      "- {at: 1, radius: -1.5, duty_factor: 0.75}\n"
      "- {at: 2, duty_factor: 0.6}\n"
      "- {at: 3, spin: cw}\n"
      "- {at: 4, stop: true, duty_factor: 0.8}\n");
  const Schedule schedule = load_schedule(file.path());
  ASSERT_EQ(schedule.size(), 5U);
  EXPECT_EQ(schedule[0].heading, Heading::straight(0.0));
  EXPECT_EQ(schedule[0].duty_factor, 0.5);
  EXPECT_EQ(schedule[1].heading, Heading::arc(-1.5, 0.0));
  EXPECT_EQ(schedule[1].duty_factor, 0.75);
  EXPECT_EQ(schedule[2].heading, Heading::arc(-1.5, 0.0));
  EXPECT_EQ(schedule[2].duty_factor, 0.6);
  EXPECT_EQ(schedule[3].heading, Heading::spin(Turn::cw));
  EXPECT_FALSE(schedule[3].duty_factor);
  EXPECT_EQ(schedule[4].heading, Heading::stop());
}

TEST(Schedule, RefusesDutyFactorsThatNoWaveGaitHas) {
  for (const char* value : {"0.49", "1", "-0.7", "nan", "most", "''", "[0.6]"})
    EXPECT_THAT(refusal(std::string("- {at: 0}\n- {at: 1, duty_factor: ") + value + "}\n"),
                AllOf(HasSubstr(":2:"), HasSubstr("duty_factor: is"), HasSubstr("at least 0.5")));
}

TEST(Schedule, RefusesEveryMistakeWithItsLineAndWhatWouldBeRight) {
  EXPECT_THAT(refusal("- {at: 0}\n- {at: 1, spin: left}\n"),
              AllOf(HasSubstr(":2:17: "), HasSubstr("\"left\""), HasSubstr("known: ccw, cw")));
  EXPECT_THAT(refusal("- {at: 0, radius: 0}\n"), AllOf(HasSubstr(":1:19: "), HasSubstr("spin")));
  EXPECT_THAT(refusal("- {at: 0, radius: nan}\n"), AllOf(HasSubstr(":1:19: "), HasSubstr("'nan'")));
  EXPECT_THAT(refusal("- {at: 0, crab: inf}\n"), AllOf(HasSubstr(":1:17: "), HasSubstr("30deg")));
  EXPECT_THAT(refusal("- {at: 0, crab: 3turns}\n"), HasSubstr("'3turns'"));
  EXPECT_THAT(refusal("- {at: 0, stop: maybe}\n"), HasSubstr("\"maybe\""));
  EXPECT_THAT(refusal("- {at: 0, speed: 3}\n"), HasSubstr("unknown key of command \"speed\""));
  EXPECT_THAT(refusal("- {at: 0, radius: 1, spin: cw}\n"), HasSubstr("exclude each other"));
  EXPECT_THAT(refusal("- {radius: 1}\n"), HasSubstr("the key \"at\" is missing"));
  EXPECT_THAT(refusal("- {at: -1}\n"), HasSubstr("at: is \"-1\""));
  EXPECT_THAT(refusal("- {at: soon}\n"), HasSubstr("'soon'"));
  EXPECT_THAT(refusal("- {at: [1]}\n"), HasSubstr("at: is a list of 1"));
  EXPECT_THAT(refusal("- forwards\n"), HasSubstr("must be a map of at, radius"));
  EXPECT_THAT(refusal("- {at: 3}\n- {at: 3}\n"),
              AllOf(HasSubstr(":2:8: "), HasSubstr("not later")));
}

TEST(Schedule, RefusesAKeyThatStandsTwiceAndABareAngleOfDegrees) {
  EXPECT_THAT(refusal("- {at: 0, radius: 1, radius: 2}\n"),
              AllOf(HasSubstr(":1:22: "), HasSubstr("\"radius\" stands here a second time")));
  EXPECT_THAT(refusal("- {at: 0, crab: 45}\n"),
              HasSubstr("crab: '45': an angle without a unit is in radians and at most 2π; write "
                        "45deg"));
  EXPECT_THAT(refusal("- {at: 0, radius: 1e300}\n"), HasSubstr("out of range"));
}

TEST(Schedule, RefusesWhatIsNotAListOfCommands) {
  EXPECT_THAT(refusal(""), HasSubstr("must be a list"));
  EXPECT_THAT(refusal("at: 0\n"), HasSubstr("must be a list"));
  EXPECT_THAT(refusal("- {at: 0}\n- {at: 1"), HasSubstr("not YAML"));
  EXPECT_THAT([] { (void)load_schedule("/no/such/file.yaml"); },
              ::testing::ThrowsMessage<InvalidInput>(HasSubstr("No such file")));
  EXPECT_THAT([] { (void)load_schedule("/"); },
              ::testing::ThrowsMessage<InvalidInput>(HasSubstr("is a directory")));
}

TEST(Schedule, ListsAllMistakesAtOnce) {
  EXPECT_THAT(refusal("- {at: 0, spin: left}\n- {at: 1}\n- {at: 2, radius: 0}\n"),
              AllOf(HasSubstr(":1:"), HasSubstr(":3:")));
}

// A command holds from its time on, also where k · dt misses it by a rounding error.
TEST(Schedule, HoldsEachCommandFromItsTimeOn) {
  const Schedule schedule = {{0.0, Heading::straight(0.1)}, {0.3, Heading::straight(0.2)}};
  EXPECT_EQ(command_at(schedule, 0.0).heading, schedule[0].heading);
  EXPECT_EQ(command_at(schedule, 0.298).heading, schedule[0].heading);
  EXPECT_EQ(command_at(schedule, 0.1 * 3.0 - 1e-12).heading, schedule[1].heading);
  EXPECT_EQ(command_at(schedule, 99.0).heading, schedule[1].heading);
}

TEST(Schedule, HoldsTheFirstCommandBeforeItsTime) {
  EXPECT_EQ(command_at({{2.0, Heading::straight(0.1)}}, 0.0).heading, Heading::straight(0.1));
}

TEST(RandomSchedule, IsAPureFunctionOfItsArguments) {
  const Schedule a = random_schedule(3, 2.0, 100.0, 0.3), b = random_schedule(3, 2.0, 100.0, 0.3);
  const Schedule other = random_schedule(4, 2.0, 100.0, 0.3);
  ASSERT_EQ(a.size(), 50U);
  int same = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].heading, b[k].heading);
    same += a[k].heading == other[k].heading;
    EXPECT_DOUBLE_EQ(a[k].time, 2.0 * static_cast<double>(k));
  }
  EXPECT_LT(same, 10);  // two spins may agree
}

// A longer schedule begins with the shorter one: the time asked for decides nothing else.
TEST(RandomSchedule, OfALongerTimeBeginsTheSame) {
  const Schedule brief = random_schedule(5, 1.0, 10.0, 0.3),
                 longer = random_schedule(5, 1.0, 20.0, 0.3);
  for (std::size_t k = 0; k < brief.size(); ++k) EXPECT_EQ(brief[k].heading, longer[k].heading);
}

// Of 2000 commands 10 % are straight and 10 % spins, to within 4 σ = 4 √(2000 · 0.09) = 54; of the
// turns, half go left.
TEST(RandomSchedule, HasTheSharesItPromises) {
  int straight = 0, spins = 0, left = 0;
  for (const TimedCommand& command : random_schedule(1, 1.0, 2000.0, 0.3)) {
    const Heading& heading = command.heading;
    straight += heading.curvature() == 0.0;
    spins += heading.rho() == 0.0;
    left += heading.curvature() > 0.0;
    const bool turns = heading.rho() > 0.0;
    EXPECT_LE(turns ? std::abs(heading.curvature()) : 0.0, 1.0 / 0.3 + 1e-9);
  }
  EXPECT_NEAR(straight, 200, 54);
  EXPECT_NEAR(spins, 200, 54);
  EXPECT_NEAR(left, 900, 90);
}

TEST(ParseAngle, TakesRadiansAndDegrees) {
  EXPECT_DOUBLE_EQ(parse_angle("0.5"), 0.5);
  EXPECT_DOUBLE_EQ(parse_angle("-0.5rad"), -0.5);
  EXPECT_DOUBLE_EQ(parse_angle("90deg"), std::numbers::pi / 2.0);
}

TEST(ParseAngle, RefusesWhatIsNotAFiniteAngle) {
  for (const char* text : {"", "deg", "nan", "inf", "3turns", "1 deg", "1,5", "45", "1e300"})
    EXPECT_THROW((void)parse_angle(text), InvalidInput) << text;
}

TEST(ParseRadius, TakesMetresAndInfinity) {
  EXPECT_DOUBLE_EQ(parse_radius("1.5"), 1.5);
  EXPECT_DOUBLE_EQ(parse_radius("-0.2"), -0.2);
  EXPECT_DOUBLE_EQ(parse_radius("-80cm"), -0.8);
  EXPECT_EQ(parse_radius("inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_radius("-inf"), -std::numeric_limits<double>::infinity());
}

TEST(ParseRadius, RefusesZeroAndWhatIsNotANumber) {
  for (const char* text : {"", "0", "-0", "nan", "1deg", "one", "1e300"})
    EXPECT_THROW((void)parse_radius(text), InvalidInput) << text;
}

}  // namespace
}  // namespace hexagait::walk
