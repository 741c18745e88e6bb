// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <hexagait/sweep/journal.hpp>
#include <hexagait/sweep/run_shard.hpp>
#include <hexagait/sweep/title.hpp>
#include <hexagait/sweep/worker_pool.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::sweep {
namespace {

using std::chrono::milliseconds;

constexpr double kChunkSeconds = 0.05;  // a chunk should take, so that messages cost nothing [s]
constexpr std::uint64_t kMaxChunk = 4096;
constexpr milliseconds kTick{100};      // how often the stop flag is looked at
constexpr milliseconds kFarewell{250};  // what a chunk of quick trials gets to finish when stopped
constexpr std::size_t kMaxRanges = 20, kMaxFailures = 10;

// The journal's line of a trial.
std::string finished_trial(const Sweep& sweep, const Shard& shard, std::uint64_t position) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string text = row(sweep, trial_at(sweep, shard, position));
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  return journal_line(position, fmt::format("{:.6f}", wall.count()), text);
}

// Deals out the positions that are not done, in rising order, each once.
class Dealer {
 public:
  Dealer(DoneWindow done, std::uint64_t whole) : done_(std::move(done)), whole_(whole) {}

  /// The next chunk; its count is 0 if there is none, for now or at all.
  [[nodiscard]] Chunk deal() {
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

  void mark(std::uint64_t position) { done_.mark(position); }
  [[nodiscard]] const DoneWindow& done() const { return done_; }

 private:
  DoneWindow done_;
  std::uint64_t whole_, next_ = 0, size_ = 1;
};

// What the journal has already, if it is of this sweep.
struct Past {
  DoneWindow done;
  std::uint64_t finished = 0, end = 0;
};

Past read_past(const std::filesystem::path& directory, const std::string& title) {
  Past past;
  if (!has_journal(directory)) return past;
  JournalReader reader(directory);
  require_same(title, reader.title(), directory);
  while (const std::optional<Entry> entry = reader.next()) {
    past.done.mark(entry->position);
    ++past.finished;
  }
  past.end = reader.end();
  return past;
}

std::uint64_t first_number(std::string_view line) {
  std::uint64_t value = 0;
  for (std::size_t i = line.find(' ') + 1; i < line.size() && line[i] != ' '; ++i)
    value = 10 * value + static_cast<std::uint64_t>(line[i] - '0');
  return value;
}

// One run of a shard: hands out chunks and puts the answers into the journal.
class Run {
 public:
  Run(const RunOptions& options, WorkerPool& pool, Journal& journal, Dealer& dealer,
      RunOutcome& outcome)
      : options_(options), pool_(pool), journal_(journal), dealer_(dealer), outcome_(outcome) {}

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
      dealer_.finish(answer);
      if (!answer.failure.empty()) fail(answer.failure);
      record(answer.lines);
    }
    if (options_.progress)
      options_.progress(outcome_.finished - outcome_.before, outcome_.trials - outcome_.before);
  }

  void record(std::string_view lines) {
    if (full_ || lines.empty()) return;
    if (const std::optional<std::string> failure = journal_.append(lines)) {
      full_ = true;
      fail("the journal can't be written: " + *failure);
      return;
    }
    for (std::size_t begin = 0; begin < lines.size();) {
      const std::size_t end = lines.find('\n', begin) + 1;
      dealer_.mark(first_number(lines.substr(begin, end - begin)));
      ++outcome_.finished;
      begin = end;
    }
  }

  void fail(const std::string& why) {
    std::vector<std::string>& all = outcome_.failures;
    if (all.size() < kMaxFailures && std::ranges::find(all, why) == all.end()) all.push_back(why);
  }

  const RunOptions& options_;
  WorkerPool& pool_;
  Journal& journal_;
  Dealer& dealer_;
  RunOutcome& outcome_;
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

RunOutcome run_shard(const Sweep& sweep, const Shard& shard, const std::filesystem::path& directory,
                     const RunOptions& options) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    throw InvalidInput(
        fmt::format("can't make the directory '{}': {}", directory.string(), error.message()));
  signal(SIGPIPE, SIG_IGN);  // a worker that died is no reason to die
  signal(SIGXFSZ, SIG_IGN);  // nor is a file that may not grow

  const std::string title = to_title(sweep, shard);
  Past past = read_past(directory, title);
  RunOutcome outcome;
  outcome.trials = num_trials(sweep, shard);
  outcome.before = outcome.finished = past.finished;
  Journal journal(directory, title, past.end);
  Dealer dealer(std::move(past.done), outcome.trials);
  if (!outcome.complete()) {
    WorkerPool pool(options.jobs,
                    [&](std::uint64_t position) { return finished_trial(sweep, shard, position); });
    Run(options, pool, journal, dealer, outcome).to_the_end();
  }
  list_missing(sweep, shard, dealer.done(), outcome);
  return outcome;
}

}  // namespace hexagait::sweep
