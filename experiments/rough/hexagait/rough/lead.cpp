// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// Waiting for two neighbours takes less time than waiting for three legs, by as much as the times of steps differ. That
// is the whole lead of a free gait whose steps take turns, as they do once it has become the tripod.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <hexagait/experiments/on_workers.hpp>
#include <hexagait/experiments/walks.hpp>
#include <hexagait/rough/lead.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/statistics/statistics.hpp>
#include <optional>

namespace hexagait::experiments {
namespace {

constexpr std::uint64_t kTerrains = 20;
constexpr std::array kBoxes = {0.15, 0.20};  // [m]
constexpr int kTurns = 20000;

StepTimes step_times(const ExperimentContext& context, const recording::Simulation& simulation) {
  struct Leg {
    std::optional<double> lifted;
    bool steps = false;
  };
  LegArray<Leg> legs(context.robot->num_legs());
  StepTimes times;
  const auto observe = [&](const footstep_gen::TickRecord& record, const GroundTruth&,
                           const auto&) {
    const double now = record.state.time;
    for (LegId i = 0; i < legs.size(); ++i) {
      Leg& leg = legs[i];
      const LegLane& lane = record.legs[i];
      if (leg.steps && lane.phase == LegPhase::support && lane.believed) {
        times.steps.push_back(now - *leg.lifted);
        leg.steps = false;
      }
      if (!record.lifts.contains(i)) continue;
      if (leg.lifted) times.cycles.push_back(now - *leg.lifted);
      leg = {now, true};
    }
  };
  const walk::Summary walked =
      recording::simulate(*context.robot, simulation, observe, context.stop);
  return walked.fell ? StepTimes{} : times;
}

}  // namespace

double time_of_turn(std::span<const double> step_times, WaitsFor waits_for, int turns) {
  constexpr int kLegs = 6;
  RandomSequence random{.seed = 1, .stream = RandomStream::test};
  const auto step_time = [&] {
    return step_times[static_cast<std::size_t>(random.u01() *
                                               static_cast<double>(step_times.size()))];
  };
  std::array<double, kLegs> landed{};  // by place in the ring: even and odd ones take turns
  for (int turn = 0; turn < turns; ++turn) {
    const std::array<double, kLegs> before = landed;
    for (std::size_t leg = static_cast<std::size_t>(turn % 2); leg < kLegs; leg += 2) {
      const double left = before[(leg + 1) % kLegs], right = before[(leg + kLegs - 1) % kLegs];
      const double opposite = before[(leg + kLegs / 2) % kLegs];
      double lifts = std::max({before[leg], left, right});
      if (waits_for == WaitsFor::tripod) lifts = std::max(lifts, opposite);
      landed[leg] = lifts + step_time();
    }
  }
  return *std::ranges::max_element(landed) / turns;
}

Verdict judge_lead_of_step_times(std::span<const LeadPoint> points) {
  Verdict verdict{.claim =
                      "The free gait can be 5 % ahead of the waiting tripod: it waits for two "
                      "legs, not for three"};
  for (const LeadPoint& point : points) {
    const double free = time_of_turn(point.times.steps, WaitsFor::neighbours, kTurns);
    const double tripod = time_of_turn(point.times.steps, WaitsFor::tripod, kTurns);
    const std::string where = fmt::format("over boxes of {:g} cm", 100.0 * point.height);
    verdict.checks.emplace_back(
        Measured{"time from lift to lift " + where + ", of that by the model", "%",
                 100.0 * statistics::estimate(point.times.cycles).mean / (2.0 * free),
                 fmt::format("of {} steps, {:.2f} s on average", point.times.steps.size(),
                             statistics::estimate(point.times.steps).mean)},
        between(95.0, 110.0));
    verdict.checks.push_back(
        Check({"lead " + where + " that the step times allow", "%", 100.0 * (tripod / free - 1.0)},
              at_least(5.0))
            .expected_to_fail(between(1.5, 5.0), "steps differ too little in time"));
  }
  return verdict;
}

Outcome lead(const ExperimentContext& context, figures::StagedFiles& files) {
  std::vector<std::pair<double, recording::Simulation>> walks;
  for (const double height : kBoxes)
    for (const JudgedWalk& walk :
         over_terrain(fmt::format("boxes:{:g}", height), context.short_form ? 1 : kTerrains,
                      context.short_form ? 1.0 : 5.0)) {
      walks.emplace_back(height, walk.simulation);
      walks.back().second.plant = context.plant;
    }
  std::vector<StepTimes> times(walks.size());
  const auto work = [&](std::size_t k) { times[k] = step_times(context, walks[k].second); };
  if (!on_workers(context, walks.size(), context.jobs, work, [](std::size_t) {})) return {};

  std::vector<LeadPoint> points;
  figures::Csv table("height_m,walk,step_time_s");
  for (std::size_t k = 0; k < walks.size(); ++k) {
    if (points.empty() || points.back().height != walks[k].first)
      points.push_back({walks[k].first, {}});
    StepTimes& all = points.back().times;
    all.steps.insert(all.steps.end(), times[k].steps.begin(), times[k].steps.end());
    all.cycles.insert(all.cycles.end(), times[k].cycles.begin(), times[k].cycles.end());
    for (const double time : times[k].steps) table.row(walks[k].first, k, time);
  }
  files.write("lead.csv", table.text());
  show(*context.robot, walks.front().second, context);
  return {.verdicts = judged_in_full_only(std::vector{judge_lead_of_step_times(points)},
                                          context.short_form),
          .settings = {{"robot", context.robot->name}, {"walks", std::to_string(walks.size())}},
          .provenance =
              recording::provenance(context.robot->name, *context.robot, walks.front().second),
          .table = table};
}

}  // namespace hexagait::experiments
