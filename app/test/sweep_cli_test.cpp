// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>
#include <sstream>
#include <testing/source_path.hpp>

#include "cli_fixture.hpp"

// Sweeps as a user meets them: exit status, what is printed where, what is left behind.
namespace hexagait::app {
namespace {

constexpr const char* kSweep =
    "simulator: slice\ncontrollers: [tripod, free]\nterrains: [descent:3-7]\nslices: 200\n";

class SweepCli : public Cli {
 protected:
  SweepCli() { write("sweep.yaml", std::string(kSweep) + "seeds: 20\n"); }

  [[nodiscard]] fs::path at(const std::string& name) const { return here() / name; }
  void write(const std::string& name, const std::string& text) { std::ofstream(at(name)) << text; }
};

TEST_F(SweepCli, WritesRowsTimingsAndAManifest) {
  const Result result = run("sweep sweep.yaml --out a --jobs 2 --json");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["trials"], 40);
  EXPECT_EQ(json["complete"], true);
  const auto manifest = nlohmann::json::parse(content(at("a/manifest.json")));
  EXPECT_EQ(manifest["rows_hash"], json["rows_hash"]);
  EXPECT_EQ(manifest["controllers"][1], "free");
  EXPECT_TRUE(
      content(at("a/trials.csv")).starts_with("trial,controller,robot,plant,terrain,roughness,"));
  EXPECT_TRUE(content(at("a/timings.csv")).starts_with("trial,wall_s\n0,"));
}

TEST_F(SweepCli, RefusesASweepFileWithAllItsErrorsAndWritesNothing) {
  write("bad.yaml", "simulator: slice\ncontroller: [free]\nterrains: [swamp]\nseeds: -3\n");
  const Result result = run("sweep bad.yaml --out a");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(result.err,
              AllOf(HasSubstr("bad.yaml:2:1: unknown key of sweep \"controller\"; did you mean"),
                    HasSubstr("bad.yaml:3:12: the slice model has no terrain 'swamp'"),
                    HasSubstr("bad.yaml:4:8: seeds: is \"-3\""),
                    HasSubstr("bad.yaml:1:1: sweep: the key \"controllers\" is missing")));
  EXPECT_FALSE(fs::exists(at("a")));
}

// A terrain of two numbers is one cell of the table, and a file that can't be read is told at once.
TEST_F(SweepCli, TakesTerrainsOfTwoNumbersAndOfFiles) {
  write("map.csv", "0,1\n1,0\n");
  write("a.yaml",
        "simulator: ode\ncontrollers: [tripod, clocked]\nterrains: ['stairs:5cm,40cm', "
        "'heightmap:5cm,2m,map.csv']\nseeds: 1\nseconds: 0.4\n");
  const Result result = run("sweep a.yaml --out a --quiet");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(content(at("a/trials.csv")),
              AllOf(HasSubstr(",stairs:0.05;0.4,0.05,"), HasSubstr(",heightmap:0.05;2;map.csv,")));
  EXPECT_THAT(content(at("a/manifest.json")), HasSubstr("\"map.csv\""));
  EXPECT_EQ(run("report a --json").status, 0);
  EXPECT_EQ(run("walk --terrain 'heightmap:0.05;2;map.csv' --seconds 0.2 --quiet").status, 0);

  write("map.csv", "0,1\n1,0.5\n");
  EXPECT_EQ(run("sweep a.yaml --out a --quiet").status, 2) << "another file is another sweep";
  write("b.yaml",
        "simulator: ode\ncontrollers: [tripod]\nterrains: ['heightmap:5cm,2m,no.csv']\nseeds: 1\n");
  const Result bad = run("sweep b.yaml --out b");
  EXPECT_EQ(bad.status, 2);
  EXPECT_THAT(bad.err, AllOf(HasSubstr("b.yaml:3:12"), HasSubstr("no.csv")));
  write("c.yaml", "simulator: slice\ncontrollers: [clocked]\nterrains: [flat]\nseeds: 1\n");
  EXPECT_THAT(run("sweep c.yaml --out c").err, HasSubstr("has no 'clocked'"));
}

TEST_F(SweepCli, RefusesOptionsThatMakeNoSense) {
  for (const auto& [options, word] :
       {std::pair("--jobs 0", "--jobs is '0'"), std::pair("--jobs many", "'many'"),
        std::pair("--shard 3", "2/8"), std::pair("--shard 3/2", "from 1 to 2"),
        std::pair("--shard 0/2", "'0'"),
        std::pair("--emit pbs --shards 2", "slurm, parallel or mpi"),
        std::pair("--emit slurm", "--shards N"), std::pair("--shards 2", "--emit"),
        std::pair("--retry --emit mpi --shards 2", "--emit and --retry"),
        std::pair("--trial-timeout 0", "--trial-timeout is '0'"),
        std::pair("--trial-timeout soon", "0.001 to 10000000 seconds")}) {
    const Result result = run(std::string("sweep sweep.yaml --out a ") + options);
    EXPECT_EQ(result.status, 2) << options;
    EXPECT_THAT(result.err, HasSubstr(word)) << options;
    EXPECT_FALSE(fs::exists(at("a"))) << options;
  }
  EXPECT_EQ(run("sweep sweep.yaml").status, 2);
  EXPECT_EQ(run("sweep sweep.yaml --out /proc/a").status, 2);
  EXPECT_EQ(run("merge none --out a").status, 2);
  EXPECT_EQ(run("report none").status, 2);
}

TEST_F(SweepCli, MergesShardsIntoTheBytesOfOneProcess) {
  EXPECT_EQ(run("sweep sweep.yaml --out whole").status, 0);
  EXPECT_EQ(run("sweep sweep.yaml --out b --shard 2/2 --jobs 1").status, 0);
  EXPECT_EQ(run("sweep sweep.yaml --out a --shard 1/2 --jobs 3").status, 0);
  EXPECT_EQ(run("merge b a --out both").status, 0);
  EXPECT_EQ(content(at("both/trials.csv")), content(at("whole/trials.csv")));
  const Result gap = run("merge a --out half");
  EXPECT_EQ(gap.status, 2);
  EXPECT_THAT(gap.err, HasSubstr("trials 2 to 3 missing"));
  EXPECT_FALSE(fs::exists(at("half")));
}

// Ctrl-C, and worse, in the middle of 20 000 trials; then the same command again.
TEST_F(SweepCli, LosesAndRepeatsNoTrialWhenItIsInterrupted) {
  write("long.yaml", std::string(kSweep) + "seeds: 10000\n");
  const auto lines = [&] {
    const std::string text = content(at("a/journal.txt"));
    return std::count(text.begin(), text.end(), '\n');
  };
  for (const int signal : {SIGINT, SIGKILL}) {
    const auto before = lines();
    const pid_t child = start("sweep long.yaml --out a --quiet");
    while (lines() < before + 100 && waitpid(child, nullptr, WNOHANG) == 0) usleep(2000);
    kill(child, signal);
    const Result result = finish(child);
    EXPECT_LT(lines(), 20'001);
    if (signal == SIGKILL) continue;
    EXPECT_EQ(result.status, 130);
    EXPECT_THAT(result.err, AllOf(HasSubstr("finished and kept; missing: "), HasSubstr("-19999")));
    EXPECT_FALSE(fs::exists(at("a/trials.csv")));
  }
  EXPECT_EQ(run("sweep long.yaml --out a --quiet").status, 0);
  EXPECT_EQ(lines(), 20'001);  // each trial once, and the first line
  EXPECT_EQ(run("sweep long.yaml --out b --quiet").status, 0);
  EXPECT_EQ(content(at("a/trials.csv")), content(at("b/trials.csv")));
}

// A machine that was too slow: the walk comes out as if it had not been.
TEST_F(SweepCli, RunsTrialsWithoutAResultAgain) {
  write("walk.yaml",
        "simulator: ode\ncontrollers: [tripod]\nterrains: [flat]\nseeds: [1]\nseconds: 3\n");
  const Result slow = run("sweep walk.yaml --out a --quiet --trial-timeout 0.001");
  EXPECT_EQ(slow.status, 0);
  EXPECT_THAT(slow.err, HasSubstr("1 trial has no result"));
  EXPECT_THAT(content(at("a/trials.csv")), HasSubstr(",timed_out,"));
  EXPECT_THAT(run("sweep walk.yaml --out a --quiet").err, HasSubstr("1 trial has no result"));
  const Result again = run("sweep walk.yaml --out a --quiet --retry --json");
  EXPECT_EQ(again.status, 0);
  EXPECT_THAT(again.err, IsEmpty());
  EXPECT_EQ(nlohmann::json::parse(again.out)["retried"], 1);
  EXPECT_EQ(run("sweep walk.yaml --out b --quiet").status, 0);
  EXPECT_EQ(content(at("a/trials.csv")), content(at("b/trials.csv")));
}

// 10¹² trials: a user who did not mean it is warned before a day is lost, and keeps what is done.
TEST_F(SweepCli, AsksBeforeASweepOfYears) {
  write("endless.yaml", std::string(kSweep) + "seeds: 500000000000\n");
  const Result result = run("sweep endless.yaml --out a --quiet --jobs 2");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("1000000000000 trials on 2 processes would take"),
                                HasSubstr("are finished and kept"), HasSubstr("--yes")));
}

TEST_F(SweepCli, RefusesADirectoryInPlaceOfAFile) {
  fs::create_directory(at("folder"));
  const Result result = run("sweep folder --out a");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("folder: is a directory; a sweep file is expected"));
  EXPECT_FALSE(fs::exists(at("a")));
}

