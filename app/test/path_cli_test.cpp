// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "cli_fixture.hpp"

// hexagait walk --path.
namespace hexagait::app {
namespace {

TEST_F(Cli, ListsPaths) {
  EXPECT_THAT(run("list paths").out, AllOf(HasSubstr("figure_eight"), HasSubstr("square")));
  const auto paths = nlohmann::json::parse(run("list paths --json").out);
  EXPECT_EQ(paths[0]["name"], "figure_eight");
}

TEST_F(Cli, RefusesPathsThatCannotBeWalked) {
  refuses("walk --path squre", {"--path", "'squre'", "did you mean 'square'?"});
  refuses("walk --path none.yaml", {"none.yaml"});
  const auto refuses_path = [&](const std::string& text, const std::vector<std::string>& words) {
    write("p.yaml", text);
    refuses("walk --path ../p.yaml", words);
  };
  refuses_path("points: [[0, 0", {"../p.yaml:"});
  refuses_path("points: 5\n", {"../p.yaml:1:9", "\"5\"", "a list"});
  refuses_path("points: [[0, 0]]\n", {"../p.yaml:1:", "1 point", "at least 2"});
  refuses_path("points:\n  - [0, 0]\n  - [nan, 0]\n", {"../p.yaml:3:", "'nan'"});
  refuses_path("points:\n  - [0, 0]\n  - [1, 2]\n  - [1, 2]\n",
               {"../p.yaml:4:", "(1, 2)", "differ"});
  refuses_path("points:\n  - [0, 0]\n  - [1, 0]\n  - [0, 0]\n",
               {"../p.yaml:3:", "180°", "stride", "149°"});
}

TEST_F(Cli, RefusesOptionsThatDoNotFitAPath) {
  refuses("walk --path square --facing alnog", {"--facing", "'alnog'", "did you mean 'along'?"});
  refuses("walk --path square --facing points", {"no point says where to face"});
  refuses("walk --path square --facing keep --crab 10deg", {"--crab", "keep"});
  refuses("walk --path square --localise gps", {"--localise is 'gps'", "odometry", "truth"});
  refuses("walk --path square --look-ahead 0", {"--look-ahead is '0'"});
  for (const char* laps : {"0", "1.5", "many", "-1"})
    refuses(std::string("walk --path square --laps ") + laps, {"--laps is", "from 1 to 1000"});
  for (const char* option : {"--facing along", "--localise truth", "--look-ahead 0.3", "--laps 2"})
    refuses(std::string("walk ") + option, {"makes no sense without --path"});
  for (const char* option : {"--radius 2", "--spin cw", "--distance 2", "--random-commands 5"})
    EXPECT_EQ(run(std::string("walk --path square ") + option).status, 2) << option;
  refuses("walk --robot genghis2d --path square", {"--path", "genghis2d"});
  write("open.yaml", "points: [[0, 0], [1, 0]]\n");
  refuses("walk --path ../open.yaml --laps 2", {"--laps is '2'", "not closed"});
}

// 30 cm, at the end of which it stands.
TEST_F(Cli, WalksAPathToItsEndAndSaysHow) {
  write("short.yaml", "points: [[0, 0], [30cm, 0]]\n");
  const Result result = run("walk --path ../short.yaml --localise truth --json --quiet");
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["heading"], "path");
  EXPECT_EQ(json["path_asked"]["localisation"], "truth");
  EXPECT_EQ(json["path_asked"]["facing"], "along");
  EXPECT_NEAR(json["path"]["length_m"].get<double>(), 0.3, 1e-9);
  EXPECT_LT(json["path"]["end_error_m"].get<double>(), 0.05);
  EXPECT_TRUE(json["arrived"].get<bool>());
  const Result late = run("walk --path ../short.yaml --seconds 0.5 --quiet");
  EXPECT_EQ(late.status, 1);
  EXPECT_THAT(late.out, HasSubstr("Did not arrive at the end of its path"));
}

}  // namespace
}  // namespace hexagait::app
