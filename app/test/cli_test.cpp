// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli_fixture.hpp"

// The command as a user meets it: its exit status, what it prints where, what it leaves behind.
namespace hexagait::app {
namespace {

TEST_F(Cli, HelpsWithExamples) {
  for (const char* command : {"walk", "robot", "list", "terrains", "experiment", "verify"}) {
    const Result result = run(std::string(command) + " --help");
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.out, AllOf(HasSubstr("Example"), HasSubstr("hexagait "))) << command;
    EXPECT_THAT(result.err, IsEmpty());
  }
  EXPECT_THAT(run("--version").out, HasSubstr("hexagait 0."));
  EXPECT_THAT(run("experiment --list").out,
              AllOf(HasSubstr("table1"), HasSubstr("fig7b"), HasSubstr("fig9"), HasSubstr("fig10"),
                    HasSubstr("fg16_fig6"), HasSubstr("fg16_fig7")));
  EXPECT_THAT(run("terrains").out,
              AllOf(HasSubstr("flat"), HasSubstr("boxes:H"), HasSubstr("rough:H")));
}

TEST_F(Cli, PrintsOneJsonObjectWithEveryResult) {
  const Result result = run("walk --seconds 2 --radius 3 --json --quiet");
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, IsEmpty());
  const auto json = nlohmann::json::parse(result.out);
  for (const char* key : {"robot",
                          "terrain",
                          "seed",
                          "heading",
                          "curvature_per_m",
                          "seconds",
                          "distance_m",
                          "turned_rad",
                          "speed_m_s",
                          "lateral_error_m",
                          "heading_error_rad",
                          "odometry_error",
                          "slip_m",
                          "stances",
                          "stability_margin_m",
                          "roll_rad",
                          "pitch_rad",
                          "body_height_m",
                          "steps",
                          "tripod_after_steps",
                          "rule1_violations",
                          "neighbour_flight_s",
                          "leg_touch_s",
                          "contact_losses",
                          "fell",
                          "fell_because",
                          "stuck",
                          "arrived",
                          "fault",
                          "real_time_factor",
                          "tick_ns",
                          "state_hash"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_NEAR(json["curvature_per_m"].get<double>(), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(json["seconds"].get<double>(), 2.0, 1e-9);
  EXPECT_EQ(json["state_hash"].get<std::string>().size(), 16U);
  EXPECT_EQ(json["fell"], false);
  EXPECT_EQ(json["fault"], "none");
}

TEST_F(Cli, TellsTheGaitAndTheCommandsInJson) {
  const auto json_of = [&](const std::string& arguments) {
    return nlohmann::json::parse(run("walk --seconds 0.2 --json " + arguments).out);
  };
  EXPECT_EQ(json_of("")["gait"], "free");
  EXPECT_EQ(json_of("--gait tripod")["gait"], "tripod");
  EXPECT_EQ(json_of("--duty-factor 0.75")["gait"], "wave:0.75");
  write("beta.yaml", "- {at: 0, radius: 2}\n- {at: 0.1, duty_factor: 0.75}\n");
  const auto json = json_of("--gait unadjusted --commands ../beta.yaml");
  EXPECT_EQ(json["gait"], "unadjusted");
  EXPECT_TRUE(json["commands"][0]["duty_factor"].is_null());
  EXPECT_EQ(json["commands"][1]["duty_factor"], 0.75);
  EXPECT_EQ(json["commands"][1]["curvature_per_m"], 0.5);
}

// A preset, and options that override it, for walks and actions alike.
TEST_F(Cli, WalksWithAnImperfectPlantAndTellsIt) {
  const auto plant = [this](const std::string& command) {
    return nlohmann::json::parse(run(command + " --json --quiet").out)["plant"];
  };
  const std::string walk = "walk --seconds 0.5";
  EXPECT_EQ(plant(walk)["name"], "ideal");
  EXPECT_EQ(plant(walk)["friction"], 0.9);
  const auto real = plant(walk + " --plant real --friction 0.4 --joint-noise 1mrad");
  EXPECT_EQ(real["name"], "real+friction:0.4+joint_noise:1mrad");
  EXPECT_EQ(real["friction"], 0.4);
  EXPECT_EQ(real["joint_noise_rad"], 0.001);
  EXPECT_EQ(real["mass_error"], 0.1);
  EXPECT_EQ(real["contact_bounce_s"], 0.004);
  EXPECT_EQ(plant(walk + " --servo position-only")["positions_only"], true);
  EXPECT_EQ(plant(walk)["velocity_limits"], true);
  EXPECT_EQ(plant(walk + " --velocity-limits off")["velocity_limits"], false);
  EXPECT_EQ(plant("run nod --plant real")["name"], "real");
  const auto hash = [this](const std::string& command) {
    return nlohmann::json::parse(run(command + " --json --quiet").out)["state_hash"];
  };
  EXPECT_EQ(hash(walk + " --plant real"), hash(walk + " --plant real"));
  EXPECT_NE(hash(walk + " --plant real"), hash(walk));
  EXPECT_NE(hash("run nod --plant real"), hash("run nod"));
  EXPECT_THAT(run("list plants").out,
              AllOf(HasSubstr("real"), HasSubstr("joint_noise"), HasSubstr("12bit")));
}

TEST_F(Cli, WalksAWaveGaitOnRequest) {
  EXPECT_EQ(
      nlohmann::json::parse(run("walk --seconds 3 --gait wave:0.6 --json").out)["state_hash"],
      nlohmann::json::parse(run("walk --seconds 3 --duty-factor 0.6 --json").out)["state_hash"]);
  EXPECT_THAT(run("walk --help").out, AllOf(HasSubstr("--duty-factor"), HasSubstr("--gait")));
}

// JSON has no infinity: a turn in place has no curvature to tell.
TEST_F(Cli, PrintsAnInfiniteCurvatureAsNull) {
  const auto json = nlohmann::json::parse(run("walk --seconds 1 --spin cw --json").out);
  EXPECT_EQ(json["heading"], "spin cw");
  EXPECT_TRUE(json["curvature_per_m"].is_null());
}

TEST_F(Cli, HasTheSameBitsInEveryProcess) {
  const std::string arguments =
      "walk --seconds 3 --terrain boxes:0.05 --random-posture 0.05 --seed 4 --json";
  const auto a = nlohmann::json::parse(run(arguments).out);
  const auto b = nlohmann::json::parse(run(arguments).out);
  EXPECT_EQ(a["state_hash"], b["state_hash"]);
  EXPECT_EQ(a["distance_m"], b["distance_m"]);
}

TEST_F(Cli, SaysInASentenceHowItWent) {
  const Result result = run("walk --seconds 2 --radius 3");
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("of a left-hand arc (r = 3 m) on flat ground in 2 s"),
                                HasSubstr("off the commanded path")));
}

TEST_F(Cli, WalksWithParametersThatAreSetAndNoFasterThanAsked) {
  const auto speed = [this](const std::string& options) {
    return nlohmann::json::parse(run("walk --seconds 5 --json " + options).out)["speed_m_s"]
        .get<double>();
  };
  const double usual = speed("");
  EXPECT_LT(speed("--set step.stroke=10cm"), 0.7 * usual);
  EXPECT_LT(speed("--speed 0.1"), 0.1);
  EXPECT_GT(speed("--speed 0.1"), 0.07);
  EXPECT_EQ(speed("--speed 10"), usual);
}

TEST_F(Cli, ListsTheParametersOfARobotAndWhereTheyComeFrom) {
  EXPECT_THAT(run("robot argos").out, AllOf(HasSubstr("step.stroke"), HasSubstr("0.91 ℓ")));
}

TEST_F(Cli, RunsAnActionOnAnotherRobotOrSaysInALineWhyNot) {
  EXPECT_EQ(run("run nod --robot spider --json").status, 0);
  const Result octopod = run("run nod --robot octopod");
  EXPECT_EQ(octopod.status, 2);
  EXPECT_THAT(octopod.err, HasSubstr("nod is for robots of 6 legs, such as argos; octopod has 8"));
}

TEST_F(Cli, ArrivesAtTheDistanceAskedFor) {
  const auto json = nlohmann::json::parse(run("walk --distance 0.3 --json").out);
  EXPECT_EQ(json["arrived"], true);
  EXPECT_NEAR(json["distance_m"].get<double>(), 0.3, 0.002);
}

// A row per tick of 2 ms, and as many fields in each as in the header.
TEST_F(Cli, WritesATraceWithARowPerTick) {
  EXPECT_EQ(run("walk --seconds 0.5 --trace walk.csv").status, 0);
  std::istringstream trace(content(here() / "walk.csv"));
  std::string line;
  std::getline(trace, line);
  EXPECT_THAT(line, AllOf(HasSubstr("time_s"), HasSubstr("LF_normal_force_n")));
  const auto commas = std::count(line.begin(), line.end(), ',');
  int rows = 0;
  for (; std::getline(trace, line); ++rows)
    ASSERT_EQ(std::count(line.begin(), line.end(), ','), commas);
  EXPECT_EQ(rows, 250);
  EXPECT_EQ(std::distance(fs::directory_iterator(here()), fs::directory_iterator()), 1);
}

TEST_F(Cli, DrawsAFigureAndKeepsWhatItIsMadeOf) {
  EXPECT_EQ(run("walk --seconds 2 --plot \"it's.svg\"").status, 0);
  for (const char* name :
       {"it's.svg", "it's.gp", "it's-body.csv", "it's-steps.csv", "it's-gait.csv"})
    EXPECT_GT(fs::file_size(here() / name), 50U) << name;
  EXPECT_THAT(content(here() / "it's.svg"), HasSubstr("Path from above"));
}

// The trace would have the name of one of the figure's tables.
TEST_F(Cli, RefusesOutputsThatWouldOverwriteEachOther) {
  refuses("walk --seconds 2 --plot w.png --trace w-body.csv", {"--plot", "--trace", "w-body.csv"});
  refuses("walk --seconds 2 --plot w-movie.png --movie w.gif", {"--plot", "--movie", "w-movie.gp"});
  EXPECT_TRUE(fs::is_empty(here()));
}

TEST_F(Cli, NamesEveryFileThatItWrites) {
  const Result result = run("walk --robot genghis2d --seconds 2 --plot w.svg --trace t.csv --json");
  std::set<std::string> named, written;
  const auto json = nlohmann::json::parse(result.out);
  for (const auto& file : json["files"]) named.insert(file);
  for (const auto& entry : fs::directory_iterator(here())) written.insert(entry.path().filename());
  EXPECT_EQ(named, written);
  EXPECT_THAT(run("walk --robot genghis2d --seconds 2 --plot w.svg").out, HasSubstr("w-body.csv"));
}

// It begins as a GIF does, and has a frame every 80 ms.
TEST_F(Cli, MakesAMovingPicture) {
  EXPECT_EQ(run("walk --robot genghis2d --seconds 2 --movie w.gif").status, 0);
  const std::string gif = content(here() / "w.gif");
  EXPECT_TRUE(gif.starts_with("GIF89a"));
  const std::string frame = {'\x21', '\xf9', '\x04'};  // the header of a frame's control block
  int frames = 0;
  for (std::size_t at = 0; (at = gif.find(frame, at)) != std::string::npos; ++at) ++frames;
  EXPECT_NEAR(frames, 25, 1);
  EXPECT_LT(gif.size(), 2'000'000U);
}

// The claims of figure 7-A hold, but for one that fails as it was declared to: that fails no run.
TEST_F(Cli, MakesAFigureAndSaysWhichClaimsHoldAndWhyOneDoesNot) {
  const Result result = run("experiment fig7a --out results --quiet");
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("  holds: "), HasSubstr("  as expected, does not hold: "),
                                HasSubstr("because ")));
  for (const char* name : {"fig7a.svg", "fig7a.pdf", "fig7a.png", "fig7a.gp", "fig7a.csv"})
    EXPECT_GT(fs::file_size(here() / "results/fig7a" / name), 100U) << name;
  const auto manifest = nlohmann::json::parse(content(here() / "results/fig7a/manifest.json"));
  EXPECT_EQ(manifest["configuration"]["terrain"], "flat");
  EXPECT_EQ(manifest["verdicts"][0]["holds"], true);
  EXPECT_EQ(manifest["verdicts"][3]["holds"], false);
  EXPECT_FALSE(manifest["verdicts"][3]["checks"][0]["why_not"].get<std::string>().empty());
  EXPECT_FALSE(manifest.contains("results")) << "it is no walk";
}

