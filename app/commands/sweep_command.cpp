// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/sweep_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <hexagait/sweep/job_files.hpp>
#include <hexagait/sweep/report.hpp>
#include <hexagait/sweep/results.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/parse_number.hpp>
#include <optional>
#include <thread>

#include "commands/commands.hpp"
#include "options/arguments.hpp"
#include "options/robot_options.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"
#include "terminal/progress.hpp"

namespace hexagait::app {
namespace {

namespace fs = std::filesystem;
using sweep::Published;
using sweep::RunOutcome;
using sweep::Shard;
using sweep::Sweep;

// A whole number of 1 … greatest.
std::uint64_t whole(const char* option, std::string_view text, std::uint64_t greatest) {
  const auto value = parse_number<std::uint64_t>(text);
  if (value && 1 <= *value && *value <= greatest) return *value;
  throw InvalidInput(
      fmt::format("{} is '{}'; it must be a whole number from 1 to {}", option, text, greatest));
}

constexpr std::uint64_t kMaxJobs = 1024, kMaxShards = 1'000'000;
constexpr double kLong = 3.0 * 86400.0;  // a sweep that takes longer wants --yes [s]

// 0 if none was given.
double trial_timeout(const std::string& text) {
  if (text.empty()) return 0.0;
  const auto value = parse_number<double>(text);
  if (value && 0.001 <= *value && *value <= 1e7) return *value;
  throw InvalidInput(fmt::format(
      "--trial-timeout is '{}'; it must be a time from 0.001 to 10000000 seconds", text));
}

// The message of robot_file() is about an option.
std::string find_robot(const std::string& name) {
  try {
    return robot_file(name);
  } catch (const InvalidInput& error) {
    const std::string_view text = error.what();
    throw InvalidInput(std::string(text.substr(text.starts_with("--") ? 2 : 0)));
  }
}

sweep::Compare comparison(const std::string& text) {
  for (const sweep::Compare known : sweep::kComparisons)
    if (text == to_string(known)) return known;
  throw InvalidInput(
      fmt::format("--compare is '{}'; it must be controllers, terrains, robots or plants", text));
}

int emit(const SweepArguments& arguments) {
  const sweep::Scheduler scheduler = sweep::parse_scheduler(arguments.emit);
  if (arguments.shards.empty())
    throw InvalidInput("--emit needs --shards N: into how many jobs the sweep is cut");
  if (!arguments.shard.empty()) throw InvalidInput("--emit and --shard exclude each other");
  if (arguments.retry) throw InvalidInput("--emit and --retry exclude each other");
  const std::string start =
      write_job_files(scheduler,
                      {.program = fs::read_symlink("/proc/self/exe"),
                       .sweep = fs::absolute(arguments.file),
                       .folder = fs::current_path(),
                       .shards = whole("--shards", arguments.shards, kMaxShards),
                       .jobs = jobs(arguments.jobs, 1),
                       .trial_timeout = trial_timeout(arguments.trial_timeout)},
                      arguments.out);
  print_out(fmt::format("Job files are written; {} starts them, and the result will be in {}.\n",
                        start, (fs::path(arguments.out) / "merged").string()));
  return kOk;
}

std::vector<std::string> ranges(const RunOutcome& outcome) {
  std::vector<std::string> words;
  for (const sweep::TrialRange& range : outcome.missing)
    words.push_back(range.first == range.last ? fmt::format("{}", range.first)
                                              : fmt::format("{}-{}", range.first, range.last));
  if (outcome.further_missing > 0)
    words.push_back(fmt::format("and {} more ranges", outcome.further_missing));
  return words;
}

void tell_missing(const RunOutcome& outcome, const Shard& shard) {
  for (const std::string& failure : outcome.failures) fmt::print(stderr, "hexagait: {}\n", failure);
  if (outcome.retried < outcome.to_retry)
    fmt::print(stderr, "hexagait: {} of {} trials without a result have been run again\n",
               outcome.retried, outcome.to_retry);
  if (outcome.finished == outcome.trials) return;
  fmt::print(stderr,
             "hexagait: {} of {} trials are finished and kept; missing{}: {}\nThe same command "
             "again goes on with them.\n",
             outcome.finished, outcome.trials,
             shard.count > 1 ? fmt::format(" of shard {}/{}", shard.index + 1, shard.count) : "",
             fmt::join(ranges(outcome), ", "));
}

std::string as_json(const RunOutcome& outcome, const std::optional<Published>& published) {
  std::vector<std::string> missing;
  for (const std::string& range : ranges(outcome)) missing.push_back('"' + range + '"');
  return fmt::format(
      "{{\"trials\": {}, \"finished\": {}, \"finished_before\": {}, \"complete\": {}, "
      "\"without_result\": {}, \"retried\": {}, \"missing\": [{}], \"rows_hash\": {}}}\n",
      outcome.trials, outcome.finished, outcome.before, outcome.complete(), outcome.without_result,
      outcome.retried, fmt::join(missing, ", "),
      published ? fmt::format("\"{:016x}\"", published->rows_hash) : "null");
}

void tell(const Published& published, const fs::path& directory) {
  print_out(fmt::format("{} trials: {}, hash {:016x}\n", published.trials,
                        (directory / "trials.csv").string(), published.rows_hash));
}

// Whether a sweep goes on for so long that its user may not have meant it: known from its first
// seconds, or trials if those are slow.
class Patience {
 public:
  Patience(int jobs, bool endless)
      : enough_(static_cast<std::uint64_t>(2 * jobs)), endless_(endless), start_(Clock::now()) {}

