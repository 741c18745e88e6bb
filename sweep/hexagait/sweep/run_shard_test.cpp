// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "run_shard.hpp"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <hexagait/urdf/urdf.hpp>

#include "scratch_sweep.hpp"
#include "worker_pool.hpp"

namespace hexagait::sweep {
namespace {

using testing::HasSubstr;
using Running = ScratchSweep;

// Processes that this one has started.
std::vector<pid_t> children() {
  std::vector<pid_t> result;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    std::string name, state;
    pid_t process = 0, parent = 0;
    if (stat >> process >> name >> state >> parent && parent == getpid()) result.push_back(process);
  }
  return result;
}

TEST_F(Running, GivesTheSameBytesWhateverTheNumberOfJobs) {
  const Sweep sweep = slices(40);
  const std::string one = run(sweep, "one");
  EXPECT_EQ(lines(at("one") / "trials.csv").size(), 361U);
  EXPECT_EQ(run(sweep, "two", 2), one);
  EXPECT_EQ(run(sweep, "three", 3), one);
  EXPECT_TRUE(each_once("three"));
}

TEST_F(Running, GivesTheSameBytesInPhysics) {
  for (const Engine engine : {Engine::box2d, Engine::ode}) {
    Sweep sweep;
    sweep.engine = engine;
    sweep.controllers = {*gait_state::parse_gait_choice("free"),
                         *gait_state::parse_gait_choice("wave:0.75")};
    sweep.robots.push_back({.name = "argos", .model = {}});
    if (engine == Engine::ode)
      sweep.robots[0].model = load_urdf(HEXAGAIT_SOURCE_DIR "/robots/argos.urdf");
    sweep.terrains = {ground(engine, rough_terrains(engine).front() + ":0.05")};
    sweep.num_seeds = 2;
    sweep.limits.seconds = 1.0;
    const std::string name(to_string(engine));
    EXPECT_EQ(run(sweep, name + "1", 1), run(sweep, name + "2", 2));
  }
}

// Stopped when the first chunks are in, it has a part; the same call goes on, and repeats nothing.
TEST_F(Running, GoesOnWhereItWasStopped) {
  const Sweep sweep = slices(200, 500);
  std::atomic<bool> stop = false;
  RunOptions options{.jobs = 2, .stop = &stop};
  options.progress = [&](std::uint64_t finished, std::uint64_t) { stop = finished > 20; };
  const RunOutcome first = run_shard(sweep, {}, at("a"), options);
  EXPECT_FALSE(first.complete());
  EXPECT_GT(first.finished, 20U);
  ASSERT_FALSE(first.missing.empty());
  EXPECT_EQ(first.missing.back().last, num_trials(sweep) - 1);
  EXPECT_EQ(journaled("a").size(), first.finished);

  const RunOutcome second = run_shard(sweep, {}, at("a"), {.jobs = 2});
  EXPECT_EQ(second.before, first.finished);
  EXPECT_TRUE(second.complete());
  EXPECT_TRUE(each_once("a"));
  EXPECT_EQ(run(sweep, "a"), run(sweep, "b"));
}

TEST_F(Running, DoesNothingWhenAllIsDone) {
  const Sweep sweep = slices(5);
  const std::string once = run(sweep, "a");
  const std::string journal = content(journal_path(at("a")));
  const RunOutcome again = run_shard(sweep, {}, at("a"), {});
  EXPECT_EQ(again.before, again.trials);
  EXPECT_EQ(content(journal_path(at("a"))), journal);
}

// A worker is killed: the others go on, its trials are told as missing, and made good later.
TEST_F(Running, TellsWhatAKilledWorkerLeftUndone) {
  const Sweep sweep = slices(200, 500);
  bool killed = false;
  RunOptions options{.jobs = 2};
  options.progress = [&](std::uint64_t, std::uint64_t) {
    if (!killed) kill(children().at(0), SIGKILL);
    killed = true;
  };
  const RunOutcome outcome = run_shard(sweep, {}, at("a"), options);
  ASSERT_TRUE(killed);
  EXPECT_FALSE(outcome.complete());
  ASSERT_EQ(outcome.failures.size(), 1U);
  EXPECT_THAT(outcome.failures[0], HasSubstr("signal 9"));
  std::uint64_t missing = 0;
  for (const TrialRange& range : outcome.missing) missing += range.last - range.first + 1;
  EXPECT_EQ(missing, outcome.trials - outcome.finished);

  EXPECT_EQ(run(sweep, "a"), run(sweep, "b"));
  EXPECT_TRUE(each_once("a"));
}

// A file that may not grow beyond 8 kB is a disk that is full.
TEST_F(Running, KeepsWhatFitsOnAFullDisk) {
  const Sweep sweep = slices(40);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit full = before;
  full.rlim_cur = 8192;
  setrlimit(RLIMIT_FSIZE, &full);
  const RunOutcome outcome = run_shard(sweep, {}, at("a"), {});
  setrlimit(RLIMIT_FSIZE, &before);

  EXPECT_FALSE(outcome.complete());
  EXPECT_GT(outcome.finished, 0U);
  ASSERT_EQ(outcome.failures.size(), 1U);
  EXPECT_THAT(outcome.failures[0], HasSubstr("the journal can't be written"));
  EXPECT_TRUE(content(journal_path(at("a"))).ends_with('\n'));
  EXPECT_EQ(journaled("a").size(), outcome.finished);
  EXPECT_EQ(run(sweep, "a"), run(sweep, "b"));
  EXPECT_TRUE(each_once("a"));
}

// What kill -9 leaves of a line is no trial.
TEST_F(Running, PassesOverALineThatWasNeverFinished) {
  const Sweep sweep = slices(5);
  const std::string whole = run(sweep, "a");
  const auto size = std::filesystem::file_size(journal_path(at("a")));
  for (const std::uintmax_t cut : {1U, 30U, 400U}) {
    std::filesystem::resize_file(journal_path(at("a")), size - cut);
    EXPECT_EQ(run(sweep, "a"), whole);
    EXPECT_EQ(journaled("a").size(), num_trials(sweep));
    EXPECT_TRUE(each_once("a"));
  }
  std::filesystem::resize_file(journal_path(at("a")), 10);  // not even the first line
  EXPECT_EQ(run(sweep, "a"), whole);
}

TEST_F(Running, RefusesTheDirectoryOfAnotherSweep) {
  const Sweep sweep = slices(3);
  run(sweep, "a");
  Sweep other = sweep;
  other.limits.slices = 60;
  const auto refused = [&](const Sweep& asked, const Shard& shard) {
    return refusal([&] { static_cast<void>(run_shard(asked, shard, at("a"), {})); });
  };
  EXPECT_THAT(refused(other, {}), testing::AllOf(HasSubstr("limits"), HasSubstr("60")));
  EXPECT_THAT(refused(sweep, {0, 2}), HasSubstr("shard: [1,2] against [1,1]"));
}

TEST_F(Running, RefusesADirectoryThatAnotherProcessWrites) {
  const Sweep sweep = slices(3);
  const Journal other(at(""), "{}", 0);
  EXPECT_THAT(refusal([&] { Journal(at(""), "{}", 0); }), HasSubstr("another process"));
}

// One trial fails by itself; its neighbours in the chunk do not.
TEST_F(Running, LosesOnlyTheTrialThatFails) {
  WorkerPool pool(1, [](std::uint64_t k) {
    if (k == 1) throw std::runtime_error("no trial 1");
    return std::to_string(k) + "\n";
  });
  pool.assign({0, 4});
  const std::vector<Answer> answers = pool.wait(std::chrono::milliseconds(10'000));
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].lines, "0\n2\n3\n");
  EXPECT_EQ(answers[0].failure, "no trial 1");
  EXPECT_EQ(pool.idle(), 1);
}

TEST_F(Running, LeavesNoProcessBehind) {
  run(slices(5), "a", 3);
  EXPECT_TRUE(children().empty());
}

}  // namespace
}  // namespace hexagait::sweep