// 8 blocks of 512 B: room for the first line and some trials.
TEST_F(SweepCli, TellsWhatIsMissingWhenTheDiskIsFull) {
  prefix_ = "ulimit -f 8; ";
  const Result result = run("sweep sweep.yaml --out a");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("the journal can't be written: a/"),
                                HasSubstr("of 40 trials are finished and kept; missing: ")));
  prefix_ = "";
  EXPECT_EQ(run("sweep sweep.yaml --out a").status, 0);
  EXPECT_EQ(run("sweep sweep.yaml --out b").status, 0);
  EXPECT_EQ(content(at("a/trials.csv")), content(at("b/trials.csv")));
}

// A row tells how to see its walk: its seed gives the same bits in hexagait walk.
TEST_F(SweepCli, NamesTheSeedThatWalksTheSameWalkAgain) {
  write("walk.yaml",
        "simulator: ode\ncontrollers: ['wave:0.75']\nterrains: [boxes:0.1]\nseeds: 1\n"
        "seconds: 2\nrandom_posture: 0.05\n");
  EXPECT_EQ(run("sweep walk.yaml --out a").status, 0);
  std::string row = content(at("a/trials.csv"));
  row.pop_back();
  row = row.substr(row.rfind('\n') + 1);
  std::istringstream cells(row);
  std::string seed;
  for (int i = 0; i < 7; ++i) std::getline(cells, seed, ',');
  const Result walk =
      run("walk --gait wave:0.75 --terrain boxes:0.1 --random-posture 0.05 "
          "--seconds 2 --json --seed " +
          seed);
  EXPECT_EQ(nlohmann::json::parse(walk.out)["state_hash"], row.substr(row.rfind(',') + 1));
}

