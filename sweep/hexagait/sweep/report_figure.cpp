// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/sweep/report.hpp>
#include <set>

namespace hexagait::sweep {
namespace {

using statistics::Estimate;
using Words = std::vector<std::string>;

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

// A value and the ends of its interval, or three empty cells.
std::string cells(const std::optional<statistics::Estimate>& estimate) {
  if (!estimate) return ",,";
  if (std::isinf(estimate->half_width)) return fmt::format("{0},{0},{0}", estimate->mean);
  return fmt::format("{},{},{}", estimate->mean, estimate->lower(), estimate->upper());
}

// One curve: a robot's controller. Its rows stand together in report.csv.
struct Curve {
  std::string title;
  std::size_t first = 0, last = 0;  // rows
};

struct Sheet {
  std::string csv;
  std::vector<Curve> curves;
  Words terrains;
};

Sheet sheet(const Report& report, bool over_roughness) {
  Sheet result;
  for (const ReportLine& line : report.lines)
    if (std::ranges::find(result.terrains, line.terrain) == result.terrains.end())
      result.terrains.push_back(line.terrain);
  const auto place = [&](const ReportLine& line) {
    if (over_roughness) return line.roughness;
    const auto found = std::ranges::find(result.terrains, line.terrain);
    return static_cast<double>(found - result.terrains.begin());
  };

  const bool robots = std::ranges::any_of(
      report.lines, [&](const ReportLine& line) { return line.robot != report.lines[0].robot; });
  std::vector<const ReportLine*> lines;
  for (const ReportLine& line : report.lines) lines.push_back(&line);
  const auto name = [&](const ReportLine* line) {
    return robots ? line->robot + ", " + line->controller : line->controller;
  };
  Words order;
  for (const ReportLine* line : lines)
    if (std::ranges::find(order, name(line)) == order.end()) order.push_back(name(line));
  std::ranges::stable_sort(lines, {}, [&](const ReportLine* line) {
    return std::pair(std::ranges::find(order, name(line)) - order.begin(), place(*line));
  });

  result.csv =
      "x,robot,terrain,roughness,controller,trials,count,sd,mean,ci95_lower,ci95_upper,difference,"
      "difference_ci95_lower,difference_ci95_upper\n";
  for (std::size_t row = 0; row < lines.size(); ++row) {
    const ReportLine& line = *lines[row];
    if (result.curves.empty() || result.curves.back().title != name(&line))
      result.curves.push_back({name(&line), row, row});
    result.curves.back().last = row;
    result.csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", place(line), line.robot,
                              line.terrain, line.roughness, line.controller, line.trials,
                              line.value ? line.value->count : 0,
                              line.value ? fmt::format("{}", line.value->sd) : "",
                              cells(line.value), cells(line.difference));
  }
  return result;
}

// Curves stand beside each other by a little, lest their intervals hide each other.
std::string script(const Report& report, const Sheet& sheet, bool over_roughness) {
  constexpr std::array kColours = {"ink", "accent", "left_side", "right_side", "earth", "grey"};
  std::string text = figures::figure_preamble("report.svg", 760, 460);
  text += fmt::format("set ylabel {} noenhanced\nset key outside right top noenhanced\n",
                      figures::quoted(report.measure));
  text +=
      "set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\nset bars 0.6\nset autoscale "
      "xfix\n";
  double width = 1.0;
  if (over_roughness) {
    text += fmt::format("set xlabel {}\n",
                        figures::quoted("roughness of " + kind(sheet.terrains.back())));
    const auto [least, greatest] = std::ranges::minmax_element(
        report.lines, {}, [](const ReportLine& line) { return line.roughness; });
    width = (greatest->roughness - least->roughness) / 60.0;
  } else {
    width = 0.5 / static_cast<double>(sheet.curves.size());
    Words tics;
    for (std::size_t i = 0; i < sheet.terrains.size(); ++i)
      tics.push_back(fmt::format("{} {}", figures::quoted(sheet.terrains[i]), i));
    text += fmt::format("set xtics ({}) noenhanced\n", fmt::join(tics, ", "));
  }

  Words plots;
  for (std::size_t i = 0; i < sheet.curves.size(); ++i) {
    const Curve& curve = sheet.curves[i];
    const double shift =
        (static_cast<double>(i) - 0.5 * static_cast<double>(sheet.curves.size() - 1)) * width;
    plots.push_back(fmt::format(
        "'report.csv' every ::{}::{} using ($1+({:.6g})):9:10:11 title {} with {} lc rgb {} lw 1.6 "
        "pt 7 ps 0.5",
        curve.first + 1, curve.last + 1, over_roughness ? shift / 4.0 : shift,
        figures::quoted(curve.title), over_roughness ? "yerrorlines" : "yerrorbars",
        kColours[i % kColours.size()]));
  }
  return text + fmt::format("plot {}\n", fmt::join(plots, ", \\\n     "));
}

}  // namespace

void draw(const Report& report) {
  figures::require_gnuplot();
  const bool over_roughness = one_kind(report);
  const Sheet drawn = sheet(report, over_roughness);
  figures::StagedFiles files(report.directory);
  std::ofstream csv = files.create("report.csv");
  csv << drawn.csv;
  csv.close();
  std::ofstream gp = files.create("report.gp");
  gp << script(report, drawn, over_roughness);
  gp.close();
  for (const char* figure : {"report.svg", "report.pdf", "report.png"}) {
    files.expect(figure);
    figures::run_gnuplot(files.staging(), "report.gp", figure);
  }
  files.publish();
}

}  // namespace hexagait::sweep
