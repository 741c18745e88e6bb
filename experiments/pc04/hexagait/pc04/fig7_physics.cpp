// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 7 once more, in physics: the speed of Genghis in Box2D on flat and on rougher and
// rougher ground, of the tripod controller, the free gait, and the free gait without adjustment.
// 20 random postures and grounds, the same for all three.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <hexagait/figures/csv.hpp>
#include <hexagait/pc04/fig7_physics.gp.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/recording/genghis.hpp>
#include <hexagait/statistics/statistics.hpp>

namespace hexagait::experiments {
namespace {

const std::vector<std::string> kGenghisGaits = {"tripod", "free", "unadjusted"};
constexpr std::array<int, 5> kHeights = {0, 2, 4, 6, 8};  // [cm]
constexpr int kSeeds = 20;
constexpr double kTransient = 12.0;  // the start, from a random posture [s]
constexpr double kPosture = 0.025;   // feet start displaced by up to half a stroke [m]

GenghisComparison::Run walk(const std::string& gait, const std::string& terrain, std::uint64_t seed,
                            double seconds, const std::atomic<bool>* stop) {
  sim2d::GenghisTrial trial;
  trial.terrain = sim2d::parse_terrain2d(terrain);
  trial.gait = gait_state::parse_gait_choice(gait).value();
  trial.seed = seed;
  trial.seconds = seconds;
  trial.random_posture = kPosture;

  double begin = 0.0, start = 0.0, end = 0.0;
  const auto observe = [&](const auto&, const GroundTruth& truth, const auto&) {
    if (begin == 0.0) begin = truth.time;
    if (truth.time <= begin + kTransient) start = truth.X_WB.p.x();
    end = truth.X_WB.p.x();
  };
  GenghisComparison::Run result{recording::simulate(trial, observe, stop)};
  const double settled = result.summary.seconds - kTransient;
  result.settled_speed = settled > 0.0 ? (end - start) / settled : 0.0;
  return result;
}

std::string with_interval(const statistics::Estimate& e) {
  return fmt::format("{:.2f} ± {:.2f}", e.mean, e.half_width);
}

figures::Csv write_tables(figures::StagedFiles& files,
                          const std::vector<GenghisComparison>& grounds) {
  figures::Csv table(
      "terrain,gait,speed ± CI95 [cm/s],after the start,ahead of tripod,steps,stuck or fallen");
  figures::Csv means(
      "gait_number,roughness_cm,mean_cm_s,half_width_95,ahead_cm_s,ahead_half_width_95");
  figures::Csv trials(
      "gait_number,roughness_cm,seed,speed_cm_s,settled_cm_s,steps,tripod_after,blocked,searches,"
      "slip_m,pitch_max_rad,ok,hash");
  for (std::size_t k = 0; k < grounds.size(); ++k)
    for (std::size_t gait = 0; gait < kGenghisGaits.size(); ++gait) {
      const GenghisComparison& ground = grounds[k];
      const statistics::Estimate speed = statistics::estimate(ground.speeds(gait)),
                                 ahead = ground.ahead_of_first(gait);
      means.row(gait, kHeights[k], speed.mean, speed.half_width, ahead.mean, ahead.half_width);
      int seed = 0, steps = 0, failed = 0;
      for (const auto& [s, settled] : ground.runs[gait]) {
        trials.row(gait, kHeights[k], ++seed, 1e2 * s.speed, 1e2 * settled, s.steps,
                   s.tripod_after_steps.value_or(-1), s.side_view.blocked, s.side_view.searches,
                   s.slip_mean, s.pitch_max, s.ok(), fmt::format("{:016x}", s.state_hash));
        steps += s.steps;
        failed += !s.ok();
      }
      table.row(ground.terrain, kGenghisGaits[gait], with_interval(speed),
                with_interval(statistics::estimate(ground.settled_speeds(gait))),
                gait == 0 ? "–" : with_interval(ahead), steps, failed);
    }
  figures::write_tables(files, "fig7_physics", {{"means", means}, {"trials", trials}});
  return table;
}

}  // namespace

Outcome fig7_physics(const ExperimentContext& context, figures::StagedFiles& files) {
  const auto begin = std::chrono::steady_clock::now();
  const int seeds = context.short_form ? 2 : kSeeds;
  const double length = context.short_form ? 16.0 : 60.0;
  std::vector<GenghisComparison> grounds;
  std::size_t done = 0;
  for (const int roughness : kHeights) {
    GenghisComparison& ground = grounds.emplace_back(GenghisComparison{
        .terrain = fmt::format("rough:{}cm", roughness),
        .gaits = kGenghisGaits,
        .runs = std::vector<std::vector<GenghisComparison::Run>>(kGenghisGaits.size()),
        .scale = 1e2});
    for (int seed = 1; seed <= seeds; ++seed) {
      for (std::size_t gait = 0; gait < kGenghisGaits.size(); ++gait)
        ground.runs[gait].push_back(walk(kGenghisGaits[gait], ground.terrain,
                                         static_cast<std::uint64_t>(seed), length, context.stop));
      context.tell(++done, static_cast<std::size_t>(seeds) * kHeights.size());
      if (context.stopped()) return {};
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const figures::Csv table = write_tables(files, grounds);
  figures::draw_figure(
      files,
      context.figure("fig7_physics", 1400, 640,
                     "Genghis in Box2D: speed over the roughness of the ground",
                     fmt::format("{} random postures and grounds, {:.0f} s each, the same for "
                                 "every gait · bars: 95 % confidence intervals · after [PC04] "
                                 "Fig. 7",
                                 seeds, length)),
      {}, scripts::pc04::fig7_physics);
  return {.verdicts = judged_in_full_only(judge_fig7_physics(grounds), context.short_form),
          .settings = {{"robot", "genghis2d"},
                       {"seeds", std::to_string(seeds)},
                       {"seconds", fmt::format("{}", length)},
                       {"random_posture_m", fmt::format("{}", kPosture)}},
          .provenance = recording::provenance(sim2d::GenghisTrial{}),
          .table = table,
          .compute_seconds = seconds.count()};
}

}  // namespace hexagait::experiments