// Claims are made for the ideal plant.
TEST_F(Cli, RunsAnExperimentOnAnotherPlantAndJudgesNoClaim) {
  const Result result =
      run("experiment fig9 --short --plant real --friction 0.5 --out results --quiet");
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("not judged: it is a claim about the ideal plant"),
                                HasSubstr("walks that fell: 0 %")));
  const auto manifest = nlohmann::json::parse(content(here() / "results/fig9/manifest.json"));
  EXPECT_EQ(manifest["plant"]["name"], "real+friction:0.5");
  EXPECT_EQ(manifest["configuration"]["plant"], manifest["plant"]);
  EXPECT_EQ(manifest["verdicts"][0]["holds"], nlohmann::json());
  EXPECT_THAT(content(here() / "results/fig9/fig9.gp"), HasSubstr("plant real+friction:0.5"));
}

TEST_F(Cli, MakesAPageOfResultsWithEachFigureItsBoundAndItsCommand) {
  const Result result = run("results --only fig7a --only table1 --out page.md --figures r --quiet");
  EXPECT_EQ(result.status, 0);
  const std::string page = content(here() / "page.md");
  EXPECT_THAT(page,
              AllOf(HasSubstr("`hexagait experiment table1`"), HasSubstr("| states | 62 | 62 |"),
                    HasSubstr("**as expected, does not hold**"), HasSubstr("expected -33 to -18 %"),
                    HasSubstr("| because ")));
  EXPECT_THAT(page, ::testing::Not(HasSubstr("fig10")));
}

