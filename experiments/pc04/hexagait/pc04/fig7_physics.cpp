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
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/sim2d/genghis.hpp>
#include <hexagait/statistics/statistics.hpp>

namespace hexagait::experiments {
namespace {

enum Gait : std::size_t { kTripod, kFree, kUnadjusted };

const std::vector<std::string> kGaits = {"tripod", "free", "unadjusted"};
constexpr std::array<int, 5> kRoughness = {0, 2, 4, 6, 8};  // [cm]
constexpr int kSeeds = 20;
constexpr double kSeconds = 60.0;
constexpr double kTransient = 12.0;  // the start, from a random posture [s]
constexpr double kPosture = 0.025;   // feet start displaced by up to half a stroke [m]
constexpr double kLevel = 0.99;      // of the tripod's speed: "the same level"

struct Walk {
  sim2d::GenghisSummary summary = {};
  double settled_speed = 0.0;  ///< after the transient [m/s]
};

struct Ground {
  int roughness = 0;  ///< [cm]
  std::array<std::vector<Walk>, 3> walks;

  // One value of each seed.
  template <class Value>
  [[nodiscard]] std::vector<double> each(Gait gait, Value value) const {
    std::vector<double> values;
    for (const Walk& walk : walks[gait]) values.push_back(static_cast<double>(value(walk)));
    return values;
  }
  // In cm/s.
  [[nodiscard]] std::vector<double> speeds(Gait gait) const {
    return each(gait, [](const Walk& w) { return 1e2 * w.summary.speed; });
  }
  [[nodiscard]] std::vector<double> settled_speeds(Gait gait) const {
    return each(gait, [](const Walk& w) { return 1e2 * w.settled_speed; });
  }
  [[nodiscard]] statistics::Estimate ahead(Gait gait) const {
    return statistics::paired_difference(speeds(gait), speeds(kTripod));
  }
  [[nodiscard]] std::string terrain() const { return fmt::format("rough:{}cm", roughness); }
};

Walk walk(const std::string& gait, int roughness, std::uint64_t seed,
          const std::atomic<bool>* stop) {
  sim2d::GenghisTrial trial;
  trial.terrain = sim2d::parse_terrain2d(fmt::format("rough:{}cm", roughness));
  trial.gait = gait_state::parse_gait_choice(gait).value();
  trial.seed = seed;
  trial.seconds = kSeconds;
  trial.random_posture = kPosture;

  double begin = 0.0, start = 0.0, end = 0.0;
  const auto observe = [&](const auto&, const sim2d::GenghisTruth& truth) {
    if (begin == 0.0) begin = truth.time;
    if (truth.time <= begin + kTransient) start = truth.p_WB.x();
    end = truth.p_WB.x();
  };
  Walk result{sim2d::run_genghis(trial, observe, stop)};
  const double settled = result.summary.seconds - kTransient;
  result.settled_speed = settled > 0.0 ? (end - start) / settled : 0.0;
  return result;
}

std::string spelt(const statistics::Estimate& e) {
  return fmt::format("{:.2f} ± {:.2f}", e.mean, e.half_width);
}

int failures(const std::vector<Ground>& grounds) {
  int count = 0;
  for (const Ground& ground : grounds)
    for (const auto& walks : ground.walks)
      count += static_cast<int>(
          std::ranges::count_if(walks, [](const Walk& w) { return !w.summary.ok(); }));
  return count;
}

// Why free is not ahead: how often it steps, and how far a step brings it.
std::string pace(const Ground& ground, Gait gait) {
  const auto rate = statistics::estimate(
      ground.each(gait, [](const Walk& w) { return w.summary.steps / w.summary.seconds; }));
  const auto advance = statistics::estimate(
      ground.each(gait, [](const Walk& w) { return 1e2 * w.summary.distance / w.summary.steps; }));
  return fmt::format("{:.2f} steps/s of {:.2f} cm", rate.mean, advance.mean);
}

Verdict judge_level(const Ground& flat, Gait gait, bool settled, const std::string& claim) {
  const auto of = [&](Gait g) { return settled ? flat.settled_speeds(g) : flat.speeds(g); };
  std::vector<double> needed = of(kTripod);
  for (double& speed : needed) speed *= kLevel;
  const statistics::Estimate margin = statistics::paired_difference(of(gait), needed);
  const double share = statistics::estimate(of(gait)).mean / statistics::estimate(of(kTripod)).mean;
  return {claim,
          margin.lower() >= 0.0,
          fmt::format("{} against {} cm/s: {:.1f} %", spelt(statistics::estimate(of(gait))),
                      spelt(statistics::estimate(of(kTripod))), 100.0 * share),
          {}};
}

Verdict judge_slower(const std::vector<Ground>& grounds) {
  bool slower = true;
  std::string speeds;
  for (std::size_t k = 0; k < grounds.size(); ++k) {
    speeds += fmt::format("{}{:.1f}", k == 0 ? "" : ", ",
                          statistics::estimate(grounds[k].speeds(kFree)).mean);
    if (k == 0) continue;
    const statistics::Estimate change =
        statistics::paired_difference(grounds[k].speeds(kFree), grounds[k - 1].speeds(kFree));
    slower = slower && change.upper() < 0.0;
  }
  const statistics::Estimate flat = statistics::estimate(grounds.front().speeds(kFree));
  return {"About 5 cm/s on smooth ground, progressively less as the ground gets rougher",
          slower && 4.5 < flat.mean && flat.mean < 5.5,
          speeds + " cm/s",
          {}};
}

Verdict judge_ahead(const std::vector<Ground>& grounds) {
  std::string numbers;
  bool holds = true;
  for (const Ground& ground : grounds) {
    if (ground.roughness == 0) continue;
    const statistics::Estimate ahead = ground.ahead(kFree);
    holds = holds && ahead.lower() > 0.0;
    numbers +=
        fmt::format("{}{} cm/s on {}", numbers.empty() ? "" : ", ", spelt(ahead), ground.terrain());
  }
  const Ground& rough = grounds[grounds.size() - 2];
  Verdict verdict{"On rough ground the free gait is ahead of the tripod controller",
                  holds,
                  "ahead by " + numbers,
                  {}};
  verdict.why_not = fmt::format(
      "on {} it makes {}, the tripod controller {}: as many steps, and shorter ones. Waiting for "
      "two neighbours instead of for all gains little where every step takes long, and the slice "
      "model, where it gains, pays with longer strokes; here strokes end where legs do",
      rough.terrain(), pace(rough, kFree), pace(rough, kTripod));
  return verdict;
}

Verdict judge_never_below(const std::vector<Ground>& grounds) {
  std::string numbers;
  bool holds = true;
  double worst = 1.0;
  for (const Ground& ground : grounds) {
    holds = holds && ground.ahead(kFree).upper() >= 0.0;
    worst = std::min(worst, statistics::estimate(ground.speeds(kFree)).mean /
                                statistics::estimate(ground.speeds(kTripod)).mean);
  }
  return {"On no terrain is the free gait below the tripod controller", holds,
          fmt::format("at worst {:.1f} % of its speed", 100.0 * worst),
          "see above; on flat ground it is the start, from postures that are no tripod's"};
}

std::vector<Verdict> judge(const std::vector<Ground>& grounds) {
  const Ground& flat = grounds.front();
  const int failed = failures(grounds);
  int walks = 0, violations = 0;
  for (const Ground& ground : grounds)
    for (const auto& of_gait : ground.walks)
      for (const Walk& w : of_gait) {
        ++walks;
        violations += w.summary.rule1_violations;
      }
  const Verdict unadjusted = judge_level(flat, kUnadjusted, true, "");
  Verdict settled =
      judge_level(flat, kFree, true,
                  "After the start transient the free gait performs at the tripod's level (99 %)");
  settled.why_not =
      "legs that lift one by one, each when its own neighbours stand, keep small differences in "
      "step time alive that the tripod controller wipes out at every tripod";
  return {judge_slower(grounds),
          settled,
          {"Only if the CCN is adjusted",
           !unadjusted.holds,
           "without adjustment " + unadjusted.numbers,
           {}},
          judge_ahead(grounds),
          judge_never_below(grounds),
          {"It negotiates all of it, and no two neighbours are told to lift together",
           failed == 0 && violations == 0,
           fmt::format("{} of {} walks stuck or fallen, rule 1 broken {} times", failed, walks,
                       violations),
           "stuck where a foot is trapped, as the paper has it, \"on some rare occasions\""}};
}

figures::Table write_tables(figures::StagedFiles& files, const std::vector<Ground>& grounds) {
  figures::Table table{{"terrain", "gait", "speed ± CI95 [cm/s]", "after the start",
                        "ahead of tripod", "steps", "stuck or fallen"},
                       {}};
  figures::Csv means(
      "gait_number,roughness_cm,mean_cm_s,half_width_95,ahead_cm_s,ahead_half_width_95");
  figures::Csv trials(
      "gait_number,roughness_cm,seed,speed_cm_s,settled_cm_s,steps,tripod_after,blocked,searches,"
      "slip_m,pitch_max_rad,ok,hash");
  for (const Ground& ground : grounds)
    for (const Gait gait : {kTripod, kFree, kUnadjusted}) {
      const statistics::Estimate speed = statistics::estimate(ground.speeds(gait)),
                                 ahead = ground.ahead(gait);
      means.row(static_cast<int>(gait), ground.roughness, speed.mean, speed.half_width, ahead.mean,
                ahead.half_width);
      int seed = 0, steps = 0, failed = 0;
      for (const auto& [s, settled] : ground.walks[gait]) {
        trials.row(static_cast<int>(gait), ground.roughness, ++seed, 1e2 * s.speed, 1e2 * settled,
                   s.steps, s.tripod_after_steps.value_or(-1), s.blocked, s.searches, s.slip_mean,
                   s.pitch_max, s.ok(), fmt::format("{:016x}", s.state_hash));
        steps += s.steps;
        failed += !s.ok();
      }
      table.rows.push_back({ground.terrain(), kGaits[gait], spelt(speed),
                            spelt(statistics::estimate(ground.settled_speeds(gait))),
                            gait == kTripod ? "–" : spelt(ahead), std::to_string(steps),
                            std::to_string(failed)});
    }
  files.write("fig7_physics-means.csv", means.text());
  files.write("fig7_physics-trials.csv", trials.text());
  return table;
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
  figures::draw_figure(
      files,
      context.figure("fig7_physics", 1400, 640,
                     "Genghis in Box2D: speed over the roughness of the ground",
                     fmt::format("{} random postures and grounds, {:.0f} s each, the same for "
                                 "every gait · bars: 95 % confidence intervals · after [PC04] "
                                 "Fig. 7",
                                 kSeeds, kSeconds)),
      {}, scripts::pc04::fig7_physics);
  return {.verdicts = judge(grounds),
          .settings = {{"robot", "genghis2d"},
                       {"seeds", std::to_string(kSeeds)},
                       {"seconds", fmt::format("{}", kSeconds)},
                       {"random_posture_m", fmt::format("{}", kPosture)}},
          .table = table,
          .compute_seconds = seconds.count()};
}

}  // namespace hexagait::experiments
