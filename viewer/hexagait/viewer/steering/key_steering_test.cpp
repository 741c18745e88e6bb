// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <hexagait/viewer/steering/command.hpp>
#include <hexagait/viewer/steering/key_steering.hpp>
#include <iterator>
#include <numbers>
#include <testing/source_path.hpp>

namespace hexagait::viewer {
namespace {

using heading_control::Heading;

std::vector<Key> keys_of(std::string_view bytes) {
  KeyDecoder decoder;
  std::vector<Key> keys;
  for (const char byte : bytes)
    if (const auto key = decoder.take(byte)) keys.push_back(*key);
  return keys;
}

// What the keys ask for in the end.
Command last_of(const std::vector<Key>& keys, const Heading& heading = Heading::straight(0.0)) {
  KeySteering steering(heading);
  std::string message;
  for (const Key key : keys) message = steering.message(key);
  const auto command = parse_command(message);
  if (const auto* error = std::get_if<CommandError>(&command)) ADD_FAILURE() << error->what;
  return std::get<Command>(command);
}

Heading heading_of(const std::vector<Key>& keys, const Heading& first = Heading::straight(0.0)) {
  return std::get<Drive>(last_of(keys, first)).heading;
}

TEST(KeyDecoder, ReadsLettersOfBothCases) {
  EXPECT_EQ(keys_of("wS aD"),
            (std::vector{Key::ahead, Key::backwards, Key::pause, Key::left, Key::right}));
  EXPECT_EQ(keys_of("\x7f\b"), (std::vector{Key::reset, Key::reset}));
}

// The letters that end a terminal's sequences are keys of their own elsewhere.
TEST(KeyDecoder, TakesNoArrowForALetter) {
  EXPECT_EQ(keys_of("\x1b[C\x1b[A\x1bOC"), (std::vector{Key::tick, Key::go, Key::tick}));
  EXPECT_EQ(keys_of("\x1b[D\x1b[B\x1b[3~\x1b[1;5Dx"), std::vector{Key::stop});
  EXPECT_EQ(keys_of("\x1bwx"), (std::vector{Key::emergency_stop, Key::stop}));
  EXPECT_EQ(keys_of("\xc3\xa4\n\t?x"), std::vector{Key::stop});
}

TEST(KeyDecoder, ForgetsAnEscapeThatNothingFollows) {
  KeyDecoder decoder;
  EXPECT_FALSE(decoder.take('\x1b'));
  EXPECT_EQ(decoder.rest(), Key::emergency_stop);
  EXPECT_FALSE(decoder.rest());
  EXPECT_EQ(decoder.take('w'), Key::ahead);
}

TEST(KeySteering, BendsThePathInNotchesThatAreFineAboutTheMiddle) {
  EXPECT_NEAR(heading_of({Key::left}).curvature(), 2.0 * 12 * 12 / (150.0 * 150.0), 1e-9);
  EXPECT_NEAR(heading_of({Key::right}).curvature(), -2.0 * 12 * 12 / (150.0 * 150.0), 1e-9);
  EXPECT_NEAR(heading_of(std::vector(3, Key::left)).curvature(), 2.0 * 36 * 36 / 22500.0, 1e-9);
  EXPECT_DOUBLE_EQ(heading_of({Key::left, Key::left, Key::right, Key::right}).curvature(), 0.0);
  EXPECT_NEAR(heading_of(std::vector(40, Key::left)).curvature(), 2.0, 1e-9) << "at the stop";
}

TEST(KeySteering, TurnsTheCrabAngleInStepsOf15Degrees) {
  constexpr double kStep = std::numbers::pi / 12.0;
  EXPECT_NEAR(heading_of({Key::crab_left}).crab_angle(), kStep, 1e-9);
  EXPECT_NEAR(heading_of({Key::crab_right, Key::crab_right}).crab_angle(), -2.0 * kStep, 1e-9);
  EXPECT_NEAR(heading_of({Key::crab_left}, Heading::straight(0.1)).crab_angle(), kStep, 1e-9)
      << "to the next step of the dial";
  EXPECT_NEAR(heading_of({Key::backwards, Key::crab_left}).crab_angle(), -11.0 * kStep, 1e-9);
  EXPECT_NEAR(heading_of({Key::crab_left, Key::ahead}).crab_angle(), 0.0, 1e-9);
}

TEST(KeySteering, BeginsWithTheHeadingOfTheWalkAndComesBackToItByReset) {
  const Heading arc = Heading::arc(3.0, 0.5);
  EXPECT_EQ(heading_of({Key::go}, arc),
            heading_of({Key::left, Key::crab_left, Key::reset, Key::go}, arc));
  EXPECT_NEAR(heading_of({Key::go}, arc).radius(), 3.0, 1e-9);
  EXPECT_NEAR(heading_of({Key::go}, Heading::spin(heading_control::Turn::cw)).curvature(), -2.0,
              1e-9);
}

TEST(KeySteering, KeepsThePathThroughAStop) {
  EXPECT_TRUE(std::holds_alternative<Stop>(last_of({Key::left, Key::stop})));
  EXPECT_EQ(heading_of({Key::left, Key::stop, Key::go}), heading_of({Key::left}));
}

TEST(KeySteering, PausesAndGoesOn) {
  EXPECT_TRUE(std::get<Pause>(last_of({Key::pause})).on);
  EXPECT_FALSE(std::get<Pause>(last_of({Key::pause, Key::pause})).on);
  EXPECT_FALSE(std::get<Pause>(last_of({Key::tick, Key::pause})).on) << "a tick pauses";
  EXPECT_TRUE(std::get<Pause>(last_of({Key::pause, Key::reset, Key::pause})).on);
  EXPECT_EQ(std::get<SingleStep>(last_of({Key::tick})).ticks, 1);
}

TEST(KeySteering, AsksForTheRest) {
  EXPECT_TRUE(std::holds_alternative<Push>(last_of({Key::push})));
  EXPECT_TRUE(std::holds_alternative<Scramble>(last_of({Key::scramble})));
  EXPECT_TRUE(std::holds_alternative<Reset>(last_of({Key::reset})));
}

// The wheel of the page and the keys of the terminal have the same notches.
TEST(KeySteering, HasTheWheelOfThePage) {
  std::ifstream file(hexagait::testing::source_path("viewer/page/src/steering.js"));
  const std::string script{std::istreambuf_iterator<char>(file), {}};
  for (const char* line :
       {"kMostCurvature = 2;", "kStop = 150;", "- 12 * way", "/ 15) * 15 + 15 * way"})
    EXPECT_THAT(script, ::testing::HasSubstr(line));
}

}  // namespace
}  // namespace hexagait::viewer
