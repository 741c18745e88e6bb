// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "cli_fixture.hpp"

namespace hexagait::app {
namespace {

class Replay : public Cli {};

#ifdef HEXAGAIT_HAS_VIEWER
TEST_F(Replay, OfAWalkTellsWhatIsInIt) {
  const Result walk = run("walk --terrain boxes:4cm --seconds 2 --quiet --record w.replay");
  ASSERT_EQ(walk.status, 0) << walk.err;
  EXPECT_THAT(walk.out, HasSubstr("w.replay"));
  const Result replay = run("replay w.replay --json");
  ASSERT_EQ(replay.status, 0) << replay.err;
  const auto json = nlohmann::json::parse(replay.out);
  EXPECT_EQ(json["robot"], "argos");
  EXPECT_EQ(json["terrain"], "boxes:0.04");
  EXPECT_EQ(json["frames"], 100);
  EXPECT_NEAR(json["seconds"].get<double>(), 1.98, 1e-9);
  EXPECT_EQ(json["bytes"], fs::file_size(here() / "w.replay"));
}

TEST_F(Replay, OfTheSameWalkHasTheSameBytes) {
  for (const char* name : {"a", "b"})
    ASSERT_EQ(run(std::string("walk --seconds 1 --quiet --record ") + name + ".replay").status, 0);
  EXPECT_EQ(content(here() / "a.replay"), content(here() / "b.replay"));
}

TEST_F(Replay, OfAnActionTellsWhatIsInIt) {
  const Result result = run("run nod --quiet --record n.replay");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(run("replay n.replay --json").status, 0);
}

TEST_F(Replay, OfAWalkThatIsSteeredTellsWhatIsInIt) {
  const Result result = run("steer --headless --seconds 1 --terrain flat --record s.replay");
  ASSERT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(run("replay s.replay --json").out);
  EXPECT_GT(json["frames"].get<int>(), 10);
}

TEST_F(Replay, IsRefusedByAnExperimentWithoutAWalkToShow) {
  refuses("experiment table1 --record w.replay", {"--record: table1 has no walk", "fig9", "path"});
  refuses("experiment fig7_physics --record w.replay", {"fig7_physics"});
  refuses("experiment all --record w.replay", {"--record shows one walk", "not all"});
  refuses("experiment fig9 fig10 --record w.replay", {"--record shows one walk", "not several"});
  refuses("experiment fig9 --record w.txt", {"--record is 'w.txt'"});
}

TEST_F(Replay, RefusesWhatItCannotPlay) {
  ASSERT_EQ(run("walk --seconds 1 --quiet --record ../w.replay").status, 0);
  const std::string whole = content(here().parent_path() / "w.replay");
  write("cut.replay", whole.substr(0, whole.size() / 2));
  std::string other = whole;
  other[8] = 7;
  write("other.replay", other);
  write("trace.csv", "time_s,x_m\n0,0\n");
  refuses("replay ../cut.replay", {"'../cut.replay' is cut off"});
  refuses("replay ../other.replay", {"of version 7", "reads version 1"});
  refuses("replay ../trace.csv", {"'../trace.csv' is no replay", "--record"});
  refuses("replay ../nothing.replay", {"'../nothing.replay' can't be read", "No such file"});
  refuses("replay ..", {"'..' can't be read", "directory"});
  refuses("replay", {"file"});
}

TEST_F(Replay, RefusesFilesThatItCannotWrite) {
  refuses("walk --seconds 1 --record w.txt", {"--record is 'w.txt'", ".replay"});
  refuses("walk --seconds 1 --record no/w.replay", {"--record", "no/w.replay"});
  refuses("walk --robot genghis2d --record w.replay", {"--record", "genghis2d"});
  refuses("walk --seconds 1 --html w.htm", {"--html"});
}

// Without Node there is no page to write.
TEST_F(Replay, BecomesAPageOfOneFile) {
  const Result walk = run("walk --seconds 1 --quiet --record w.replay --html w.html");
  if (walk.status == 2 && walk.err.find("the page was not built") != std::string::npos)
    GTEST_SKIP() << walk.err;
  ASSERT_EQ(walk.status, 0) << walk.err;
  ASSERT_EQ(run("replay w.replay --html again.html").status, 0);
  ASSERT_EQ(run("experiment fig9 --short --quiet --html fig9.html").status, 0);
  EXPECT_TRUE(content(here() / "fig9.html").starts_with("<!doctype html>"));
  EXPECT_LT(fs::file_size(here() / "fig9.html"), 1000000U);
  EXPECT_EQ(content(here() / "w.html"), content(here() / "again.html"));
  EXPECT_TRUE(content(here() / "w.html").starts_with("<!doctype html>"));
}
#else
TEST_F(Replay, SaysWhatItLacks) {
  refuses("replay w.replay", {"libwebsockets-dev", "zlib1g-dev"});
  refuses("walk --record w.replay", {"--record", "zlib1g-dev"});
  refuses("walk --html w.html", {"--html", "zlib1g-dev"});
  refuses("experiment fig9 --html w.html", {"--html", "zlib1g-dev"});
}
#endif

}  // namespace
}  // namespace hexagait::app
