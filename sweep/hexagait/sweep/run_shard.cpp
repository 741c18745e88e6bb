// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <deque>
#include <hexagait/sweep/detail/header.hpp>
#include <hexagait/sweep/detail/journal.hpp>
#include <hexagait/sweep/detail/made_directory.hpp>
#include <hexagait/sweep/detail/worker_pool.hpp>
#include <hexagait/sweep/run_shard.hpp>
#include <map>
#include <set>

namespace hexagait::sweep {
namespace {

using std::chrono::milliseconds;

constexpr double kChunkSeconds = 0.05;  // a chunk should take, so that messages cost nothing [s]
constexpr std::uint64_t kMaxChunk = 4096;
constexpr milliseconds kTick{100};      // how often the stop flag is looked at
constexpr milliseconds kFarewell{250};  // what a chunk of quick trials gets to finish when stopped
constexpr std::size_t kMaxRanges = 20;

constexpr int kLives = 2;  // of processes that a trial may take before it is blamed

// The journal's line of a trial.
std::string finished_trial(const Sweep& sweep, const Shard& shard, const RunOptions& options,
                           std::uint64_t position) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string text = options.row(sweep, trial_at(sweep, shard, position));
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  return journal_line(position, fmt::format("{:.6f}", wall.count()), text);
}

// Deals out the positions that are not done: first those that were taken back, then in rising order.
class Dealer {
 public:
  Dealer(DoneWindow done, std::uint64_t whole, const std::set<std::uint64_t>& again)
      : done_(std::move(done)), whole_(whole), again_(again.begin(), again.end()) {}

  /// The next chunk; its count is 0 if there is none, for now or at all.
  [[nodiscard]] Chunk deal() {
    if (!again_.empty()) {
      const Chunk chunk{again_.front(), 1};
      again_.pop_front();
      return chunk;
    }
    next_ = std::max(next_, done_.low());
    const std::uint64_t end = std::min(whole_, done_.low() + kWindow);
    while (next_ < end && done_.done(next_)) ++next_;
    Chunk chunk{.first = next_};
    while (chunk.count < size_ && next_ < end && !done_.done(next_)) {
      ++next_;
      ++chunk.count;
    }
    return chunk;
  }

  void finish(const Answer& answer) {
    // The next chunks shall take kChunkSeconds; they grow gently, since the first trials are slow.
    const double each =
        answer.seconds / static_cast<double>(std::max<std::uint64_t>(answer.chunk.count, 1));
    const double fit = std::clamp(kChunkSeconds / std::max(each, 1e-9), 1.0, double{kMaxChunk});
    size_ = std::min(static_cast<std::uint64_t>(fit), 2 * size_);
  }

  // A chunk that came to nothing: its trials are dealt again, each alone.
  void take_back(const Chunk& chunk) {
    for (std::uint64_t k = 0; k < chunk.count; ++k) again_.push_back(chunk.first + k);
  }

  void mark(std::uint64_t position) { done_.mark(position); }
  [[nodiscard]] const DoneWindow& done() const { return done_; }

 private:
  DoneWindow done_;
  std::uint64_t whole_, next_ = 0, size_ = 1;
  std::deque<std::uint64_t> again_;
};

// What the journal has already, if it is of this sweep.
struct Past {
  DoneWindow done;
  std::uint64_t finished = 0, without_result = 0, end = 0, retries_end = 0;
  std::set<std::uint64_t> to_retry = {};  // positions
};

Past read_past(const std::filesystem::path& directory, const std::string& header, bool retry) {
  Past past;
  if (!has_journal(directory)) return past;
  JournalReader reader(directory);
  require_same(header, reader.header(), directory);
  while (const std::optional<Entry> entry = reader.next()) {
    past.done.mark(entry->position);
    ++past.finished;
    if (!has_no_result(entry->row)) continue;
    ++past.without_result;
    if (retry) past.to_retry.insert(entry->position);
  }
  past.end = reader.end();
  past.retries_end = reader.retries_end();
  return past;
}

// Where the rows of a run go to.
struct Books {
  Journal& journal;
  std::optional<Journal> retries = {};    // of the positions of to_retry
  std::set<std::uint64_t> to_retry = {};  // that are still to be run again
};

// One run of a shard: hands out chunks and puts the answers into the books.
class Run {
 public:
  Run(const Sweep& sweep, const Shard& shard, const RunOptions& options, WorkerPool& pool,
      Books& books, Dealer& dealer, RunOutcome& outcome)
      : sweep_(sweep),
        shard_(shard),
        options_(options),
        pool_(pool),
        books_(books),
        dealer_(dealer),
        outcome_(outcome) {}

  void to_the_end() {
    deal();
    while (pool_.busy() > 0 && !stopped()) {
      collect(kTick);
      deal();
    }
    // Quick trials are let finish; slow ones are lost, as they would be later.
    const auto deadline = std::chrono::steady_clock::now() + kFarewell;
    while (pool_.busy() > 0 && !full_ && std::chrono::steady_clock::now() < deadline)
      collect(milliseconds(20));
    refuse(books_.journal, books_.journal.sync());
    if (books_.retries) refuse(*books_.retries, books_.retries->sync());
  }

 private:
  [[nodiscard]] bool stopped() const {
    return full_ || (options_.stop != nullptr && options_.stop->load());
  }

  void deal() {
    while (pool_.idle() > 0 && !stopped()) {
      const Chunk chunk = dealer_.deal();
      if (chunk.count == 0) return;
      pool_.assign(chunk);
    }
  }

