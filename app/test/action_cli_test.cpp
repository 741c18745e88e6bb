// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "cli_fixture.hpp"

// `check` and `run` as a user meets them.
namespace hexagait::app {
namespace {

constexpr const char* kFar =
    "steps:\n- step:\n  - footstep:\n      name: LF\n"
    "      target: {frame: footprint, position: [1.5, 0.5, 0]}\n";

// 500 s with a foot in the air.
constexpr const char* kLong =
    "steps:\n- step:\n  - end_effector_target:\n      name: LF\n      ignore_contact: true\n"
    "      target_position: {frame: footprint, position: [0.49, 0.5, 0.1]}\n"
    "- repeat: {count: 100, steps: [step: [wait: {duration: 5}]]}\n";

TEST_F(Cli, HelpsWithActions) {
  for (const char* command : {"run", "check"}) {
    const Result result = run(std::string(command) + " --help");
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.out, AllOf(HasSubstr("Example"), HasSubstr("--set"),
                                  HasSubstr("push_up_six"), HasSubstr("Exit status")));
  }
}

TEST_F(Cli, RefusesActionsThatAreNoneAndNamesTheNearest) {
  for (const std::string command : {"run ", "check "}) {
    refuses(command + "puhs_up", {"'puhs_up'", "did you mean 'push_up'", "step_climb"});
    refuses(command + "none.yaml", {"none.yaml", "does not exist"});
    refuses(command + "/", {"'/'", "not a file"});
    refuses(command, {"action", "--help"});
    refuses(command + "nod --robot nobody", {"--robot", "'nobody'"});
    refuses(command + "nod --start flying", {"--start", "'flying'", "sitting"});
    refuses(command + "nod --set height", {"--set", "'height'", "NAME=VALUE"});
    refuses(command + "height --set hieght=1",
            {"--set", "'hieght=1'", "did you mean 'height'?", "it has height"});
    refuses(command + "nod --set a=1", {"no placeholder 'a'", "it has none"});
    refuses(command + "nod --start sittng", {"did you mean 'sitting'?"});
  }
  refuses("run nod --terrain swamp", {"swamp", "step:H"});
  refuses("run nod --seed x", {"--seed", "'x'"});
  refuses("run nod --controller virtual",
          {"--controller", "'virtual'", "kinematic or virtual_model"});
  refuses("run nod --controller kinematc", {"did you mean 'kinematic'"});
  refuses("check nod --controller kinematic", {"--controller"});
  refuses("run nod --plot nod.txt", {"--plot", "nod.txt", ".svg"});
  refuses("run nod --preview nod.txt", {"--preview", "nod.txt", ".svg"});
  refuses("run nod --plot a.png --preview b.png", {"--plot", "--preview"});
  refuses("run stand_up --robot quadruped --start sitting", {"quadruped", "belly"});
}

TEST_F(Cli, RefusesAWordThatAnActionDoesNotKnowWhereItStands) {
  write("bad.yaml",
        "steps:\n- step:\n  - footstep:\n      name: LF\n"
        "      target: {frame: footprnt, position: [0.5, 0.5, 0]}\n");
  for (const std::string command : {"run ", "check "})
    refuses(command + "../bad.yaml", {"bad.yaml:5:23", "footprnt", "did you mean \"footprint\""});
  refuses("check tripod --robot quadruped",
          {"tripod is for robots of 6 legs", "argos", "quadruped has 4"});
}

TEST_F(Cli, ChecksAnActionAndSaysSoInALine) {
  const Result result = run("check push_up --robot quadruped");
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("6 steps"), HasSubstr("stability margin at least"),
                                HasSubstr("0 errors")));
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
  const Result quiet = run("check push_up --robot quadruped --quiet");
  EXPECT_EQ(quiet.status, 0);
  EXPECT_THAT(quiet.out, IsEmpty());
}

TEST_F(Cli, FindsWhatARobotCannotDoAndMovesNothing) {
  write("far.yaml", kFar);
  const Result check = run("check ../far.yaml");
  EXPECT_EQ(check.status, 1);
  EXPECT_THAT(check.out, AllOf(HasSubstr("far.yaml:3:5: error: step 1, LF"),
                               HasSubstr("mm beyond where the leg reaches"), HasSubstr("1 error")));
  const Result refused = run("run ../far.yaml");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.out, IsEmpty());
  EXPECT_THAT(refused.err, AllOf(HasSubstr("far.yaml:3:5: error"), HasSubstr("--force")));

  // Against advice: it fails there, and stands.
  const Result forced = run("run ../far.yaml --force --json");
  EXPECT_EQ(forced.status, 1);
  const auto json = nlohmann::json::parse(forced.out);
  EXPECT_EQ(json["outcome"], "failed");
  EXPECT_EQ(json["leg"], "LF");
  EXPECT_EQ(json["step"], 1);
  EXPECT_EQ(json["fell"], false);
}

// Six steps to where the leg doesn't reach: three lines, and how many more.
TEST_F(Cli, ShowsTheFirstFindingsOfAKindAndHowManyMoreThereAre) {
  std::string text = kFar;
  for (int i = 1; i < 6; ++i) text += std::string(kFar).substr(std::string("steps:\n").size());
  write("far.yaml", text);
  const Result result = run("check ../far.yaml");
  EXPECT_EQ(result.status, 1);
  EXPECT_LE(std::count(result.out.begin(), result.out.end(), '\n'), 6);
  EXPECT_THAT(result.out, HasSubstr("../far.yaml: 3 more errors of this kind (out_of_reach); "
                                    "hexagait check --json lists them all"));
  const auto json = nlohmann::json::parse(run("check ../far.yaml --json").out);
  EXPECT_GE(json["findings"].size(), 6U);
}