// Each section says when it was measured; what another one says stays to the letter.
TEST_F(Cli, MeasuresOneGroupOfThePageOfResultsAgain) {
  ASSERT_EQ(run("results --only fig7a --only table1 --out page.md --figures r --quiet").status, 0);
  std::string page = content(here() / "page.md");
  const auto replace = [&page](const std::string& what, const std::string& by) {
    const std::size_t at = page.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    page.replace(at, what.size(), by);
  };
  replace("| states | 62 | 62 |", "| states | 62 | 61 |");
  replace("| most classes in a cell | 1 | 1 |", "| most classes in a cell | 1 | 7 |");
  const std::string table1 = page.substr(0, page.find("\n## [PC04] Fig. 7-A"));
  std::ofstream(here() / "page.md") << page;
  ASSERT_EQ(run("results --only fig7a --out page.md --figures r --quiet").status, 0);
  EXPECT_THAT(content(here() / "page.md"),
              AllOf(::testing::StartsWith(table1), HasSubstr("`hexagait experiment fig7a`, 20")));
  ASSERT_EQ(run("results --only table1 --out page.md --figures r --quiet").status, 0);
  EXPECT_THAT(content(here() / "page.md"),
              AllOf(HasSubstr("| states | 62 | 62 |"),
                    HasSubstr("| most classes in a cell | 1 | 1 |"), HasSubstr("fig7a")));
}

