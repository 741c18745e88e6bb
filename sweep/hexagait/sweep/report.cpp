// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <hexagait/sweep/header.hpp>
#include <hexagait/sweep/journal.hpp>
#include <hexagait/sweep/report.hpp>
#include <hexagait/sweep/spelling.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <nlohmann/json.hpp>

namespace hexagait::sweep {
namespace {

using nlohmann::ordered_json;
using statistics::Estimate;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Columns that every trials.csv has in front.
enum Cell : std::size_t { trial, controller, robot, terrain, roughness, seed, first_measure = 8 };

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

// Nothing for an empty cell. @throws InvalidInput
double number(const std::string& cell, const std::string& column) {
  if (cell.empty()) return kNone;
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error == std::errc() && end == cell.data() + cell.size()) return value;
  throw InvalidInput(fmt::format("the column '{}' has '{}', which is not a number", column, cell));
}

std::optional<statistics::Estimate> estimate_of(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional(statistics::estimate(values));
}

// The values of the controllers on one terrain, by seed; NaN for none.
struct Place {
  std::string robot, terrain;
  double roughness = 0.0;
  std::vector<std::vector<double>> values;  // by controller, then seed
};

ReportLine line(const Place& place, std::size_t c, const std::string& controller) {
  ReportLine result{place.robot, place.terrain, controller, place.roughness, {}, {}, {}};
  const std::vector<double>&own = place.values[c], &others = place.values[0];
  result.trials = static_cast<int>(own.size());
  std::vector<double> values, a, b;
  for (std::size_t k = 0; k < own.size(); ++k) {
    if (std::isnan(own[k])) continue;
    values.push_back(own[k]);
    if (std::isnan(others[k])) continue;
    a.push_back(own[k]);
    b.push_back(others[k]);
  }
  result.value = estimate_of(values);
  if (c > 0 && !a.empty()) result.difference = statistics::paired_difference(a, b);
  return result;
}

// The rows of trials.csv, in which controllers vary fastest, then seeds, then terrains.
class Table {
 public:
  explicit Table(std::size_t measure) : measure_(measure) {}

  void add(const std::vector<std::string>& row, const std::string& column) {
    if (places_.empty() || places_.back().robot != row[robot] ||
        places_.back().terrain != row[terrain])
      places_.push_back({row[robot], row[terrain], number(row[roughness], "roughness"), {}});
    auto found = std::ranges::find(controllers_, row[controller]);
    if (found == controllers_.end()) found = controllers_.insert(found, row[controller]);
    const auto c = static_cast<std::size_t>(found - controllers_.begin());
    Place& place = places_.back();
    place.values.resize(std::max(place.values.size(), c + 1));
    place.values[c].push_back(number(row[measure_], column));
  }

  [[nodiscard]] std::vector<ReportLine> lines() const {
    std::vector<ReportLine> result;
    for (const Place& place : places_)
      for (std::size_t c = 0; c < place.values.size(); ++c)
        result.push_back(line(place, c, controllers_[c]));
    return result;
  }

  [[nodiscard]] const std::string& first() const { return controllers_.front(); }

 private:
  std::size_t measure_;
  std::vector<std::string> controllers_;
  std::vector<Place> places_;
};

std::string cell(const std::optional<statistics::Estimate>& estimate) {
  if (!estimate) return "none";
  return std::isinf(estimate->half_width)
             ? fmt::format("{:.5g}", estimate->mean)
             : fmt::format("{:.5g} ± {:.2g}", estimate->mean, estimate->half_width);
}

ordered_json json(const std::optional<statistics::Estimate>& estimate) {
  if (!estimate) return nullptr;
  const auto finite = [](double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
  };
  return {{"count", estimate->count},
          {"mean", estimate->mean},
          {"sd", estimate->sd},
          {"ci95", {finite(estimate->lower()), finite(estimate->upper())}}};
}

}  // namespace

Report make_report(const std::filesystem::path& directory, const std::string& measure) {
  const Header header =
      parse_header(JournalReader(directory).header(), journal_path(directory).string());
  std::ifstream file(directory / "trials.csv");
  std::string text;
  if (!std::getline(file, text))
    throw InvalidInput(
        fmt::format("'{}' has no trials.csv: the sweep is not finished; the command that began it "
                    "goes on with it",
                    directory.string()));

  Report report{directory.string(), measure.empty() ? header.measure : measure, {}, {}};
  const std::vector<std::string> columns = split(text);
  const auto column = std::ranges::find(columns, report.measure);
  if (column == columns.end())
    throw InvalidInput(
        fmt::format("--measure is '{}', which is no column{}", report.measure,
                    suggestion(report.measure, {columns.begin() + first_measure, columns.end()})));

  Table table(static_cast<std::size_t>(column - columns.begin()));
  while (std::getline(file, text)) {
    const std::vector<std::string> row = split(text);
    if (row.size() != columns.size())
      throw InvalidInput(fmt::format("'{}/trials.csv': a row has {} cells, the header {}",
                                     directory.string(), row.size(), columns.size()));
    table.add(row, report.measure);
  }
  report.lines = table.lines();
  if (report.lines.empty())
    throw InvalidInput(fmt::format("'{}/trials.csv' has no trials", directory.string()));
  report.first = table.first();
  return report;
}

std::string in_words(const Report& report) {
  std::string text = fmt::format(
      "{}: mean ± half of its 95 % confidence interval; differences are paired by seed\n"
      "  {:<14} {:<14} {:<12} {:>9} {:>22} {:>10} {:>22}\n",
      report.measure, "robot", "terrain", "controller", "trials", "mean", "sd",
      "less " + report.first);
  for (const ReportLine& line : report.lines) {
    const int count = line.value ? line.value->count : 0;
    // "±" has two bytes and one column, which fmt knows.
    text += fmt::format(
        "  {:<14} {:<14} {:<12} {:>9} {:>22} {:>10} {:>22}\n", line.robot, line.terrain,
        line.controller,
        count == line.trials ? std::to_string(count) : fmt::format("{}/{}", count, line.trials),
        cell(line.value), line.value ? fmt::format("{:.3g}", line.value->sd) : "",
        line.controller == report.first ? "" : cell(line.difference));
  }
  return text;
}

std::string to_json(const Report& report) {
  ordered_json result = {{"measure", report.measure}, {"compared_with", report.first}};
  for (const ReportLine& line : report.lines)
    result["lines"].push_back({{"robot", line.robot},
                               {"terrain", line.terrain},
                               {"roughness", line.roughness},
                               {"controller", line.controller},
                               {"trials", line.trials},
                               {"value", json(line.value)},
                               {"difference", json(line.difference)}});
  return result.dump(2);
}

}  // namespace hexagait::sweep
