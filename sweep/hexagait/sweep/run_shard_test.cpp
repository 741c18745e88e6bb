// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "run_shard.hpp"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <hexagait/sweep/detail/made_directory.hpp>
#include <hexagait/sweep/detail/scratch_sweep.hpp>
#include <testing/argos.hpp>
#include <thread>

namespace hexagait::sweep {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
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
    if (engine == Engine::ode) sweep.robots[0].model = testing::argos();
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

// A worker is killed: another takes its place, and nothing is missing.
TEST_F(Running, MakesGoodWhatAKilledWorkerLeftUndone) {
  const Sweep sweep = slices(200, 500);
  bool killed = false;
  RunOptions options{.jobs = 2};
  options.progress = [&](std::uint64_t, std::uint64_t) {
    if (!killed) kill(children().at(0), SIGKILL);
    killed = true;
  };
  const RunOutcome outcome = run_shard(sweep, {}, at("a"), options);
  ASSERT_TRUE(killed);
  EXPECT_TRUE(outcome.complete());
  EXPECT_EQ(outcome.without_result, 0U);
  EXPECT_TRUE(outcome.failures.empty());
  publish(at("a"));
  EXPECT_EQ(content(at("a") / "trials.csv"), run(sweep, "b"));
  EXPECT_TRUE(each_once("a"));
}

// Trials that take no time; what one of them does is up to the test.
std::function<std::string(const Sweep&, std::uint64_t)> poisoned(
    std::uint64_t bad, const std::function<void()>& poison) {
  return [=](const Sweep& sweep, std::uint64_t k) {
    if (k == bad) poison();
    return row_without_result(sweep, k, Outcome::walked, "quick");
  };
}

// The poison kills every process that touches it. All others come through, also those that lie far
// beyond the window, also with one job.
TEST_F(Running, IsNotHeldUpByATrialThatKillsItsProcess) {
  const Sweep sweep = slices(10'000);  // 90 000 trials: 1.4 windows
  for (const int jobs : {1, 2}) {
    const std::string name = "jobs" + std::to_string(jobs);
    const RunOutcome outcome = run_shard(
        sweep, {}, at(name), {.jobs = jobs, .row = poisoned(100, [] { kill(getpid(), SIGKILL); })});
    EXPECT_TRUE(outcome.complete());
    EXPECT_EQ(outcome.without_result, 1U);
    EXPECT_EQ(publish(at(name)).without_result, 1U);
    const std::vector<std::string> rows = lines(at(name) / "trials.csv");
    ASSERT_EQ(rows.size(), 90'001U);
    EXPECT_THAT(rows[101], ::testing::StartsWith("100,free,six_feet,ideal,flat,0,"));
    EXPECT_THAT(rows[101], HasSubstr(",failed,the process that ran it was ended by signal 9 ("));
    EXPECT_EQ(std::ranges::count(rows[101], ','), std::ranges::count(rows[0], ','));
    EXPECT_THAT(rows[102], HasSubstr(",walked,quick,"));
  }
  EXPECT_EQ(content(at("jobs1") / "trials.csv"), content(at("jobs2") / "trials.csv"));

  // All is done: the same call does nothing, and still reports the trial without a result.
  const RunOutcome again = run_shard(sweep, {}, at("jobs1"), {});
  EXPECT_EQ(again.before, again.trials);
  EXPECT_EQ(again.without_result, 1U);

  // The poison is gone: its row takes its place, far before the end of the journal.
  const auto healthy = poisoned(num_trials(sweep), [] {});
  const RunOutcome healed = run_shard(sweep, {}, at("jobs1"), {.retry = true, .row = healthy});
  EXPECT_EQ(healed.without_result, 0U);
  publish(at("jobs1"));
  const std::vector<std::string> rows = lines(at("jobs1") / "trials.csv");
  ASSERT_EQ(rows.size(), 90'001U);
  EXPECT_THAT(rows[101], HasSubstr(",walked,quick,"));
}

TEST_F(Running, GivesUpATrialThatTakesTooLong) {
  const Sweep sweep = slices(20);
  const RunOutcome outcome =
      run_shard(sweep, {}, at("a"), {.jobs = 1, .trial_timeout = 0.3, .row = poisoned(7, [] {
                                                                        std::this_thread::sleep_for(
                                                                            std::chrono::hours(1));
                                                                      })});
  EXPECT_TRUE(outcome.complete());
  EXPECT_EQ(outcome.without_result, 1U);
  publish(at("a"));
  EXPECT_THAT(lines(at("a") / "trials.csv")[8], HasSubstr(",timed_out,it took longer"));
  EXPECT_TRUE(children().empty());
}

// A trial whose process was killed for reasons of its own.
std::string killed_seven(const Sweep& sweep, std::uint64_t k) {
  if (k == 7) kill(getpid(), SIGKILL);
  return row(sweep, k);
}

// The row comes out as if nothing had happened; no other line is touched.
TEST_F(Running, RunsATrialWithoutAResultAgain) {
  const Sweep sweep = slices(20);
  EXPECT_EQ(run_shard(sweep, {}, at("a"), {.jobs = 2, .row = killed_seven}).without_result, 1U);
  publish(at("a"));
  const std::string whole = run(sweep, "b");
  EXPECT_NE(content(at("a") / "trials.csv"), whole);
  const std::string journal = content(journal_path(at("a")));
  const RunOutcome idle = run_shard(sweep, {}, at("a"), {});
  EXPECT_EQ(idle.to_retry, 0U) << "only if it is asked for";

  // It may fail again.
  const RunOutcome failed = run_shard(sweep, {}, at("a"), {.retry = true, .row = killed_seven});
  EXPECT_EQ(failed.retried, 1U);
  EXPECT_EQ(failed.without_result, 1U);
  EXPECT_TRUE(failed.complete());

  const RunOutcome again = run_shard(sweep, {}, at("a"), {.retry = true});
  EXPECT_EQ(again.to_retry, 1U);
  EXPECT_EQ(again.retried, 1U);
  EXPECT_EQ(again.without_result, 0U);
  EXPECT_EQ(publish(at("a")).without_result, 0U);
  EXPECT_EQ(content(at("a") / "trials.csv"), whole);
  EXPECT_EQ(content(journal_path(at("a"))), journal);
  merge({at("a")}, at("c"));
  EXPECT_EQ(content(at("c") / "trials.csv"), whole);

  EXPECT_EQ(run_shard(sweep, {}, at("a"), {.retry = true}).to_retry, 0U) << "nothing is left";
}

// Ctrl-C: those that were run again are kept, and the same call goes on with the others. A sweep that
// was not finished is, after them.
TEST_F(Running, GoesOnWithTheTrialsToRunAgain) {
  const Sweep sweep = slices(20);
  const auto odd_fail = [](const Sweep& s, std::uint64_t k) {
    return k % 2 == 1 ? row_without_result(s, k, Outcome::failed, "odd") : row(s, k);
  };
  std::atomic<bool> stop = false;
  RunOptions options{.stop = &stop, .row = odd_fail};
  options.progress = [&](std::uint64_t finished, std::uint64_t) { stop = finished > 20; };
  const RunOutcome first = run_shard(sweep, {}, at("a"), options);
  ASSERT_FALSE(first.complete());

  stop = false;
  RunOptions retry{.stop = &stop, .retry = true};
  retry.progress = [&](std::uint64_t finished, std::uint64_t) { stop = finished >= 2; };
  const RunOutcome second = run_shard(sweep, {}, at("a"), retry);
  EXPECT_EQ(second.to_retry, first.without_result);
  EXPECT_GE(second.retried, 2U);
  EXPECT_LT(second.retried, second.to_retry);
  EXPECT_FALSE(second.complete());

  const RunOutcome third = run_shard(sweep, {}, at("a"), {.retry = true});
  EXPECT_EQ(third.to_retry, second.to_retry - second.retried);
  EXPECT_TRUE(third.complete());
  publish(at("a"));
  EXPECT_EQ(content(at("a") / "trials.csv"), run(sweep, "b"));
  EXPECT_TRUE(each_once("a"));
}

TEST_F(Running, RefusesRetriesOfAnotherSweep) {
  const Sweep sweep = slices(3);
  run(sweep, "a");
  std::ofstream(retries_path(at("a"))) << journal_header("{}");
  EXPECT_THAT(refusal([&] { publish(at("a")); }),
              HasSubstr("retries.txt:1: is of another sweep than the journal"));
}

// What a trial throws is the reason of its row, made fit for a cell; its neighbours have results.
TEST_F(Running, MakesARowOfWhatATrialThrows) {
  Sweep sweep = slices(2);
  sweep.terrains[1].terrain = "swamp";  // load_sweep() would have refused it
  const RunOutcome outcome = run_shard(sweep, {}, at("a"), {});
  EXPECT_TRUE(outcome.complete());
  EXPECT_EQ(outcome.without_result, 6U);
  const std::string row = row_without_result(sweep, 0, Outcome::failed, "no, \"way\"\nout");
  EXPECT_THAT(row, HasSubstr(",failed,no;  way  out,,,,,,,"));
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
  EXPECT_THAT(refused(other, {}), ::testing::AllOf(HasSubstr("limits"), HasSubstr("60")));
  EXPECT_THAT(refused(sweep, {0, 2}), HasSubstr("shard: [1,2] against [1,1]"));
}

TEST_F(Running, RefusesADirectoryThatAnotherProcessWrites) {
  const Journal other(journal_path(at("")));
  EXPECT_THAT(refusal([&] { const Journal journal(journal_path(at(""))); }),
              HasSubstr("another process"));
}

TEST(LockFailure, TellsAHeldFileFromAFileSystemWithoutLocks) {
  EXPECT_THAT(lock_failure(EWOULDBLOCK), HasSubstr("another process"));
  for (const int error : {ENOLCK, ENOTSUP, ENOSYS, EINVAL})
    EXPECT_THAT(lock_failure(error),
                ::testing::AllOf(HasSubstr("can't lock files"), Not(HasSubstr("another process"))));
  EXPECT_THAT(lock_failure(EIO), HasSubstr("Input/output error"));
}

// Rows that another run adds before it lets go of the journal are there when it is read.
TEST_F(Running, ReadsTheJournalWhenItHoldsIt) {
  const Sweep sweep = slices(3);
  const std::string whole = run(sweep, "a");
  const std::string journal = content(journal_path(at("a")));
  const std::size_t half = journal.find('\n', journal.size() / 2) + 1;
  std::filesystem::resize_file(journal_path(at("a")), half);
  std::optional<Journal> other(std::in_place, journal_path(at("a")));
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    std::ofstream(journal_path(at("a")), std::ios::app) << journal.substr(half);
    other.reset();
  });
  const RunOutcome outcome = run_shard(sweep, {}, at("a"), {});
  later.join();
  EXPECT_EQ(outcome.before, outcome.trials);
  EXPECT_EQ(content(journal_path(at("a"))), journal);
}

// A disk that takes bytes and loses them.
TEST_F(Running, TellsThatAJournalDidNotReachTheDisk) {
  Journal journal(journal_path(at("")), [](int) {
    errno = EIO;
    return -1;
  });
  EXPECT_THAT(refusal([&] { journal.resume("{}", 0); }), HasSubstr("did not reach the disk"));
  EXPECT_FALSE(journal.append("a line\n"));  // within a second of the last sync
  EXPECT_THAT(journal.sync().value_or(""), HasSubstr("did not reach the disk"));
  EXPECT_FALSE(journal.sync());  // nothing waits for it
}

// Whatever is refused leaves no directory behind.
TEST_F(Running, LeavesNoDirectoryThatItCantUse) {
  const Sweep sweep = slices(3);
  std::ofstream(at("file")) << "no directory";
  EXPECT_THAT(refusal([&] { static_cast<void>(run_shard(sweep, {}, at("file"), {})); }),
              HasSubstr("can't make the directory"));
  EXPECT_THAT(refusal([&] { static_cast<void>(run_shard(sweep, {}, at("file") / "a" / "b", {})); }),
              HasSubstr("can't make the directory"));
  {
    const MadeDirectory unused(at("c") / "d" / "e");
    EXPECT_TRUE(std::filesystem::is_directory(at("c") / "d" / "e"));
  }
  EXPECT_FALSE(std::filesystem::exists(at("c")));
}

// Older results stand whole when newer ones don't fit on the disk.
TEST_F(Running, PublishesNothingThatIsNotWhole) {
  const Sweep sweep = slices(200);
  run(sweep, "a");
  std::ofstream(at("a") / "trials.csv") << "old\n";
  std::ofstream(at("a") / "manifest.json") << "old\n";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit full = before;
  full.rlim_cur = 20'000;
  setrlimit(RLIMIT_FSIZE, &full);
  EXPECT_THROW(publish(at("a")), std::runtime_error);
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(content(at("a") / "trials.csv"), "old\n");
  EXPECT_EQ(content(at("a") / "manifest.json"), "old\n");
  EXPECT_EQ(std::ranges::distance(std::filesystem::directory_iterator(at("a"))), 4);

  // Where a directory is in the place of a result, that is said before anything is replaced.
  std::filesystem::remove(at("a") / "manifest.json");
  std::filesystem::create_directory(at("a") / "manifest.json");
  EXPECT_THAT(refusal([&] { publish(at("a")); }), HasSubstr("is not a file"));
  EXPECT_EQ(content(at("a") / "trials.csv"), "old\n");
}

TEST_F(Running, LeavesNoProcessBehind) {
  run(slices(5), "a", 3);
  EXPECT_TRUE(children().empty());
}

}  // namespace
}  // namespace hexagait::sweep
