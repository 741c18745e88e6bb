// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>
#include <testing/source_path.hpp>

#include "cli_fixture.hpp"

// What the command lists and finds, and what it says when its results can't be written.
namespace hexagait::app {
namespace {

TEST_F(Cli, ListsWhatComesWithIt) {
  EXPECT_THAT(run("list robots").out, AllOf(HasSubstr("argos             6       3   50.0 kg"),
                                            HasSubstr("quadruped "), HasSubstr("genghis2d")));
  EXPECT_THAT(run("list actions").out,
              AllOf(HasSubstr("nod            argos         2 steps  The robot nods three times\n"),
                    HasSubstr("push_up        quadruped     6 steps  A push-up on three legs")));
  EXPECT_THAT(run("list terrains").out, AllOf(HasSubstr("boxes:H"), HasSubstr("rough:H")));
  EXPECT_EQ(run("list terrains").out, run("terrains").out) << "as before";
  EXPECT_THAT(run("list experiments").out, AllOf(HasSubstr("fig7b"), HasSubstr("fg16_fig6")));
}

TEST_F(Cli, ListsAsJson) {
  const auto list = [&](const std::string& what) {
    const Result result = run("list --json " + what);
    EXPECT_EQ(result.status, 0);
    return nlohmann::json::parse(result.out);
  };
  const auto robots = list("robots");
  EXPECT_EQ(robots[0]["name"], "argos");
  EXPECT_EQ(robots[0]["legs"], 6);
  EXPECT_NEAR(robots[0]["mass_kg"].get<double>(), 50.0, 1e-6);
  EXPECT_EQ(robots.back()["name"], "genghis2d");
  EXPECT_EQ(list("actions")[0]["name"], "body_circle");
  EXPECT_EQ(list("actions")[0]["robot"], "argos");
  EXPECT_EQ(list("terrains")[0]["syntax"], "flat");
  EXPECT_FALSE(list("experiments")[0]["title"].get<std::string>().empty());
}

// /dev/full takes nothing: every write fails as on a full disk.
TEST_F(Cli, ThatCannotWriteItsResultToStdoutSaysSoAndFails) {
  for (const char* arguments :
       {"robot argos", "list robots", "terrains", "walk --seconds 0.1", "check nod",
        "run height --quiet", "walk --robot genghis2d --seconds 0.1", "experiment --list",
        "experiment fig6 --quiet --out e --json"})
    for (const std::string target : {" >/dev/full", " >&-"}) {
      const Result result = run(arguments + target);
      EXPECT_EQ(result.status, 2) << arguments << target;
      EXPECT_THAT(result.err, HasSubstr("can't write to standard output")) << arguments << target;
    }
  EXPECT_THAT(run("robot argos >/dev/full").err, HasSubstr("No space left on device"));
}

TEST_F(Cli, ThatCannotWriteWhatItHasProvedSaysSo) {
  EXPECT_THAT(run("verify --quiet >/dev/full").err, HasSubstr("No space left on device"));
}

TEST_F(Cli, ThatCannotDrawAFigureDoesNotSayThatTheRobotFell) {
  std::ofstream(here() / "gnuplot") << "#!/bin/sh\nexit 3\n";
  fs::permissions(here() / "gnuplot", fs::perms::owner_all);
  prefix_ = "PATH='" + here().string() + "':$PATH; ";
  const Result result = run("walk --seconds 0.1 --plot walk.png");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("gnuplot could not draw"));
}

// With stdout closed the first file that is opened must not become it.
TEST_F(Cli, KeepsAResultOutOfItsFilesWhenStdoutIsClosed) {
  EXPECT_EQ(run("walk --seconds 0.1 --trace walk.csv >&-").status, 2);
  EXPECT_TRUE(content(here() / "walk.csv").starts_with("time_s"));
}

// Files of more than 4 kB can't be written, as on a disk that is full then.
TEST_F(Cli, ThatCannotWriteAFileNamesItAndStillShowsTheSummary) {
  prefix_ = "ulimit -f 8; trap '' XFSZ; ";
  const Result trace = run("walk --seconds 1 --trace walk.csv --quiet");
  EXPECT_EQ(trace.status, 2);
  EXPECT_THAT(trace.out, HasSubstr("straight ahead on flat ground"));
  EXPECT_THAT(trace.err,
              HasSubstr("--trace is 'walk.csv', which can't be written: File too large"));
  const Result plot = run("walk --seconds 1 --plot walk.svg --quiet");
  EXPECT_EQ(plot.status, 2);
  EXPECT_THAT(plot.out, HasSubstr("straight ahead on flat ground"));
  EXPECT_THAT(plot.err, AllOf(HasSubstr("--plot is 'walk.svg', which can't be written"),
                              HasSubstr("walk-body.csv"), HasSubstr("File too large")));
  EXPECT_TRUE(fs::is_empty(here())) << "nothing half-written";

  // Room for our tables, not for all of the picture: gnuplot itself does not notice.
  prefix_ = "ulimit -f 80; trap '' XFSZ; ";
  const Result picture = run("walk --seconds 1 --plot walk.svg --quiet");
  EXPECT_EQ(picture.status, 2);
  EXPECT_THAT(picture.err, AllOf(HasSubstr("--plot is 'walk.svg', which can't be written"),
                                 HasSubstr("incomplete")));
  EXPECT_TRUE(fs::is_empty(here()));
}

TEST_F(Cli, NamesTheExperimentWhoseFilesItCannotWrite) {
  prefix_ = "ulimit -f 8; trap '' XFSZ; ";
  const Result result = run("experiment fig6 --out results --quiet 2>&1");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.out, AllOf(HasSubstr("--out is 'results'"), HasSubstr("fig6"),
                                HasSubstr("File too large")));
}

