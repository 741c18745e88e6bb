// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/recording/detail/walk_json.hpp>
#include <hexagait/sweep/report.hpp>

namespace hexagait::sweep {
namespace {

using nlohmann::ordered_json;
using recording::finite;

// "20 trials", or how many of them have a value.
std::string trials(const ReportLine& line) {
  const int count = line.value ? line.value->count : 0;
  return count == line.trials() ? std::to_string(count)
                                : fmt::format("{}/{}", count, line.trials());
}

std::string value(const Report& report, const ReportLine& line) {
  if (!line.value) return "none";
  const Measured& m = *line.value;
  if (report.measure.yes_no)
    return fmt::format("{:.0f} % ({:.0f} to {:.0f} %)", 100.0 * m.value, 100.0 * m.lower,
                       100.0 * m.upper);
  return with_error(m.value, 0.5 * (m.upper - m.lower));
}

std::string difference(const Report& report, const ReportLine& line) {
  if (!line.difference) return "";
  const auto& [d, count, percent] = *line.difference;
  if (report.measure.yes_no)
    return fmt::format("{:+.0f} ({:+.0f} to {:+.0f}) %", 100.0 * d.value, 100.0 * d.lower,
                       100.0 * d.upper);
  const std::string text = with_error(d.value, 0.5 * (d.upper - d.lower));
  return percent ? fmt::format("{} ({:+.1f} %)", text, *percent) : text;
}

// "2 fell, 1 stuck": those that did not walk on.
std::string accidents(const ReportLine& line) {
  std::string text;
  for (const Outcome outcome : kOutcomes) {
    const int count = line.outcomes[static_cast<std::size_t>(outcome)];
    if (walked_on(outcome) || count == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, to_string(outcome));
  }
  return text;
}

ordered_json json(const std::optional<Measured>& m) {
  if (!m) return nullptr;
  ordered_json result = {{"count", m->count}, {"mean", m->value}};
  if (m->sd) result["sd"] = *m->sd;
  result["ci95"] = {finite(m->lower), finite(m->upper)};
  return result;
}

ordered_json json(const std::optional<Compared>& c) {
  if (!c) return nullptr;
  return {{"count", c->count},
          {"mean", c->difference.value},
          {"ci95", {finite(c->difference.lower), finite(c->difference.upper)}},
          {"percent", recording::json_of(c->percent)}};
}

}  // namespace

std::string with_error(double value, double half_width) {
  if (!std::isfinite(half_width)) return fmt::format("{:.3g}", value);
  if (half_width < 1e-9 * std::abs(value) || half_width == 0.0)
    return fmt::format("{:.5g} ± 0", value);
  double first_digit = half_width;
  int decimals = 0;
  for (; first_digit >= 10.0; first_digit /= 10.0) --decimals;
  for (; first_digit < 1.0; first_digit *= 10.0) ++decimals;
  if (first_digit < 2.0) ++decimals;
  if (decimals >= 0) return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, half_width, decimals);
  double unit = 1.0;
  for (int k = decimals; k < 0; ++k) unit *= 10.0;
  return fmt::format("{:.0f} ± {:.0f}", std::round(value / unit) * unit,
                     std::round(half_width / unit) * unit);
}

std::string in_words(const Report& report) {
  const Column& m = report.measure;
  std::string text = fmt::format("{} ({}){}: ", m.label, m.name,
                                 m.unit.empty() ? "" : fmt::format(" [{}]", m.unit));
  if (m.yes_no)
    text += "share of all trials with a result, 95 % confidence interval after Wilson\n";
  else
    text +=
        fmt::format("mean ± half of its 95 % confidence interval, of {}\n",
                    report.all_trials ? "all trials with a value" : "the trials that walked on");
  text += report.paired ? "differences are paired by seed\n"
                        : "differences are not paired: terrains have seeds of their own\n";
  // The column of plants is as wide as needed; it is left out where all are ideal.
  std::size_t width = 0;
  for (const ReportLine& line : report.lines)
    if (line.plant != "ideal") width = std::max(width, line.plant.size() + 1);
  const auto row = [&](std::string plant, const auto&... cells) {
    plant.resize(width, ' ');
    std::string line = "  " + plant;
    line += fmt::format("{:<14} {:<14} {:<12} {:>9} {:>20} {:>9} {:>26}  {}", cells...);
    text += line.erase(line.find_last_not_of(' ') + 1) + '\n';
  };
  row("plant", "robot", "terrain", "controller", "trials", m.yes_no ? "share" : "mean",
      m.yes_no ? "" : "sd", "less " + report.first, "apart");
  for (const ReportLine& line : report.lines)
    row(line.plant, line.robot, line.terrain, line.controller, trials(line), value(report, line),
        line.value && line.value->sd ? fmt::format("{:.2g}", *line.value->sd) : "",
        difference(report, line), accidents(line));
  return text;
}

std::string to_json(const Report& report) {
  ordered_json result = {
      {"measure", report.measure.name},      {"unit", report.measure.unit},
      {"proportion", report.measure.yes_no}, {"compared", to_string(report.compare)},
      {"compared_with", report.first},       {"paired", report.paired},
      {"all_trials", report.all_trials}};
  for (const ReportLine& line : report.lines) {
    ordered_json outcomes = ordered_json::object();
    for (const Outcome outcome : kOutcomes)
      if (const int count = line.outcomes[static_cast<std::size_t>(outcome)]; count > 0)
        outcomes[std::string(to_string(outcome))] = count;
    result["lines"].push_back({{"robot", line.robot},
                               {"plant", line.plant},
                               {"terrain", line.terrain},
                               {"roughness", line.roughness},
                               {"controller", line.controller},
                               {"trials", line.trials()},
                               {"outcomes", outcomes},
                               {"value", json(line.value)},
                               {"difference", json(line.difference)}});
  }
  return result.dump(2);
}

}  // namespace hexagait::sweep