TEST_F(Cli, LeavesAPageAloneThatIsNotOneOfResults) {
  std::ofstream(here() / "notes.md") << "# Notes\n";
  const Result result = run("results --only table1 --out notes.md --figures r --quiet");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err,
              AllOf(HasSubstr("notes.md"), HasSubstr("not a page of hexagait results")));
  EXPECT_EQ(content(here() / "notes.md"), "# Notes\n");
}

TEST_F(Cli, RefusesAGroupOfResultsThatDoesNotExist) {
  const Result result = run("results --only fig77 --out page.md");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("fig77"), HasSubstr("speed")));
  EXPECT_FALSE(fs::exists(here() / "page.md"));
}

TEST_F(Cli, MakesTheSameFigureInEveryProcess) {
  run("experiment fig6 --out a --quiet");
  run("experiment fig6 --out b --quiet");
  for (const char* name : {"fig6.svg", "fig6.csv", "fig6.gp"})
    EXPECT_EQ(content(here() / "a/fig6" / name), content(here() / "b/fig6" / name)) << name;
}

TEST_F(Cli, LeavesTitlesOutOfFiguresIfAsked) {
  run("experiment fig4 --quiet --title none");
  const std::string svg = content(here() / "results/fig4/fig4.svg");
  EXPECT_THAT(svg, HasSubstr("All 20 states"));
  EXPECT_THAT(svg, Not(HasSubstr("Transitions between")));
  EXPECT_THAT(svg, HasSubstr("width=\"1400\" height=\"825\""));
}

// Interrupted, it tells how far it got, and its trace is whole.
TEST_F(Cli, StopsCleanlyWhenInterrupted) {
  const pid_t child = start("walk --seconds 80000 --quiet --json --trace walk.csv");
  usleep(700'000);
  kill(child, SIGINT);
  const Result result = finish(child);
  EXPECT_EQ(result.status, 130);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["interrupted"], true);
  EXPECT_GT(json["seconds"].get<double>(), 0.0);
  EXPECT_TRUE(content(here() / "walk.csv").ends_with('\n'));
}

TEST_F(Cli, WalksGenghisInTheSideView) {
  const Result result = run("walk --robot genghis2d --seconds 3 --plot g.svg --trace g.csv --json");
  EXPECT_EQ(result.status, 0);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["robot"], "genghis2d");
  EXPECT_EQ(json["gait"], "free");
  EXPECT_EQ(json["rule1_violations"], 0);
  EXPECT_EQ(json["state_hash"].get<std::string>().size(), 16U);
  EXPECT_THAT(content(here() / "g.svg"), HasSubstr("From the side"));
  EXPECT_GT(fs::file_size(here() / "g.csv"), 1000U);
}

TEST_F(Cli, ShowsWhatItRecognisesOfARobot) {
  EXPECT_THAT(run("robot argos").out, AllOf(HasSubstr("6 legs"), HasSubstr("LF")));
  const auto json = nlohmann::json::parse(run("robot argos --json").out);
  EXPECT_EQ(json["legs"].size(), 6U);
  EXPECT_NEAR(json["mass_kg"].get<double>(), 50.0, 1e-6);
}

}  // namespace
}  // namespace hexagait::app