// Not all of them, which take nine minutes.
TEST_F(Cli, ListsTheExperimentsIfNoneIsNamed) {
  EXPECT_EQ(run("experiment").out, run("list experiments").out);
  EXPECT_TRUE(fs::is_empty(here()));
}

TEST_F(Cli, ThatDoesNotArriveSaysSoAndFails) {
  const Result result = run("walk --distance 5 --seconds 1");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("Did not arrive at 5 m: after 1.0 s it had walked"));
  EXPECT_EQ(nlohmann::json::parse(run("walk --distance 5 --seconds 1 --json").out)["arrived"],
            false);
  EXPECT_EQ(run("walk --distance 10cm --seconds 10s").status, 0);
  const Result genghis = run("walk --robot genghis2d --distance 5 --seconds 1");
  EXPECT_EQ(genghis.status, 1);
  EXPECT_THAT(genghis.out, HasSubstr("Did not arrive at 5 m"));
}

// A microgram per link and legs that reach 0.54 m: lighter than air, as lengths in millimetres are.
// Masses that can't be are replaced, and said so: in the table, and on stderr of what moves.
TEST_F(Cli, SaysWhatItSubstitutesOfARobot) {
  EXPECT_THAT(run("robot argos").err, IsEmpty());
  std::string text = content(fs::path(testing::source_path("robots/quadruped.urdf")));
  const std::string from = "<mass value=\"";
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1)) {
    const std::size_t begin = at + from.size();
    text.replace(begin, text.find('"', begin) - begin, "1e-6");
  }
  write("light.urdf", text);
  const Result result = run("robot ../light.urdf --json");
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("substitutions"), HasSubstr("--density")));
  EXPECT_THAT(run("robot ../light.urdf").out,
              HasSubstr("line 26: link base_link: mass substituted: 1e-06 kg"));
  EXPECT_THAT(run("check nod --robot ../light.urdf").err,
              AllOf(HasSubstr("mass substituted"), HasSubstr("(--density)")));
  EXPECT_EQ(run("robot ../light.urdf --mass 30 --plot light.png").status, 0);
  EXPECT_TRUE(fs::exists(here() / "light.png"));
}

TEST_F(Cli, RefusesOverridesOfARobotThatAreNone) {
  for (const auto& [option, word] : {std::pair("--front sideways", "it must be +x, -x, +y, -y"),
                                     {"--up w", "-z"},
                                     {"--mass -3", "positive"},
                                     {"--foot LF_tibia", "LINK=X,Y,Z"},
                                     {"--foot LF_tibia=1,2", "LINK=X,Y,Z"},
                                     {"--scale 0", "positive"},
                                     {"--joint-range 90", "90deg"},
                                     {"--legs LF_yaw,none", "'none'"}}) {
    const Result result = run(std::string("robot argos ") + option);
    EXPECT_EQ(result.status, 2) << option;
    EXPECT_THAT(result.err, HasSubstr(word)) << option;
  }
}

// No path of the source tree is in the command: it finds its robots beside itself, or where
// HEXAGAIT_DATA says, and names the folder if there are none.
TEST_F(Cli, DoesNotKnowTheSourceTree) {
  EXPECT_EQ(content(HEXAGAIT_COMMAND).find(testing::source_path("")), std::string::npos);
}

TEST_F(Cli, FindsItsRobotsBesideItselfOrWhereItIsTold) {
  const fs::path source = testing::source_path("."), prefix = here() / "prefix";
  fs::create_directories(prefix / "bin");
  fs::copy_file(HEXAGAIT_COMMAND, prefix / "bin/hexagait");
  command_ = prefix / "bin/hexagait";
  EXPECT_THAT(run("robot argos").err,
              AllOf(HasSubstr("share/hexagait"), HasSubstr("HEXAGAIT_DATA")));
  for (const std::string what : {"robots", "actions", "paths"}) {
    const Result list = run("list " + what);
    EXPECT_EQ(list.status, 2);
    EXPECT_THAT(list.err,
                AllOf(HasSubstr("there are no " + what + " in"), HasSubstr("HEXAGAIT_DATA")));
    EXPECT_EQ(list.out, "");
  }
  prefix_ = "HEXAGAIT_DATA='" + source.string() + "'; export HEXAGAIT_DATA; ";
  EXPECT_EQ(run("robot argos").status, 0);
  fs::create_directories(prefix / "share/hexagait/robots");
  fs::copy_file(source / "robots/argos.urdf", prefix / "share/hexagait/robots/mine.urdf");
  EXPECT_EQ(run("robot mine").status, 0);
  EXPECT_EQ(run("robot argos").status, 2) << "what is installed comes first";
}

}  // namespace
}  // namespace hexagait::app