  void collect(milliseconds patience) {
    for (const Answer& answer : pool_.wait(patience)) {
      if (answer.end != Answer::End::finished) {
        judge(answer);
        continue;
      }
      dealer_.finish(answer);
      record(answer.lines, answer.chunk.first);
    }
    refuse(books_.journal, books_.journal.sync_if_due());
    if (books_.retries) refuse(*books_.retries, books_.retries->sync_if_due());
    if (options_.progress)
      options_.progress(outcome_.finished - outcome_.before + outcome_.retried,
                        outcome_.trials - outcome_.before + outcome_.to_retry);
  }

  // Which trial of a chunk is to blame, is seen when each is run alone.
  void judge(const Answer& answer) {
    const std::uint64_t position = answer.chunk.first;
    const bool overdue = answer.end == Answer::End::overdue;
    if (answer.chunk.count > 1 || (!overdue && ++deaths_[position] < kLives)) {
      dealer_.take_back(answer.chunk);
      return;
    }
    const std::string row = row_without_result(
        sweep_, trial_at(sweep_, shard_, position), overdue ? Outcome::timed_out : Outcome::failed,
        overdue ? "it took longer than a trial may" : answer.reason);
    record(journal_line(position, fmt::format("{:.6f}", answer.seconds), row), position);
  }

  // Lines of successive positions.
  void record(std::string_view lines, std::uint64_t position) {
    if (full_ || lines.empty()) return;
    if (books_.to_retry.erase(position) > 0) {
      record_again(lines);
      return;
    }
    refuse(books_.journal, books_.journal.append(lines));
    while (!full_ && !lines.empty()) {
      const std::string_view line = lines.substr(0, lines.find('\n') + 1);
      lines.remove_prefix(line.size());
      dealer_.mark(position++);
      ++outcome_.finished;
      outcome_.without_result += has_no_result(line) ? 1 : 0;
    }
  }

  // The line of a trial that had no result.
  void record_again(std::string_view line) {
    refuse(*books_.retries, books_.retries->append(line));
    if (full_) return;
    ++outcome_.retried;
    outcome_.without_result -= has_no_result(line) ? 0 : 1;
  }

  void refuse(const Journal& journal, const std::optional<std::string>& failure) {
    if (!failure || full_) return;
    full_ = outcome_.disk_failed = true;
    outcome_.failures.push_back("the journal can't be written: " + journal.path().string() + ": " +
                                *failure);
  }

  const Sweep& sweep_;
  const Shard& shard_;
  const RunOptions& options_;
  WorkerPool& pool_;
  Books& books_;
  Dealer& dealer_;
  RunOutcome& outcome_;
  std::map<std::uint64_t, int> deaths_;  // by position
  bool full_ = false;
};

// Positions that are not done, as ranges of trials.
void list_missing(const Sweep& sweep, const Shard& shard, const DoneWindow& done,
                  RunOutcome& outcome) {
  const auto add = [&](std::uint64_t first, std::uint64_t end) {
    if (outcome.missing.size() == kMaxRanges)
      ++outcome.further_missing;
    else
      outcome.missing.push_back({trial_at(sweep, shard, first), trial_at(sweep, shard, end - 1)});
  };
  const std::uint64_t horizon = std::min(outcome.trials, done.low() + kWindow);
  std::uint64_t first = done.low();
  for (std::uint64_t position = first; position < horizon; ++position) {
    if (!done.done(position)) continue;
    if (first < position) add(first, position);
    first = position + 1;
  }
  if (first < outcome.trials) add(first, outcome.trials);
}

}  // namespace

double default_time_limit(const Sweep& sweep) {
  constexpr double kSlice = 1e-4;  // [s]
  const double simulated =
      sweep.engine == Engine::slice ? kSlice * sweep.limits.slices : sweep.limits.seconds;
  return 60.0 + 10.0 * simulated;
}

RunOutcome run_shard(const Sweep& sweep, const Shard& shard, const std::filesystem::path& directory,
                     const RunOptions& options) {
  signal(SIGPIPE, SIG_IGN);  // a worker that died is no reason to die
  signal(SIGXFSZ, SIG_IGN);  // nor is a file that may not grow

  const std::string header = to_header(sweep, shard);
  MadeDirectory made(directory);
  Journal journal(journal_path(directory));
  Past past = read_past(directory, header, options.retry);
  journal.resume(header, past.end);
  made.keep();
  Books books{.journal = journal, .to_retry = std::move(past.to_retry)};
  if (!books.to_retry.empty()) {
    books.retries.emplace(retries_path(directory));
    books.retries->resume(header, past.retries_end);
  }

  RunOutcome outcome;
  outcome.trials = num_trials(sweep, shard);
  outcome.before = outcome.finished = past.finished;
  outcome.without_result = past.without_result;
  outcome.to_retry = books.to_retry.size();
  Dealer dealer(std::move(past.done), outcome.trials, books.to_retry);
  if (!outcome.complete()) {
    WorkerPool pool(
        options.jobs,
        [&](std::uint64_t position) { return finished_trial(sweep, shard, options, position); },
        options.trial_timeout > 0.0 ? options.trial_timeout : default_time_limit(sweep));
    Run(sweep, shard, options, pool, books, dealer, outcome).to_the_end();
  }
  list_missing(sweep, shard, dealer.done(), outcome);
  return outcome;
}

}  // namespace hexagait::sweep
