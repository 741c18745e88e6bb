// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/figures/csv.hpp>
#include <hexagait/figures/figure.hpp>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/sweep/report.gp.hpp>
#include <hexagait/sweep/report.hpp>
#include <set>

namespace hexagait::sweep {
namespace {

using Words = std::vector<std::string>;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string kind(const std::string& terrain) { return terrain.substr(0, terrain.find(':')); }

// Whether all terrains are of one kind, which is drawn over its roughness; flat belongs to any.
bool one_kind(const Report& report) {
  std::set<std::string> kinds;
  std::set<double> values;
  for (const ReportLine& line : report.lines) {
    if (kind(line.terrain) != "flat") kinds.insert(kind(line.terrain));
    values.insert(line.roughness);
  }
  return kinds.size() == 1 && values.size() > 1;
}

// The place of a word in a list, to which it is added if it is new.
std::size_t place(Words& words, const std::string& word) {
  auto found = std::ranges::find(words, word);
  if (found == words.end()) found = words.insert(found, word);
  return static_cast<std::size_t>(found - words.begin());
}

struct Sheet {
  figures::Csv csv{
      "curve,x,robot,plant,terrain,roughness,controller,trials,count,sd,mean,ci95_lower,ci95_upper,"
      "difference,difference_ci95_lower,difference_ci95_upper"};
  Words curves, terrains;
};

Sheet sheet(const Report& report, bool over_roughness) {
  Sheet result;
  // A curve has the name of what differs.
  const auto varies = [&](std::string ReportLine::*name) {
    return std::ranges::any_of(
        report.lines, [&](const ReportLine& line) { return line.*name != report.lines[0].*name; });
  };
  const bool robots = varies(&ReportLine::robot), plants = varies(&ReportLine::plant);
  const auto curve_of = [&](const ReportLine& line) {
    return (robots ? line.robot + ", " : "") + (plants ? line.plant + ", " : "") + line.controller;
  };
  struct Point {
    std::size_t curve;
    double x;
    const ReportLine* line;
  };
  std::vector<Point> points;
  for (const ReportLine& line : report.lines) {
    const std::size_t terrain = place(result.terrains, line.terrain);
    points.push_back({place(result.curves, curve_of(line)),
                      over_roughness ? line.roughness : static_cast<double>(terrain), &line});
  }
  std::ranges::stable_sort(points, {}, [](const Point& p) { return std::pair(p.curve, p.x); });
  // The interval of a single trial is infinite: none is drawn.
  const auto bound = [](double limit, double value) {
    return std::isfinite(limit) ? limit : value;
  };
  for (const auto& [curve, x, line] : points) {
    const Measured m = line->value.value_or(Measured{0, kNone, kNone, kNone});
    const statistics::Difference d = line->difference ? line->difference->difference
                                                      : statistics::Difference{kNone, kNone, kNone};
    result.csv.row(curve + 1, x, line->robot, line->plant, line->terrain, line->roughness,
                   line->controller, line->trials(), m.count, m.sd.value_or(kNone), m.value,
                   bound(m.lower, m.value), bound(m.upper, m.value), d.value,
                   bound(d.lower, d.value), bound(d.upper, d.value));
  }
  return result;
}

// By how much each curve is moved sideways, so that their intervals don't cover each other.
std::vector<double> shifts(const Report& report, std::size_t curves, bool over_roughness) {
  const auto [least, greatest] = std::ranges::minmax_element(
      report.lines, {}, [](const ReportLine& line) { return line.roughness; });
  const double width = over_roughness ? (greatest->roughness - least->roughness) / 240.0
                                      : 0.5 / static_cast<double>(curves);
  std::vector<double> result;
  for (std::size_t i = 0; i < curves; ++i)
    result.push_back((static_cast<double>(i) - 0.5 * static_cast<double>(curves - 1)) * width);
  return result;
}

std::string capital(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace

std::string report_stem(const Report& report) {
  std::string stem = "report-" + report.measure.name;
  if (report.compare != Compare::controllers) stem += fmt::format("-{}", to_string(report.compare));
  return report.all_trials ? stem + "-all_trials" : stem;
}

std::string usual_headline(const Report& report) {
  return capital(report.measure.label) + " by controller and terrain";
}

void draw(const Report& report, const std::string& headline) {
  figures::require_gnuplot();
  const bool over_roughness = one_kind(report);
  const Sheet drawn = sheet(report, over_roughness);
  const Column& m = report.measure;
  const std::string subtitle =
      m.yes_no            ? "share of the trials, 95 % confidence interval after Wilson"
      : report.all_trials ? "mean of all trials, 95 % confidence interval"
                          : "mean of the trials that walked on, 95 % confidence interval";
  const std::string stem = report_stem(report);
  figures::StagedFiles files(report.directory);
  files.write(stem + ".csv", drawn.csv.text());
  figures::draw_figure(
      files,
      {.stem = stem,
       .headline = headline,
       .subtitle = headline.empty() ? "" : subtitle,
       .width = 1200,
       .height = 750},
      {{"csv", stem + ".csv"},
       {"curves", drawn.curves},
       {"shift", shifts(report, drawn.curves.size(), over_roughness)},
       {"x_label", report.roughness_label},
       {"y_label", m.unit.empty() ? m.label : fmt::format("{} [{}]", m.label, m.unit)},
       {"over_roughness", over_roughness ? 1 : 0},
       {"terrains", drawn.terrains},
       {"y_from", 0},
       {"y_to", m.yes_no ? 1 : 0}},
      scripts::sweep::report);
  files.publish();
}

}  // namespace hexagait::sweep
