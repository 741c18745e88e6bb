// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/rough/tally.hpp>

namespace hexagait::experiments {
namespace {

using sweep::ReportLine;

// A column, by plant, terrain and controller.
std::vector<ReportLine> lines(const std::filesystem::path& sweep, const char* measure) {
  return sweep::make_report(sweep, {.measure = measure}).lines;
}

RoughMean mean(const ReportLine& line) {
  return line.value ? RoughMean{line.value->value, line.value->lower, line.value->upper}
                    : RoughMean{};
}

RoughMean lead(const ReportLine& line) {
  if (!line.difference) return {};
  const statistics::Difference& d = line.difference->difference;
  return {d.value, d.lower, d.upper};
}

int count(const ReportLine& line, sweep::Outcome outcome) {
  return line.outcomes[static_cast<std::size_t>(outcome)];
}

}  // namespace

std::vector<RoughPoint> tally(const std::filesystem::path& sweep) {
  const auto speed = lines(sweep, "speed_m_s"), off_path = lines(sweep, "lateral_mean_m"),
             slip = lines(sweep, "slip_p95_m"), touchdown = lines(sweep, "touchdown_p95_m_s"),
             cost = lines(sweep, "cost_of_transport"), margin = lines(sweep, "margin_min_m");
  std::vector<RoughPoint> points;
  for (std::size_t k = 0; k < speed.size(); ++k) {
    const ReportLine& line = speed[k];
    points.push_back(
        {.plant = line.plant,
         .controller = line.controller,
         .height = line.roughness,
         .arrived = statistics::proportion(count(line, sweep::Outcome::arrived), line.trials()),
         .fell = count(line, sweep::Outcome::fell),
         .stuck = count(line, sweep::Outcome::stuck),
         .late = count(line, sweep::Outcome::late),
         .speed = mean(line),
         .off_path = mean(off_path[k]),
         .slip = mean(slip[k]),
         .touchdown = mean(touchdown[k]),
         .cost = mean(cost[k]),
         .margin = mean(margin[k]),
         .lead = lead(line)});
  }
  return points;
}

const RoughPoint* point(std::span<const RoughPoint> points, const std::string& plant,
                        const std::string& controller, double height) {
  const auto found = std::ranges::find_if(points, [&](const RoughPoint& p) {
    return p.plant == plant && p.controller == controller && std::abs(p.height - height) < 1e-9;
  });
  return found == points.end() ? nullptr : &*found;
}

figures::Csv table(std::span<const RoughPoint> points, double reach) {
  std::string header =
      "plant,controller,height_m,height_of_reach,walks,arrived,fell,stuck,late,"
      "share,share_lower,share_upper";
  for (const char* name : {"speed_m_s", "speed_of_flat", "off_path_m", "slip_p95_m",
                           "touchdown_p95_m_s", "cost_of_transport", "margin_min_m", "lead_m_s"})
    for (const char* end : {"", "_lower", "_upper"}) header.append(",").append(name).append(end);
  figures::Csv table(header);
  for (const RoughPoint& p : points) {
    const RoughPoint* const flat = point(points, p.plant, p.controller, 0.0);
    const double of = flat != nullptr ? 1.0 / flat->speed.value : std::nan("");
    const RoughMean share = p.speed.times(of);
    table.row(p.plant, p.controller, p.height, p.height / reach, p.arrived.trials, p.arrived.count,
              p.fell, p.stuck, p.late, p.arrived.share(), p.arrived.lower, p.arrived.upper,
              p.speed.value, p.speed.lower, p.speed.upper, share.value, share.lower, share.upper,
              p.off_path.value, p.off_path.lower, p.off_path.upper, p.slip.value, p.slip.lower,
              p.slip.upper, p.touchdown.value, p.touchdown.lower, p.touchdown.upper, p.cost.value,
              p.cost.lower, p.cost.upper, p.margin.value, p.margin.lower, p.margin.upper,
              p.lead.value, p.lead.lower, p.lead.upper);
  }
  return table;
}

}  // namespace hexagait::experiments
