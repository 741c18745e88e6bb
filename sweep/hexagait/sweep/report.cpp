// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <hexagait/sweep/detail/header.hpp>
#include <hexagait/sweep/detail/journal.hpp>
#include <hexagait/sweep/report.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/parse_number.hpp>
#include <hexagait/text/split.hpp>
#include <map>
#include <numeric>

namespace hexagait::sweep {
namespace {

using Words = std::vector<std::string>;

struct Trial {
  std::uint64_t seed;
  double value;  // NaN if it has none, or does not count
};

// Trials that share robot, plant, terrain and controller, by seed.
struct Group {
  ReportLine line;
  std::vector<Trial> trials = {};
};

// trials.csv, row by row.
class TrialRows {
 public:
  TrialRows(const std::filesystem::path& directory, const Column& measure, bool all_trials)
      : path_((directory / "trials.csv").string()),
        file_(path_),
        measure_(measure),
        all_trials_(all_trials || measure.yes_no) {
    if (!std::getline(file_, text_))
      throw InvalidInput(fmt::format(
          "'{}' has no trials.csv: the sweep is not finished; the command that began it goes on "
          "with it",
          directory.string()));
    const std::vector<std::string_view> columns = split(text_, ',');
    num_columns_ = columns.size();
    const std::array<std::string_view, kNumFields> names = {
        "robot", "plant", "terrain", "controller", "roughness", "seed", "outcome", measure.name};
    for (std::size_t field = 0; field < kNumFields; ++field) {
      const auto found = std::ranges::find(columns, names[field]);
      if (found == columns.end()) refuse(fmt::format("there is no column '{}'", names[field]));
      places_[field] = static_cast<std::size_t>(found - columns.begin());
    }
  }

  // In the order in which they first appear.
  [[nodiscard]] std::vector<Group> groups() {
    while (std::getline(file_, text_)) {
      ++line_;
      row_ = split(text_, ',');
      if (row_.size() != num_columns_)
        refuse(fmt::format("has {} cells, the header {}", row_.size(), num_columns_));
      add();
    }
    if (groups_.empty()) throw InvalidInput(fmt::format("{}: has no trials", path_));
    for (Group& group : groups_) {
      std::ranges::stable_sort(group.trials, {}, &Trial::seed);
      const auto twice = std::ranges::adjacent_find(group.trials, {}, &Trial::seed);
      if (twice != group.trials.end())
        throw InvalidInput(
            fmt::format("{}: '{}' with '{}', '{}' on '{}' and seed {} is there twice", path_,
                        group.line.controller, group.line.robot, group.line.plant,
                        group.line.terrain, twice->seed));
    }
    return std::move(groups_);
  }

 private:
  enum Field : std::size_t { robot, plant, terrain, controller, roughness, seed, outcome, measure };
  static constexpr std::size_t kNumFields = 8;

  [[noreturn]] void refuse(const std::string& why) const {
    throw InvalidInput(fmt::format("{}:{}: {}", path_, line_, why));
  }

  [[nodiscard]] std::string_view cell(Field field) const { return row_[places_[field]]; }

  template <class Number>
  [[nodiscard]] Number number(Field field, std::string_view name) const {
    if (const std::optional<Number> value = parse_number<Number>(cell(field))) return *value;
    refuse(fmt::format("the column '{}' has '{}', which is not a number", name, cell(field)));
  }

  [[nodiscard]] Outcome ended() const {
    for (const Outcome known : kOutcomes)
      if (cell(outcome) == to_string(known)) return known;
    refuse(fmt::format("the column 'outcome' has '{}'", cell(outcome)));
  }

  [[nodiscard]] Group& group() {
    std::array<std::string, 4> key;
    for (const Field field : {robot, plant, terrain, controller}) key[field] = cell(field);
    const auto [found, is_new] = index_.emplace(key, groups_.size());
    if (is_new) {
      ReportLine line;
      line.robot = key[robot];
      line.plant = key[plant];
      line.terrain = key[terrain];
      line.controller = key[controller];
      line.roughness = number<double>(roughness, "roughness");
      groups_.push_back({std::move(line)});
    }
    return groups_[found->second];
  }

  void add() {
    Group& to = group();
    const Outcome end = ended();
    ++to.line.outcomes[static_cast<std::size_t>(end)];
    Trial trial{number<std::uint64_t>(seed, "seed"), std::numeric_limits<double>::quiet_NaN()};
    if (!cell(measure).empty() && (all_trials_ || walked_on(end))) {
      trial.value = number<double>(measure, measure_.name);
      if (measure_.yes_no && trial.value != 0.0 && trial.value != 1.0)
        refuse(
            fmt::format("the column '{}' has {}; it must be 0 or 1", measure_.name, trial.value));
    }
    to.trials.push_back(trial);
  }