TEST_F(Cli, TellsACheckAsJson) {
  write("far.yaml", kFar);
  const auto json = nlohmann::json::parse(run("check ../far.yaml --json").out);
  EXPECT_EQ(json["ok"], false);
  EXPECT_EQ(json["errors"], 1);
  EXPECT_EQ(json["findings"][0]["line"], 3);
  EXPECT_EQ(json["findings"][0]["column"], 5);
  EXPECT_EQ(json["findings"][0]["kind"], "out_of_reach");
  EXPECT_EQ(nlohmann::json::parse(run("check nod --json").out)["ok"], true);
}

// 0.24 m above the feet's centres, which are 2 cm above the ground; then what --set says.
TEST_F(Cli, RunsAnActionWithPlaceholders) {
  const auto height = [&](const std::string& options) {
    const Result result = run("run height --json --quiet " + options);
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.err, IsEmpty());
    return nlohmann::json::parse(result.out);
  };
  EXPECT_NEAR(height("")["body_height_m"]["min"].get<double>(), 0.26, 0.002);
  EXPECT_NEAR(height("--set height=0.36")["body_height_m"]["max"].get<double>(), 0.38, 0.002);
  const auto json = height("--set height=0.2");
  for (const char* key : {"action",      "file",
                          "robot",       "steps",
                          "terrain",     "seed",
                          "controller",  "outcome",
                          "cause",       "step",
                          "leg",         "seconds",
                          "fell",        "base_touched",
                          "leg_touched", "stands_at_end",
                          "tilt_rad",    "stability_margin_m",
                          "fault",       "odometry_error_m",
                          "out_of_time", "interrupted",
                          "check",       "state_hash",
                          "version"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["outcome"], "succeeded");
}

// The same height, by torques alone: another run to the bit.
TEST_F(Cli, RunsAnActionWithTheControllerThatIsAskedFor) {
  std::set<std::string> hashes;
  for (const std::string controller : {"kinematic", "virtual_model"}) {
    const Result result = run("run height --json --quiet --controller " + controller);
    EXPECT_EQ(result.status, 0);
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["controller"], controller);
    EXPECT_NEAR(json["body_height_m"]["min"].get<double>(), 0.26, 0.005);
    hashes.insert(json["state_hash"]);
  }
  EXPECT_EQ(hashes.size(), 2U);
  EXPECT_THAT(run("run height --quiet --controller virtual_model").out, HasSubstr("torques"));
}

// A line per step where stderr is no terminal.
TEST_F(Cli, TellsEveryStepAndInTheEndHowItWent) {
  const Result result = run("run push_up --robot quadruped");
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("Succeeded: push_up on quadruped"),
                                HasSubstr("never touched the ground")));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 6);
  EXPECT_THAT(result.err, AllOf(HasSubstr("step 1/6"), HasSubstr("step 6/6")));
}

TEST_F(Cli, StandsUpFromItsBelly) {
  const auto json =
      nlohmann::json::parse(run("run recovery --start lying --seed 5 --json --quiet").out);
  EXPECT_EQ(json["outcome"], "succeeded");
  EXPECT_EQ(json["stands_at_end"], true);
  EXPECT_EQ(json["base_touched"], true);
}

TEST_F(Cli, DrawsAPreviewWithoutSimulatingAndAPlotOfWhatHappened) {
  EXPECT_EQ(run("run push_up --robot quadruped --preview a.svg").status, 0);
  EXPECT_EQ(run("run height --quiet --plot b.svg").status, 0);
  for (const char* stem : {"a", "b"}) {
    for (const char* ending : {".svg", ".gp", "-base.csv", "-feet.csv", "-steps.csv"})
      EXPECT_GT(std::ranges::count(content(here() / (std::string(stem) + ending)), '\n'), 1)
          << stem << ending;
    EXPECT_THAT(content(here() / (std::string(stem) + ".svg")),
                AllOf(HasSubstr("From above"), HasSubstr("Stability margin")));
  }
}

TEST_F(Cli, ComesToAStanceWhenInterrupted) {
  write("long.yaml", kLong);
  const pid_t child = start("run ../long.yaml --json");
  while (err_so_far().find("step 2/") == std::string::npos) usleep(20'000);
  kill(child, SIGINT);
  const Result result = finish(child);
  EXPECT_EQ(result.status, 130);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["interrupted"], true);
  EXPECT_EQ(json["outcome"], "preempted");
  EXPECT_EQ(json["fell"], false);
  EXPECT_LT(json["seconds"].get<double>(), 400.0);
}

// The shape of the draft of 2015.
TEST_F(Cli, RunsAStepGoalOf2015) {
  write("goal.yaml",
        "steps:\n- step_number: 1\n  swing_data:\n  - name: LF\n"
        "    profile: {target: {frame: odom, position: [0.5, 0.5, 0.02]}, height: 0.05}\n");
  EXPECT_EQ(run("check ../goal.yaml").status, 0);
  refuses("check ../goal.yaml --set a=1", {"--set", "2015"});
}

}  // namespace
}  // namespace hexagait::app
