// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/viewer/steering/command.hpp>

namespace hexagait::viewer {
namespace {

using ::testing::HasSubstr;

template <class Kind>
Kind parsed(std::string_view text) {
  auto result = parse_command(text);
  if (const auto* error = std::get_if<CommandError>(&result)) ADD_FAILURE() << error->what;
  return std::get<Kind>(std::get<Command>(result));
}

std::string error_of(std::string_view text) {
  const auto result = parse_command(text);
  const auto* error = std::get_if<CommandError>(&result);
  return error != nullptr ? error->what : "accepted";
}

// r = 1 / curvature; the sign says left or right.
TEST(Command, DrivesByRadiusOrCurvature) {
  const auto left = parsed<Drive>(R"({"type":"drive","radius":2.5,"crab":0.3})");
  EXPECT_NEAR(left.heading.radius(), 2.5, 1e-12);
  EXPECT_NEAR(left.heading.crab_angle(), 0.3, 1e-12);
  EXPECT_TRUE(left.heading.moving());
  EXPECT_EQ(left.limit, kNoLimit);
  const auto right = parsed<Drive>(R"({"type":"drive","curvature":-0.5,"limit":0.1})");
  EXPECT_NEAR(right.heading.radius(), -2.0, 1e-12);
  EXPECT_EQ(right.limit, 0.1);
  EXPECT_EQ(parsed<Drive>(R"({"type":"drive","curvature":0})").heading.curvature(), 0.0);
}

TEST(Command, SpinsInBothSenses) {
  using heading_control::Turn;
  EXPECT_EQ(parsed<Drive>(R"({"type":"spin","turn":"ccw"})").heading.turn(), Turn::ccw);
  EXPECT_EQ(parsed<Drive>(R"({"type":"spin","turn":"cw"})").heading.turn(), Turn::cw);
  EXPECT_EQ(parsed<Drive>(R"({"type":"spin","turn":"cw"})").heading.radius(), 0.0);
}

TEST(Command, ReadsEveryType) {
  EXPECT_EQ(parsed<DriveTwist>(R"({"type":"twist","vx":0.1,"vy":-0.2,"wz":0.3})").twist.w, 0.3);
  parsed<Stop>(R"({"type":"stop"})");
  EXPECT_FALSE(parsed<Pause>(R"({"type":"pause","on":false})").on);
  EXPECT_EQ(parsed<SingleStep>(R"({"type":"step","ticks":7})").ticks, 7);
  EXPECT_EQ(parsed<SpeedFactor>(R"({"type":"speed","factor":0.25})").factor, 0.25);
  parsed<Scramble>(R"({"type":"scramble"})");
  EXPECT_EQ(parsed<Push>(R"({"type":"push","angle":1.5})").angle, 1.5);
  const auto gait = parsed<ChangeGait>(R"({"type":"gait","gait":"wave:0.75"})");
  EXPECT_EQ(gait.stepper.stepping, gait_state::Stepping::wave);
  EXPECT_EQ(gait.stepper.duty_factor, 0.75);
  EXPECT_TRUE(parsed<Race>(R"({"type":"race","on":true,"gait":"clocked"})").rival->open_loop);
  EXPECT_FALSE(parsed<Race>(R"({"type":"race","on":false})").rival);
  const auto fault = parsed<Break>(R"({"type":"fault","fault":"weak:LF_knee:50%"})");
  EXPECT_EQ(fault.fault.kind, walk::PartFaultKind::weak);
  EXPECT_EQ(fault.fault.value, 0.5);
  parsed<Mend>(R"({"type":"mend"})");
  EXPECT_EQ(parsed<ChangePlant>(R"({"type":"plant","plant":"real"})").preset->name, "real");
  parsed<Reset>(R"({"type":"reset"})");
  const auto restart = parsed<Restart>(R"({"type":"restart","terrain":"steps:8cm","seed":3})");
  EXPECT_EQ(restart.terrain->roughness(), 0.08);
  EXPECT_EQ(restart.seed, 3U);
  EXPECT_FALSE(restart.robot);
  parsed<Beat>(R"({"type":"beat"})");
  parsed<Release>(R"({"type":"release"})");
  parsed<EmergencyStop>(R"({"type":"estop"})");
  parsed<ReleaseEmergencyStop>(R"({"type":"release_estop"})");
}

TEST(Command, RefusesWhatIsNoMessage) {
  EXPECT_THAT(error_of(""), HasSubstr("not JSON"));
  EXPECT_THAT(error_of("{"), HasSubstr("not JSON"));
  EXPECT_THAT(error_of("[1]"), HasSubstr("not a JSON object"));
  EXPECT_THAT(error_of("{}"), HasSubstr("needs a \"type\""));
  EXPECT_THAT(error_of(R"({"type":7})"), HasSubstr("needs a \"type\""));
  EXPECT_THAT(error_of(R"({"type":"fly"})"), HasSubstr("no \"fly\""));
}

TEST(Command, RefusesWhatIsTooLong) {
  std::string text = R"({"type":"stop"})";
  text.append(kMaxMessage - text.size(), ' ');
  EXPECT_EQ(error_of(text), "accepted");
  EXPECT_THAT(error_of(text + " "), HasSubstr("more than 4096 bytes"));
}

// Overlong, a lone continuation, a surrogate, above U+10FFFF, cut off; and a text that is right.
TEST(Command, RefusesWhatIsNotUtf8) {
  for (const char* const bytes :
       {"\xC0\xAF", "\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\xFF"})
    EXPECT_THAT(error_of(std::string(R"({"type":")") + bytes + "\"}"), HasSubstr("not UTF-8"));
  EXPECT_THAT(error_of("{\"type\":\"\xE2\x9F\xB2\"}"), HasSubstr("to ask for"));
}

TEST(Command, RefusesNumbersThatAreNone) {
  for (const char* const number :
       {"NaN", "nan", "Infinity", "-Infinity", "1e999", "0x10", "1.", "+1"})
    EXPECT_THAT(error_of(std::string(R"({"type":"drive","radius":)") + number + "}"),
                HasSubstr("not JSON"))
        << number;
  for (const char* const value : {"\"2\"", "null", "true", "[2]", "{}"})
    EXPECT_THAT(error_of(std::string(R"({"type":"drive","radius":)") + value + "}"),
                HasSubstr("must be a number"));
}

TEST(Command, RefusesWhatIsOutOfRange) {
  EXPECT_THAT(error_of(R"({"type":"drive","radius":0})"), HasSubstr("at least 1 mm"));
  EXPECT_THAT(error_of(R"({"type":"drive","radius":1e7})"), HasSubstr("from -1e+06 to 1e+06"));
  EXPECT_THAT(error_of(R"({"type":"drive","curvature":0,"crab":7})"), HasSubstr("\"crab\""));
  EXPECT_THAT(error_of(R"({"type":"drive","curvature":0,"limit":-1})"), HasSubstr("\"limit\""));
  EXPECT_THAT(error_of(R"({"type":"twist","vx":11,"vy":0,"wz":0})"), HasSubstr("\"vx\""));
  EXPECT_THAT(error_of(R"({"type":"step","ticks":0})"), HasSubstr("from 1 to 500"));
  EXPECT_THAT(error_of(R"({"type":"step","ticks":1.5})"), HasSubstr("whole number"));
  EXPECT_THAT(error_of(R"({"type":"step","ticks":-1})"), HasSubstr("whole number"));
  EXPECT_THAT(error_of(R"({"type":"speed","factor":100})"), HasSubstr("from 0.05 to 10"));
  EXPECT_THAT(error_of(R"({"type":"gait","gait":"wave:1"})"), HasSubstr("from 0.5 to less than 1"));
  EXPECT_THAT(error_of(R"({"type":"gait","gait":"unadjusted"})"), HasSubstr("free, tripod"));
  EXPECT_THAT(error_of(R"({"type":"restart","terrain":"boxes:2"})"), HasSubstr("at most 0.5 m"));
  EXPECT_THAT(error_of(R"({"type":"restart","terrain":"/etc/passwd"})"), HasSubstr("unknown kind"));
  EXPECT_THAT(error_of(R"({"type":"restart","terrain":"heightmap:0.1,1m,/etc/passwd"})"),
              HasSubstr("must not name a file"));
  EXPECT_THAT(error_of(R"({"type":"restart","terrain":"boxes:5cm+heightmap:0.1,1m,a.png"})"),
              HasSubstr("must not name a file"));
  EXPECT_THAT(error_of(R"({"type":"gait","gait":"clocked"})"), HasSubstr("free, tripod"));
  EXPECT_THAT(error_of(R"({"type":"race","on":true,"gait":"gallop"})"), HasSubstr("free, unadj"));
  EXPECT_THAT(error_of(R"({"type":"race","on":true})"), HasSubstr("it is missing"));
  EXPECT_THAT(error_of(R"({"type":"race","on":false,"gait":"free"})"), HasSubstr("no \"gait\""));
  EXPECT_THAT(error_of(R"({"type":"restart","seed":-1})"), HasSubstr("whole number"));
}

TEST(Command, ReadsPaths) {
  const auto drawn = parsed<Follow>(
      R"({"type":"follow","points":[[0,0],[1.5,-2],[3,0]],"closed":true,"limit":0.1})");
  ASSERT_EQ(drawn.points_W.size(), 3U);
  EXPECT_EQ(drawn.points_W[1], Vector2(1.5, -2.0));
  EXPECT_TRUE(drawn.closed);
  EXPECT_EQ(drawn.limit, 0.1);
  const auto named = parsed<Follow>(R"({"type":"follow","path":"square"})");
  EXPECT_EQ(named.name, "square");
  EXPECT_TRUE(named.points_W.empty());
}

TEST(Command, RefusesPathsThatAreNone) {
  const auto error = [](const std::string& points) {
    return error_of(R"({"type":"follow","points":)" + points + "}");
  };
  EXPECT_THAT(error("[[0,0]]"), HasSubstr("2 to 100 points"));
  std::string many = "[[0,0]";
  for (int k = 1; k <= 100; ++k) many += fmt::format(",[{},0]", k);
  EXPECT_THAT(error(many + "]"), HasSubstr("2 to 100 points"));
  EXPECT_THAT(error("7"), HasSubstr("2 to 100 points"));
  for (const char* const bad : {"[0,0,0]", "[0]", "0", "[0,\"1\"]", "[0,null]", "[2e5,0]", "{}"})
    EXPECT_THAT(error(fmt::format("[[0,0],{}]", bad)), HasSubstr("each must be [x, y]")) << bad;
  EXPECT_THAT(error("[[0,0],[NaN,0]]"), HasSubstr("not JSON"));
  EXPECT_THAT(error_of(R"({"type":"follow"})"), HasSubstr("one of \"points\" and \"path\""));
  EXPECT_THAT(error_of(R"({"type":"follow","path":"square","closed":true})"),
              HasSubstr("no \"closed\""));
  EXPECT_THAT(error_of(R"({"type":"follow","path":""})"), HasSubstr("must not be empty"));
}

TEST(Command, ReadsActions) {
  const auto named = parsed<Perform>(R"({"type":"action","action":"wave"})");
  EXPECT_EQ(named.name, "wave");
  EXPECT_TRUE(named.yaml.empty());
  const auto own = parsed<Perform>(R"({"type":"action","yaml":"steps:\n- …","name":"my.yaml"})");
  EXPECT_EQ(own.name, "my.yaml");
  EXPECT_EQ(own.yaml, "steps:\n- …");
  EXPECT_TRUE(is_motion(Command(own)));
}

// One byte more than the longest; and of the longest kind of message.
TEST(Command, RefusesActionsThatAreNone) {
  const auto own = [](std::size_t length, char letter = 'x') {
    return R"({"type":"action","name":"a","yaml":")" + std::string(length, letter) + "\"}";
  };
  EXPECT_EQ(parsed<Perform>(own(kMaxAction)).yaml.size(), kMaxAction);
  EXPECT_THAT(error_of(own(kMaxAction + 1)), HasSubstr("a text of 1 to 65536 bytes"));
  EXPECT_THAT(error_of(own(kMaxActionMessage)), HasSubstr("more than 135168 bytes"));
  EXPECT_THAT(error_of(own(0)), HasSubstr("a text of 1 to 65536 bytes"));
  EXPECT_THAT(error_of(own(20000, '\xFF')), HasSubstr("not UTF-8"));
  EXPECT_THAT(error_of(fmt::format(" {}", own(20000))), HasSubstr("more than 4096 bytes"));
  EXPECT_THAT(error_of(R"({"type":"action"})"), HasSubstr("one of \"action\" and \"yaml\""));
  EXPECT_THAT(error_of(R"({"type":"action","action":"a","yaml":"b"})"), HasSubstr("one of"));
  EXPECT_THAT(error_of(R"({"type":"action","action":""})"), HasSubstr("must not be empty"));
  EXPECT_THAT(error_of(R"({"type":"action","action":"a","name":"b"})"), HasSubstr("no \"name\""));
  EXPECT_THAT(error_of(R"({"type":"action","yaml":"b"})"), HasSubstr("\"name\" of \"action\": it"));
  EXPECT_THAT(error_of(R"({"type":"action","yaml":7,"name":"b"})"), HasSubstr("a text of 1 to"));
  EXPECT_THAT(error_of(R"({"type":"action","action":7})"), HasSubstr("a text of at most"));
}

TEST(Command, RefusesFaultsThatAreNone) {
  const auto error = [](const std::string& fault) {
    return error_of(R"({"type":"fault","fault":")" + fault + "\"}");
  };
  EXPECT_THAT(error("ded:LF"), HasSubstr("did you mean 'dead'?"));
  EXPECT_THAT(error("weak:LF_knee:150%"), HasSubstr("a share from 0 to 1"));
  EXPECT_THAT(error("weak:LF_knee:nan"), HasSubstr("a share from 0 to 1"));
  EXPECT_THAT(error("contact_late:LF:1h"), HasSubstr("from 0 to 1 s"));
  EXPECT_THAT(error("load:1e9kg:0:0"), HasSubstr("a mass from 0 to"));
  EXPECT_THAT(error("load:1kg:inf:0"), HasSubstr("'inf'"));
  EXPECT_THAT(error("push:5Ns:1e999"), HasSubstr("1e999"));
  EXPECT_THAT(error("dead:LF@5s"), HasSubstr("leave out the @"));
  EXPECT_THAT(error(fmt::format("dead:{:L>80}", "F")), HasSubstr("at most 64 letters"));
  EXPECT_THAT(error_of(R"({"type":"fault"})"), HasSubstr("it is missing"));
  EXPECT_THAT(error_of(R"({"type":"fault","fault":"dead:LF","leg":1})"), HasSubstr("no \"leg\""));
  EXPECT_THAT(error_of(R"({"type":"plant","plant":"rael"})"), HasSubstr("ideal or real"));
  EXPECT_THAT(error_of(R"({"type":"plant","plant":"real+friction:0.1"})"),
              HasSubstr("ideal or real"));
}

TEST(Command, RefusesKeysThatAreMissingOrUnknown) {
  EXPECT_THAT(error_of(R"({"type":"drive"})"), HasSubstr("one of \"radius\" and \"curvature\""));
  EXPECT_THAT(error_of(R"({"type":"drive","radius":1,"curvature":1})"), HasSubstr("one of"));
  EXPECT_THAT(error_of(R"({"type":"drive","radius":1,"carb":1})"), HasSubstr("no \"carb\""));
  EXPECT_THAT(error_of(R"({"type":"stop","now":true})"), HasSubstr("no \"now\""));
  EXPECT_THAT(error_of(R"({"type":"twist","vx":0,"vy":0})"), HasSubstr("it is missing"));
}

}  // namespace
}  // namespace hexagait::viewer