  std::string path_, text_;
  std::ifstream file_;
  const Column& measure_;
  bool all_trials_;
  std::size_t num_columns_ = 0;
  std::array<std::size_t, kNumFields> places_{};
  std::vector<std::string_view> row_;
  std::uint64_t line_ = 1;
  std::vector<Group> groups_;
  std::map<std::array<std::string, 4>, std::size_t> index_;
};

std::vector<double> values_of(const Group& group) {
  std::vector<double> values;
  for (const Trial& trial : group.trials)
    if (!std::isnan(trial.value)) values.push_back(trial.value);
  return values;
}

statistics::Proportion proportion_of(const std::vector<double>& values) {
  return statistics::proportion(static_cast<int>(std::ranges::count(values, 1.0)),
                                static_cast<int>(values.size()));
}

std::optional<Measured> measured(const Group& group, bool yes_no) {
  const std::vector<double> values = values_of(group);
  if (values.empty()) return {};
  if (yes_no) {
    const statistics::Proportion p = proportion_of(values);
    return Measured{p.trials, p.share(), p.lower, p.upper};
  }
  const statistics::Estimate e = statistics::estimate(values);
  return Measured{e.count, e.mean, e.lower(), e.upper(), e.sd};
}

std::optional<Compared> compared(const Group& group, const Group& first, const Report& report) {
  std::vector<double> a, b;
  if (report.paired) {
    for (const Trial& trial : group.trials) {
      const auto other = std::ranges::lower_bound(first.trials, trial.seed, {}, &Trial::seed);
      if (other == first.trials.end() || other->seed != trial.seed) continue;
      if (std::isnan(trial.value) || std::isnan(other->value)) continue;
      a.push_back(trial.value);
      b.push_back(other->value);
    }
  } else {
    a = values_of(group);
    b = values_of(first);
  }
  if (a.empty() || b.empty()) return {};
  Compared result;
  result.count = static_cast<int>(std::min(a.size(), b.size()));
  if (report.measure.yes_no) {
    result.difference = statistics::difference(proportion_of(a), proportion_of(b));
    return result;
  }
  if (report.paired) {
    const statistics::Estimate d = statistics::paired_difference(a, b);
    result.difference = {d.mean, d.lower(), d.upper()};
  } else {
    result.difference = statistics::unpaired_difference(a, b);
  }
  const double mean = statistics::estimate(b).mean;
  if (mean != 0.0) result.percent = 100.0 * result.difference.value / std::abs(mean);
  return result;
}

// What a comparison is of, in the order of Compare.
constexpr std::array kCompared = {&ReportLine::controller, &ReportLine::terrain, &ReportLine::robot,
                                  &ReportLine::plant};

Column measure_of(const Header& header, const std::string& asked,
                  const std::filesystem::path& directory) {
  const std::string& name = asked.empty() ? header.measure : asked;
  Words numbers;
  for (const Column& column : columns(header.engine)) {
    if (column.name == "hash") continue;
    if (column.name == name) return column;
    numbers.push_back(column.name);
  }
  if (name == "hash")
    throw InvalidInput("--measure is 'hash', which is not a number that can be averaged");
  throw InvalidInput(
      fmt::format("--measure is '{}', which is no column of numbers in '{}'{}; it has {}", name,
                  directory.string(), did_you_mean(name, numbers), fmt::join(numbers, ", ")));
}

}  // namespace

std::string_view to_string(Compare compare) {
  constexpr std::array<std::string_view, kComparisons.size()> kNames = {"controllers", "terrains",
                                                                        "robots", "plants"};
  return kNames[static_cast<std::size_t>(compare)];
}

int ReportLine::trials() const { return std::accumulate(outcomes.begin(), outcomes.end(), 0); }

Report make_report(const std::filesystem::path& directory, const ReportOptions& options) {
  const Header header =
      parse_header(JournalReader(directory).header(), journal_path(directory).string());
  Report report{.directory = directory.string(),
                .measure = measure_of(header, options.measure, directory),
                .roughness_label = std::string(roughness_label(header.engine)),
                .compare = options.compare,
                .first = {},
                .paired = options.compare != Compare::terrains,
                .all_trials = options.all_trials,
                .lines = {}};
  std::vector<Group> groups = TrialRows(directory, report.measure, report.all_trials).groups();
  const auto compared_name = kCompared[static_cast<std::size_t>(report.compare)];
  report.first = groups.front().line.*compared_name;

  // Whether a group is compared with `first`: the same in all but what is compared.
  const auto is_peer = [&](const Group& first, const Group& group) {
    return &first != &group && first.line.*compared_name == report.first &&
           std::ranges::all_of(kCompared, [&](const auto name) {
             return name == compared_name || first.line.*name == group.line.*name;
           });
  };
  for (Group& group : groups) {
    group.line.value = measured(group, report.measure.yes_no);
    for (const Group& first : groups)
      if (is_peer(first, group)) group.line.difference = compared(group, first, report);
  }
  for (Group& group : groups) report.lines.push_back(std::move(group.line));
  return report;
}

}  // namespace hexagait::sweep