TEST_F(SweepCli, ReportsWithATableAndAFigure) {
  EXPECT_EQ(run("sweep sweep.yaml --out a").status, 0);
  const Result words = run("report a");
  EXPECT_EQ(words.status, 0);
  EXPECT_THAT(words.out, AllOf(HasSubstr("less tripod"), HasSubstr("±"), HasSubstr("%)"),
                               HasSubstr("report-speed_units_per_slice.svg")));
  EXPECT_TRUE(fs::exists(at("a/report-speed_units_per_slice.pdf")));
  const auto json = nlohmann::json::parse(run("report a --json --measure steps").out);
  EXPECT_EQ(json["measure"], "steps");
  EXPECT_EQ(json["lines"][1]["difference"]["count"], 20);
  EXPECT_EQ(run("report a --compare gaits").status, 2);
}

TEST_F(SweepCli, SaysSoWhenItCannotWriteToStdout) {
  EXPECT_EQ(run("sweep sweep.yaml --out a").status, 0);
  for (const char* arguments :
       {"sweep sweep.yaml --out a", "sweep sweep.yaml --out a --json", "report a",
        "merge a --out b", "sweep sweep.yaml --emit mpi --shards 2 --out c"}) {
    const Result result = run(std::string(arguments) + " >/dev/full");
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr("can't write to standard output: No space left on device"))
        << arguments;
  }
}

