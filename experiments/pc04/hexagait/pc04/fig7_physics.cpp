// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 7 once more, in physics: the speed of Genghis in Box2D on flat and on rougher and
// rougher ground, of the tripod controller, the free gait, and the free gait without adjustment.
// 20 random postures and grounds, the same for all three.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/recording/genghis.hpp>
#include <hexagait/statistics/statistics.hpp>

namespace hexagait::experiments {
namespace {

using Ground = GenghisGround;
using enum GenghisGround::Gait;
using Gait = Ground::Gait;

const std::vector<std::string> kGaits = {"tripod", "free", "unadjusted"};
constexpr std::array<int, 5> kRoughness = {0, 2, 4, 6, 8};  // [cm]
constexpr int kSeeds = 20;
constexpr double kSeconds = 60.0;
constexpr double kTransient = 12.0;  // the start, from a random posture [s]
constexpr double kPosture = 0.025;   // feet start displaced by up to half a stroke [m]

Ground::Walk walk(const std::string& gait, int roughness, std::uint64_t seed,
                  const std::atomic<bool>* stop) {
  sim2d::GenghisTrial trial;
  trial.terrain = sim2d::parse_terrain2d(fmt::format("rough:{}cm", roughness));
  trial.gait = gait_state::parse_gait_choice(gait).value();
  trial.seed = seed;
  trial.seconds = kSeconds;
  trial.random_posture = kPosture;

  double begin = 0.0, start = 0.0, end = 0.0;
  const auto observe = [&](const auto&, const GroundTruth& truth, const auto&) {
    if (begin == 0.0) begin = truth.time;
    if (truth.time <= begin + kTransient) start = truth.X_WB.p.x();
    end = truth.X_WB.p.x();
  };
  Ground::Walk result{recording::simulate(trial, observe, stop)};
  const double settled = result.summary.seconds - kTransient;
  result.settled_speed = settled > 0.0 ? (end - start) / settled : 0.0;
  return result;
}

std::string spelt(const statistics::Estimate& e) {
  return fmt::format("{:.2f} ± {:.2f}", e.mean, e.half_width);
}

constexpr const char* kScript = R"(
set multiplot
set label 1 headline at screen 0.02, 0.945 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.02, 0.885 left noenhanced font sized("", 10.5) textcolor rgb grey
set tmargin at screen 0.76; set bmargin at screen 0.13
gait_colour(k) = k == 0 ? 0xc99a2e : k == 1 ? 0x2f6f9f : 0x8c99a5
names = "'tripod, waiting' 'free gait' 'without adjustment'"
set xlabel "roughness: cells of 10 cm, heights up to [cm]" offset 0, 0.3
set xrange [-0.7:8.7]; set xtics 2
set lmargin at screen 0.06; set rmargin at screen 0.49
set label 3 "{/:Bold a}   Speed [cm/s]" at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
set yrange [0:6]
set key at graph 0.02, graph 0.04 left bottom Left reverse samplen 1.5
plot for [k=0:2] trials using ($1 == k ? $2 + 0.24*(k-1) + 0.12*(rand(0)-0.5) : NaN):4 with points pt 7 ps 0.3 \
         lc rgb gait_colour(k) notitle, \
     for [k=0:2] means using ($1 == k ? $2 + 0.24*(k-1) : NaN):3:4 with yerrorbars pt 13 ps 1 lw 1.6 \
         lc rgb gait_colour(k) title word(names, k+1)
unset label 1; unset label 2
set lmargin at screen 0.56; set rmargin at screen 0.98
set label 3 "{/:Bold b}   Ahead of the tripod controller, in pairs [cm/s]"
set yrange [*:*]
set key at graph 0.98, graph 0.04 right bottom
plot 0 with lines lw 1 lc rgb grey notitle, \
     for [k=1:2] means using ($1 == k ? $2 + 0.12*(2*k-3) : NaN):5:6 with yerrorbars pt 13 ps 1 lw 1.6 \
         lc rgb gait_colour(k) title word(names, k+1)
unset multiplot
)";

figures::Table write_tables(figures::StagedFiles& files, const std::vector<Ground>& grounds) {
  figures::Table table{{"terrain", "gait", "speed ± CI95 [cm/s]", "after the start",
                        "ahead of tripod", "steps", "stuck or fallen"},
                       {}};
  std::ofstream means = files.create("fig7_physics-means.csv");
  std::ofstream trials = files.create("fig7_physics-trials.csv");
  means << "gait_number,roughness_cm,mean_cm_s,half_width_95,ahead_cm_s,ahead_half_width_95\n";
  trials << "gait_number,roughness_cm,seed,speed_cm_s,settled_cm_s,steps,tripod_after,blocked,"
            "searches,slip_m,pitch_max_rad,ok,hash\n";
  for (const Ground& ground : grounds)
    for (const Gait gait : {kTripod, kFree, kUnadjusted}) {
      const statistics::Estimate speed = statistics::estimate(ground.speeds(gait)),
                                 ahead = ground.ahead(gait);
      fmt::print(means, "{},{},{},{},{},{}\n", static_cast<int>(gait), ground.roughness, speed.mean,
                 speed.half_width, ahead.mean, ahead.half_width);
      int seed = 0, steps = 0, failed = 0;
      for (const auto& [s, settled] : ground.walks[gait]) {
        fmt::print(trials, "{},{},{},{},{},{},{},{},{},{},{},{:d},{:016x}\n",
                   static_cast<int>(gait), ground.roughness, ++seed, 1e2 * s.speed, 1e2 * settled,
                   s.steps, s.tripod_after_steps.value_or(-1), s.side_view.blocked,
                   s.side_view.searches, s.slip_mean, s.pitch_max, s.ok(), s.state_hash);
        steps += s.steps;
        failed += !s.ok();
      }
      table.rows.push_back({ground.name(), kGaits[gait], spelt(speed),
                            spelt(statistics::estimate(ground.settled_speeds(gait))),
                            gait == kTripod ? "–" : spelt(ahead), std::to_string(steps),
                            std::to_string(failed)});
    }
  return table;
}

void draw(figures::StagedFiles& files) {
  std::ofstream script = files.create("fig7_physics.gp");
  script
      << figures::figure_preamble("fig7_physics.svg", 1400, 640)
      << "headline = 'Genghis in physics: slower on rougher ground, the free gait a little behind "
         "the "
         "tripod controller'\n"
      << "subtitle = '20 random postures and grounds, 60 s each, the same for every gait · bars: "
         "95 % confidence intervals · after [PC04] Fig. 7'\n"
      << "means = 'fig7_physics-means.csv'; trials = 'fig7_physics-trials.csv'\n"
      << kScript;
  script.close();
  figures::draw_figure(files, "fig7_physics");
}

}  // namespace

Outcome fig7_physics(const ExperimentContext& context, figures::StagedFiles& files) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<Ground> grounds;
  double done = 0.0;
  for (const int roughness : kRoughness) {
    Ground& ground = grounds.emplace_back();
    ground.roughness = roughness;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      for (const Gait gait : {kTripod, kFree, kUnadjusted})
        ground.walks[gait].push_back(
            walk(kGaits[gait], roughness, static_cast<std::uint64_t>(seed), context.stop));
      if (context.progress) context.progress(++done / (kSeeds * kRoughness.size()));
      if (context.stop != nullptr && context.stop->load()) return {};
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const figures::Table table = write_tables(files, grounds);
  draw(files);
  return {.verdicts = judge_fig7_physics(grounds),
          .settings = {{"robot", "genghis2d"},
                       {"seeds", std::to_string(kSeeds)},
                       {"seconds", fmt::format("{}", kSeconds)},
                       {"random_posture_m", fmt::format("{}", kPosture)}},
          .table = table,
          .compute_seconds = seconds.count()};
}

}  // namespace hexagait::experiments
