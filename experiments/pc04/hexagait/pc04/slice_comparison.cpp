// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/pc04/slice_comparison.hpp>

namespace hexagait::experiments {
namespace {

SliceComparison::Run run(const sim2d::SliceConfig& config, std::uint32_t trial) {
  sim2d::SliceRobot robot(config, {SliceComparison::kSeed, trial});
  for (int slice = 0; slice < SliceComparison::kTransient; ++slice) robot.advance();
  const double start = robot.position();
  for (int slice = SliceComparison::kTransient; slice < config.slices; ++slice) robot.advance();
  return {robot.summary(),
          (robot.position() - start) / (config.slices - SliceComparison::kTransient)};
}

}  // namespace

std::vector<double> SliceComparison::speeds(std::size_t gait) const {
  return each(gait, [](const Run& run) { return run.summary.speed; });
}

std::vector<double> SliceComparison::settled_speeds(std::size_t gait) const {
  return each(gait, [](const Run& run) { return run.settled_speed; });
}

statistics::Estimate SliceComparison::ahead_of_first(std::size_t gait) const {
  return statistics::paired_difference(speeds(gait), speeds(0));
}

SliceComparison compare_gaits(const std::vector<std::string>& gaits, const std::string& terrain) {
  const auto start = std::chrono::steady_clock::now();
  SliceComparison comparison{.terrain = terrain, .gaits = gaits, .runs = {}};
  for (const std::string& gait : gaits) {
    const sim2d::SliceConfig config{.gait = gait_state::parse_gait_choice(gait).value(),
                                    .terrain = sim2d::parse_slice_terrain(terrain).value(),
                                    .slices = SliceComparison::kSlices};
    auto& runs = comparison.runs.emplace_back();
    for (std::uint32_t trial = 0; trial < SliceComparison::kTrials; ++trial)
      runs.push_back(run(config, trial));
  }
  comparison.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return comparison;
}

std::string spelt(const statistics::Estimate& e) {
  const double mean = std::abs(e.mean) < 5e-4 ? 0.0 : e.mean;  // no "-0.000"
  return fmt::format("{:.3f} ± {:.3f}", mean, e.half_width);
}

figures::Table summary_table(const SliceComparison& c) {
  figures::Table table{{"terrain", "gait", "speed ± CI95", "SD", "least", "most",
                        "ahead of " + c.gaits[0], "stroke S", "share of the bound"},
                       {}};
  for (std::size_t k = 0; k < c.gaits.size(); ++k) {
    const std::vector<double> speeds = c.speeds(k);
    const auto [least, most] = std::ranges::minmax(speeds);
    const statistics::Estimate sweep =
        statistics::estimate(c.each(k, [](const auto& run) { return run.summary.stroke; }));
    const statistics::Estimate share = statistics::estimate(
        c.each(k, [](const auto& run) { return run.summary.fraction_of_bound(); }));
    table.rows.push_back({c.terrain, c.gaits[k], spelt(statistics::estimate(speeds)),
                          fmt::format("{:.3f}", statistics::estimate(speeds).sd),
                          fmt::format("{:.2f}", least), fmt::format("{:.2f}", most),
                          k == 0 ? "–" : spelt(c.ahead_of_first(k)),
                          fmt::format("{:.1f}", sweep.mean), fmt::format("{:.2f}", share.mean)});
  }
  return table;
}

figures::Table trial_table(const SliceComparison& c) {
  figures::Table table{{"gait_number", "gait", "trial", "speed", "settled_speed", "ahead", "sweep",
                        "share_of_bound", "lifts", "tripod_after", "hash"},
                       {}};
  for (std::size_t k = 0; k < c.gaits.size(); ++k)
    for (std::size_t trial = 0; trial < c.runs[k].size(); ++trial) {
      const auto& [s, settled] = c.runs[k][trial];
      table.rows.push_back({std::to_string(k), c.gaits[k], std::to_string(trial),
                            fmt::format("{}", s.speed), fmt::format("{}", settled),
                            fmt::format("{}", s.speed - c.runs[0][trial].summary.speed),
                            fmt::format("{}", s.stroke), fmt::format("{}", s.fraction_of_bound()),
                            std::to_string(s.lifts), std::to_string(s.tripod_after),
                            fmt::format("{:016x}", s.hash)});
    }
  return table;
}

std::vector<std::pair<std::string, std::string>> settings_of(const SliceComparison& c) {
  std::string gaits;
  for (const std::string& gait : c.gaits)
    gaits += fmt::format("{}{}", gaits.empty() ? "" : " ", gait);
  return {{"model", "slices"},
          {"terrain", c.terrain},
          {"gaits", gaits},
          {"seed", std::to_string(SliceComparison::kSeed)},
          {"trials", std::to_string(SliceComparison::kTrials)},
          {"slices", std::to_string(SliceComparison::kSlices)}};
}

std::string title_of(const std::string& gait) {
  if (gait == "free") return "free gait";
  if (gait == "unadjusted") return "free, no adjustment";
  if (gait == "literal") return "free, 3.3 to the letter";
  if (gait == "tripod") return "waiting tripod";
  const double beta = gait_state::parse_gait_choice(gait).value().stepper.duty_factor;
  return fmt::format("wave, β = {:.2f}", beta);
}

void write_comparison(figures::StagedFiles& files, const std::string& stem,
                      const SliceComparison& c) {
  figures::write_csv(files, stem + "-trials.csv", trial_table(c));
  std::ofstream means = files.create(stem + "-means.csv");
  means << "gait_number,gait,mean,sd,half_width_95,ahead,ahead_half_width_95\n";
  for (std::size_t k = 0; k < c.gaits.size(); ++k) {
    const statistics::Estimate speed = statistics::estimate(c.speeds(k)),
                               ahead = c.ahead_of_first(k);
    fmt::print(means, "{},{},{},{},{},{},{}\n", k, c.gaits[k], speed.mean, speed.sd,
               speed.half_width, ahead.mean, ahead.half_width);
  }
}

std::string comparison_script(const std::string& stem, const SliceComparison& c) {
  std::string names;
  for (std::size_t k = 0; k < c.gaits.size(); ++k)
    names += fmt::format("{}\"{}\" {}", k > 0 ? ", " : "", title_of(c.gaits[k]), k);
  return fmt::format("set macros\nrows = '({})'\ntrials = {}; means = {}; last = {}\n", names,
                     figures::quoted(stem + "-trials.csv"), figures::quoted(stem + "-means.csv"),
                     c.gaits.size() - 1) +
         R"(
# Trials lie beside each other, in the order of their numbers.
spread(trial) = 0.26*(2.0*((trial*0.618034) - floor(trial*0.618034)) - 1)
gait_colour(k) = k == 0 ? 0xc99a2e : k == 1 ? 0x2f6f9f : 0x8c99a5
set yrange [last+0.6:-0.6]
set ytics @rows scale 0
set grid noytics
unset key

# What both panels plot; values stand `lift` above their diamonds.
speeds = 'trials using 4:($1+spread($3)):(gait_colour($1)) with points pt 7 ps 0.4 lc rgb variable, \
    means using 3:1:5 with xerrorbars pt 2 ps 0 lw 2 lc rgb ink, \
    means using 3:1 with points pt 13 ps 1.3 lc rgb ink, \
    means using 3:1:(sprintf("%.2f", $3)) with labels offset 0, lift font sized("", 9) textcolor rgb ink'
leads = 'trials using 6:($1 > 0 ? $1+spread($3) : NaN):(gait_colour($1)) \
        with points pt 7 ps 0.4 lc rgb variable, \
    means using ($1 > 0 ? $6 : NaN):1:7 with xerrorbars pt 2 ps 0 lw 2 lc rgb ink, \
    means using ($1 > 0 ? $6 : NaN):1 with points pt 13 ps 1.3 lc rgb ink, \
    means using ($1 > 0 ? $6 : NaN):1:(sprintf(lead_format, $6, $7)) with labels offset 0, lift \
        font sized("", 9) textcolor rgb ink'
)";
}

}  // namespace hexagait::experiments
