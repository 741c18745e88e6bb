// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <hexagait/pc04/slice_comparison.gp.hpp>
#include <hexagait/pc04/slice_comparison.hpp>

namespace hexagait::experiments {
namespace {

SliceComparison::Run run(const sim2d::SliceConfig& config, std::uint32_t trial) {
  sim2d::SliceRobot robot(config, {kSliceSeed, trial});
  for (int slice = 0; slice < kSliceTransient; ++slice) robot.advance();
  const double start = robot.position();
  for (int slice = kSliceTransient; slice < config.slices; ++slice) robot.advance();
  return {robot.summary(), (robot.position() - start) / (config.slices - kSliceTransient)};
}

// The names by which the figures call the gaits.
std::string title_of(const std::string& gait) {
  if (gait == "free") return "free gait";
  if (gait == "unadjusted") return "free, no adjustment";
  if (gait == "literal") return "free, 3.3 to the letter";
  if (gait == "tripod") return "waiting tripod";
  const double beta = gait_state::parse_gait_choice(gait).value().stepper.duty_factor;
  return fmt::format("wave, β = {:.2f}", beta);
}

}  // namespace

SliceComparison compare_gaits(const std::vector<std::string>& gaits, const std::string& terrain) {
  const auto start = std::chrono::steady_clock::now();
  SliceComparison comparison{.terrain = terrain, .gaits = gaits};
  for (const std::string& gait : gaits) {
    const sim2d::SliceConfig config{.gait = gait_state::parse_gait_choice(gait).value(),
                                    .terrain = sim2d::parse_slice_terrain(terrain).value(),
                                    .slices = kSlices};
    auto& runs = comparison.runs.emplace_back();
    for (std::uint32_t trial = 0; trial < kSliceTrials; ++trial) runs.push_back(run(config, trial));
  }
  comparison.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return comparison;
}

std::string spelt(const statistics::Estimate& e) {
  const double mean = std::abs(e.mean) < 5e-4 ? 0.0 : e.mean;  // no "-0.000"
  return fmt::format("{:.3f} ± {:.3f}", mean, e.half_width);
}

figures::Csv summary_table(const std::vector<SliceComparison>& comparisons) {
  figures::Csv table("terrain,gait,speed ± CI95,SD,least,most,ahead of " + comparisons[0].gaits[0] +
                     ",stroke S,share of the bound");
  for (const SliceComparison& c : comparisons)
    for (std::size_t k = 0; k < c.gaits.size(); ++k) {
      const std::vector<double> speeds = c.speeds(k);
      const auto [least, most] = std::ranges::minmax(speeds);
      const double stroke = c.mean(k, [](const auto& run) { return run.summary.stroke; });
      const double share =
          c.mean(k, [](const auto& run) { return run.summary.fraction_of_bound(); });
      const statistics::Estimate speed = statistics::estimate(speeds);
      table.row(c.terrain, c.gaits[k], spelt(speed), fmt::format("{:.3f}", speed.sd),
                fmt::format("{:.2f}", least), fmt::format("{:.2f}", most),
                k == 0 ? "–" : spelt(c.ahead_of_first(k)), fmt::format("{:.1f}", stroke),
                fmt::format("{:.2f}", share));
    }
  return table;
}

std::vector<std::pair<std::string, std::string>> settings_of(const SliceComparison& c) {
  return {{"model", "slices"},
          {"terrain", c.terrain},
          {"gaits", fmt::format("{}", fmt::join(c.gaits, " "))},
          {"seed", std::to_string(kSliceSeed)},
          {"trials", std::to_string(kSliceTrials)},
          {"slices", std::to_string(kSlices)}};
}

std::string described(const SliceComparison& c) {
  return fmt::format(
      "{} random starts × {} slices, the same for every gait · dots: starts · diamonds: means, "
      "bars and bands: 95 % confidence intervals",
      c.runs[0].size(), kSlices);
}

void draw_comparison(figures::StagedFiles& files, const figures::Figure& figure,
                     const SliceComparison& c, figures::Variables variables,
                     std::string_view script) {
  figures::Csv trials(
      "gait_number,gait,trial,speed,settled_speed,ahead,sweep,share_of_bound,lifts,tripod_after,"
      "hash");
  figures::Csv means("gait_number,gait,mean,sd,half_width_95,ahead,ahead_half_width_95");
  std::vector<std::string> names;
  double least_lead = 0.0, most_lead = 0.0, most_speed = 0.0;
  for (std::size_t k = 0; k < c.gaits.size(); ++k) {
    names.push_back(title_of(c.gaits[k]));
    const statistics::Estimate speed = statistics::estimate(c.speeds(k)),
                               ahead = c.ahead_of_first(k);
    means.row(k, c.gaits[k], speed.mean, speed.sd, speed.half_width, ahead.mean, ahead.half_width);
    for (std::size_t trial = 0; trial < c.runs[k].size(); ++trial) {
      const auto& [s, settled] = c.runs[k][trial];
      const double lead = s.speed - c.runs[0][trial].summary.speed;
      trials.row(k, c.gaits[k], trial, s.speed, settled, lead, s.stroke, s.fraction_of_bound(),
                 s.lifts, s.tripod_after, fmt::format("{:016x}", s.hash));
      least_lead = std::min(least_lead, lead);
      most_lead = std::max(most_lead, lead);
      most_speed = std::max(most_speed, s.speed);
    }
  }
  figures::write_tables(files, figure.stem, {{"trials", trials}, {"means", means}});
  variables.set("names", names);
  for (const auto& [name, value] :
       {std::pair{"least_lead", least_lead}, {"most_lead", most_lead}, {"most_speed", most_speed}})
    variables.set(name, value);
  figures::draw_figure(files, figure, variables,
                       std::string(scripts::pc04::slice_comparison).append(script));
}

}  // namespace hexagait::experiments
