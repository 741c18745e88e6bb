// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli_fixture.hpp"

// Every experiment in its short form, once: every claim that it can judge, and its replay.
namespace hexagait::app {
namespace {

constexpr const char* kNames[] = {
    "table1",     "table2",       "fig3",      "fig4",        "fig6",    "fig7a",
    "fig7b",      "fig7_physics", "fig9",      "fig10",       "fig11",   "fig12",
    "navigation", "wave_family",  "fg16_fig6", "fg16_fig7",   "walks",   "rates",
    "path",       "rough",        "lead",      "sensitivity", "gallery", "random_robots"};

class ShortExperiment : public Cli {
 protected:
  nlohmann::json list() { return nlohmann::json::parse(run("list experiments --json").out); }
};

TEST_F(ShortExperiment, IsMadeHereOfEachThatThereIs) {
  std::vector<std::string> names;
  int shown = 0;
  for (const auto& experiment : list()) {
    names.push_back(experiment["name"]);
    shown += experiment["shows"] != "" ? 1 : 0;
  }
  EXPECT_THAT(names, ::testing::ElementsAreArray(kNames));
  EXPECT_EQ(shown, 16);
}

// As `all` does for all of them.
TEST_F(ShortExperiment, StandsOnOnePageWithOthers) {
  refuses("experiment fig99 all", {"fig99"});
  const Result result = run("experiment fig6 table1 --short --quiet");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(content(here() / "results/index.html"),
              AllOf(HasSubstr("<section id=\"fig6\">"), HasSubstr("<section id=\"table1\">")));
}

class AnyShortExperiment : public ShortExperiment,
                           public ::testing::WithParamInterface<const char*> {};

TEST_P(AnyShortExperiment, HoldsItsClaims) {
  const std::string name = GetParam();
  std::string record, shows;
#ifdef HEXAGAIT_HAS_VIEWER
  const auto all = list();
  const auto one = std::ranges::find_if(all, [&](const auto& e) { return e["name"] == name; });
  ASSERT_NE(one, all.end());
  shows = (*one)["shows"];
  if (!shows.empty()) record = " --record w.replay";
#endif
  const Result result = run("experiment " + name + " --short --quiet" + record);
  ASSERT_EQ(result.status, 0) << result.out << result.err;
  if (record.empty()) return;

  // A walk that an experiment has to show is one walk, from its beginning.
  EXPECT_THAT(result.out, HasSubstr(shows));
  const auto replay = nlohmann::json::parse(run("replay w.replay --json").out);
  EXPECT_EQ(replay["scenes"], 1);
  EXPECT_GT(replay["seconds"].get<double>(), 3.0);
  if (name == "fig10") {
    EXPECT_EQ(replay["terrain"], "boxes:0.15");
    EXPECT_NEAR(replay["seconds"].get<double>(), 10.0, 0.1);
  }
  if (name == "fig12") {
    EXPECT_EQ(replay["robot"], "lauron");
  }
}
INSTANTIATE_TEST_SUITE_P(All, AnyShortExperiment, ::testing::ValuesIn(kNames),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace hexagait::app