  // Time that is left, if it is too long.
  [[nodiscard]] std::optional<double> exceeded(std::uint64_t finished, std::uint64_t whole) const {
    const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
    if (endless_ || wall < kTrial || finished < enough_) return {};
    const double left =
        wall / static_cast<double>(finished) * static_cast<double>(whole - finished);
    return left > kLong ? std::optional(left) : std::nullopt;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kTrial = 2.0;  // [s]
  std::uint64_t enough_;
  bool endless_;
  Clock::time_point start_;
};

RunOutcome run(const Sweep& sweep, const Shard& shard, const SweepArguments& arguments,
               const std::atomic<bool>& interrupted) {
  if (!arguments.quiet)
    for (const sweep::Robot& robot : sweep.robots) tell_substitutions(robot.name, robot.model);
  const int processes = jobs(arguments.jobs, cores());
  const Patience patience(processes, arguments.yes);
  std::optional<double> too_long;
  std::atomic<bool> stop = false;
  std::optional<Progress> progress;
  const auto tell = [&](std::uint64_t finished, std::uint64_t whole) {
    if (!progress)
      progress.emplace(static_cast<double>(whole), Progress::Measure::trials, arguments.quiet);
    progress->at(static_cast<double>(finished));
    if (!too_long) too_long = patience.exceeded(finished, whole);
    stop = interrupted || too_long;
  };
  RunOutcome outcome = run_shard(sweep, shard, arguments.out,
                                 {.jobs = processes,
                                  .stop = &stop,
                                  .trial_timeout = trial_timeout(arguments.trial_timeout),
                                  .retry = arguments.retry,
                                  .progress = tell});
  progress.reset();
  if (too_long)
    throw InvalidInput(
        fmt::format("{} trials on {} processes would take {}; {} are finished and kept. Add --yes "
                    "to go on with "
                    "them all, or share them between machines by --shard or --emit",
                    outcome.trials, processes, duration(*too_long), outcome.finished));
  return outcome;
}

// Trials without a result are results of the sweep, but nobody should overlook them.
void tell_without_result(std::uint64_t number, const fs::path& directory) {
  if (number == 0) return;
  fmt::print(stderr, "hexagait: {} trial{} no result, see the columns outcome and reason of {}\n",
             number, number == 1 ? " has" : "s have", (directory / "trials.csv").string());
}

}  // namespace

int jobs(const std::string& text, unsigned otherwise) {
  return static_cast<int>(text.empty() ? otherwise : whole("--jobs", text, kMaxJobs));
}

unsigned cores() { return std::max(1U, std::thread::hardware_concurrency()); }

Shard shard(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos)
    throw InvalidInput(fmt::format("--shard is '{}'; write 2/8 for the second of eight", text));
  const std::uint64_t count =
      whole("the number of shards", std::string_view(text).substr(slash + 1), kMaxShards);
  return {whole("--shard", std::string_view(text).substr(0, slash), count) - 1, count};
}

int sweep_command(const SweepArguments& arguments) {
  const Sweep sweep = sweep::load_sweep(arguments.file, find_robot);
  if (!arguments.emit.empty()) return emit(arguments);
  if (!arguments.shards.empty())
    throw InvalidInput("--shards goes with --emit; one shard is chosen by --shard k/n");
  const Shard part = shard(arguments.shard);

  const std::atomic<bool>& interrupted = watch_interrupts();
  const RunOutcome outcome = run(sweep, part, arguments, interrupted);
  std::optional<Published> published;
  if (outcome.complete()) published = sweep::publish(arguments.out);
  if (arguments.json)
    print_out(as_json(outcome, published));
  else if (published)
    tell(*published, arguments.out);
  if (published) {
    tell_without_result(outcome.without_result, arguments.out);
    return kOk;
  }
  tell_missing(outcome, part);
  if (outcome.disk_failed) return kBadInput;
  return interrupted ? kInterrupted : kFailed;
}

int report_command(const ReportArguments& arguments) {
  std::vector<std::string> measures = arguments.measures;
  if (measures.empty()) measures.emplace_back();
  std::vector<sweep::Report> reports;
  reports.reserve(measures.size());
  for (const std::string& measure : measures)
    reports.push_back(
        sweep::make_report(arguments.directory, {.measure = measure,
                                                 .compare = comparison(arguments.compare),
                                                 .all_trials = arguments.all_trials}));
  if (arguments.json) {
    std::vector<std::string> texts;
    texts.reserve(reports.size());
    for (const sweep::Report& report : reports) texts.push_back(to_json(report));
    const std::string all = fmt::format("{}", fmt::join(texts, ",\n"));
    print_out(fmt::format("{}\n", texts.size() == 1 ? all : "[" + all + "]"));
    return kOk;
  }
  // The table first: it is worth having where there is no gnuplot.
  for (const sweep::Report& report : reports) print_out(in_words(report));
  for (const sweep::Report& report : reports) {
    const std::string title = arguments.title.empty() ? usual_headline(report) : arguments.title;
    draw(report, title == "none" ? "" : title);
    print_out(fmt::format(
        "Drawn: {}\n", (fs::path(arguments.directory) / (report_stem(report) + ".svg")).string()));
  }
  return kOk;
}

int merge_command(const MergeArguments& arguments) {
  const Published published =
      sweep::merge({arguments.parts.begin(), arguments.parts.end()}, arguments.out);
  if (arguments.json)
    print_out(
        fmt::format("{{\"trials\": {}, \"without_result\": {}, \"rows_hash\": \"{:016x}\"}}\n",
                    published.trials, published.without_result, published.rows_hash));
  else
    tell(published, arguments.out);
  tell_without_result(published.without_result, arguments.out);
  return kOk;
}

}  // namespace hexagait::app