TEST_F(SweepCli, ReportsSeveralMeasuresEachInItsOwnFiles) {
  EXPECT_EQ(run("sweep sweep.yaml --out a").status, 0);
  EXPECT_EQ(run("report a --measure steps --measure stroke_units --title none").status, 0);
  EXPECT_TRUE(fs::exists(at("a/report-steps.svg")));
  EXPECT_TRUE(fs::exists(at("a/report-stroke_units.svg")));
  const auto json =
      nlohmann::json::parse(run("report a --json --measure steps --measure stroke_units").out);
  EXPECT_EQ(json[1]["measure"], "stroke_units");
}

// A cluster has no gnuplot: JSON needs none, and the table comes before the complaint.
TEST_F(SweepCli, ReportsNumbersWithoutGnuplot) {
  EXPECT_EQ(run("sweep sweep.yaml --out a").status, 0);
  prefix_ = "PATH=/nowhere; ";
  EXPECT_EQ(run("report a --json").status, 0);
  const Result words = run("report a");
  EXPECT_EQ(words.status, 2);
  EXPECT_THAT(words.out, HasSubstr("less tripod"));
  EXPECT_THAT(words.err, HasSubstr("gnuplot"));
}

TEST_F(SweepCli, WritesJobFilesThatABashCanRead) {
  for (const std::string scheduler : {"slurm", "parallel", "mpi"}) {
    const Result result = run("sweep sweep.yaml --emit " + scheduler +
                              " --shards 7 --jobs 2 --trial-timeout 90 --out jobs");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_THAT(result.out, AllOf(HasSubstr(scheduler + ".sh"), HasSubstr("jobs/merged")));
  }
  for (const char* file :
       {"slurm.sh", "shard.sbatch", "merge.sbatch", "parallel.sh", "rank.sh", "mpi.sh"})
    EXPECT_EQ(std::system(("bash -n " + at("jobs/" + std::string(file)).string()).c_str()), 0);
  // Paths in the sweep file are relative to where the scripts were made.
  EXPECT_THAT(content(at("jobs/shard.sbatch")),
              HasSubstr("folder=${HEXAGAIT_FOLDER:-'" + here().string() + "'}"));
  EXPECT_THAT(content(at("jobs/shard.sbatch")),
              AllOf(HasSubstr("--array=1-7 --cpus-per-task=2"), HasSubstr("shards=7"),
                    HasSubstr("--trial-timeout 90")));
}

// What its file does not say is never substituted in silence.
TEST_F(SweepCli, TellsWhatOfARobotIsSubstituted) {
  std::string urdf = content(fs::path(testing::source_path("robots/argos.urdf")));
  const std::size_t effort = urdf.find("effort=\"200\"");
  ASSERT_NE(effort, std::string::npos);
  write("my.urdf", urdf.replace(effort, 12, "effort=\"0\""));
  write("walk.yaml",
        "simulator: ode\ncontrollers: [free]\nrobots: [./my.urdf]\nterrains: [flat]\nseeds: 1\n"
        "seconds: 0.1\n");
  EXPECT_THAT(run("sweep walk.yaml --out a --jobs 1 --json").err,
              AllOf(HasSubstr("./my.urdf: line "), HasSubstr("effort limit substituted: 0 N m")));
  EXPECT_THAT(run("sweep walk.yaml --out b --jobs 1 --json --quiet").err, IsEmpty());
}

// A robot named by a relative path is found from every shard.
TEST_F(SweepCli, RunsJobFilesWithARobotOfARelativePath) {
  const fs::path argos = fs::path(testing::source_path("robots/argos.urdf"));
  fs::copy_file(argos, at("my.urdf"));
  write("walk.yaml",
        "simulator: ode\ncontrollers: [free]\nrobots: [./my.urdf]\nterrains: [flat]\nseeds: 2\n"
        "seconds: 0.1\n");
  EXPECT_EQ(run("sweep walk.yaml --emit mpi --shards 2 --out jobs").status, 0);
  std::ofstream(at("mpirun"))
      << "#!/bin/sh\nshift 2\nOMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=1 \"$@\"\n";
  fs::permissions(at("mpirun"), fs::perms::owner_all);
  EXPECT_EQ(std::system(("MPIRUN='" + at("mpirun").string() + "' '" + at("jobs/mpi.sh").string() +
                         "' >/dev/null")
                            .c_str()),
            0);
  EXPECT_TRUE(content(at("jobs/merged/trials.csv")).find("./my.urdf") != std::string::npos);
}

}  // namespace
}  // namespace hexagait::app
