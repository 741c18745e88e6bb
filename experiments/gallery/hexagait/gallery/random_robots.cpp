// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// Robots drawn at random: each that can stand walks straight on, along an arc and in place.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/experiments/on_workers.hpp>
#include <hexagait/experiments/walk_checks.hpp>
#include <hexagait/gallery/gallery.hpp>
#include <hexagait/gallery/random_robots.gp.hpp>
#include <hexagait/gallery/random_robots.hpp>
#include <hexagait/urdf/urdf.hpp>

namespace hexagait::experiments {
namespace {

// In short only what is written is of interest: RandomRobots.WalkIfTheyCanStand sees some of them walk.
constexpr std::uint64_t kRobots = 200, kRobotsInShort = 2;

std::vector<RobotTrial> those_that_stand(std::span<const RobotTrial> trials) {
  std::vector<RobotTrial> standing;
  std::ranges::copy_if(trials, std::back_inserter(standing), &RobotTrial::stands);
  return standing;
}

// Robots from seed 1 on.
std::vector<RobotTrial> try_robots(const ExperimentContext& context, std::uint64_t count) {
  std::vector<RobotTrial> trials(count);
  const bool all = all_rows(
      context, "random_robots", count,
      [&](std::uint64_t seed, const std::string& row) { trials[seed - 1] = parse_trial(row); },
      [&](std::uint64_t seed) { trials[seed - 1] = try_robot(random_robot(seed), context.stop); },
      [&](std::uint64_t seed) { return to_line(trials[seed - 1]); });
  return all ? trials : std::vector<RobotTrial>();
}

// 0: walks, 1: does not, 2: fell, 3: can't stand.
int group(const RobotTrial& trial) {
  return !trial.stands() ? 3 : trial.fell() ? 2 : trial.walks_all() ? 0 : 1;
}

void draw(figures::StagedFiles& files, const ExperimentContext& context,
          std::span<const RobotTrial> trials, const Verdict& verdict) {
  figures::Csv points("size_m,mass_kg,legs,speed_m_s,pace_m_s,off_path_percent,group");
  for (const RobotTrial& trial : trials) {
    if (trial.size <= 0.0) continue;
    const bool walked = !trial.walks.empty() && trial.walks[0].seconds > 0.0;
    points.row(trial.size, trial.mass, trial.legs,
               walked ? trial.walks[0].way / trial.walks[0].seconds : std::nan(""), trial.pace,
               100.0 * trial.off_path(), group(trial));
  }
  figures::write_tables(files, "random_robots", {{"points", points}});
  figures::draw_figure(
      files,
      context.figure("random_robots", 1500, 700,
                     fmt::format("{} robots drawn at random", trials.size()), verdict.remark),
      {}, scripts::gallery::random_robots);
}

// The first that can stand.
void show_one(const ExperimentContext& context, std::span<const RobotTrial> trials) {
  const auto first = std::ranges::find_if(trials, &RobotTrial::stands);
  if (first == trials.end()) return;
  const RobotModel robot = parse_urdf(random_robot(first->seed).urdf, "random robot");
  const RobotScale scale = scale_of(robot);
  show(robot, walk_of(straight_on(scale), scale), context);
}

}  // namespace

Verdict judge_random_robots(std::span<const RobotTrial> trials) {
  const std::vector<RobotTrial> standing = those_that_stand(trials);
  const auto off = each(standing, [](const RobotTrial& t) { return 100.0 * t.off_path(); });
  const int kinds[] = {6, 8, 10, 4};
  std::string remark = fmt::format("{} of {} can stand", standing.size(), trials.size());
  for (const int legs : kinds) {
    const auto with = [&](const RobotTrial& t) { return t.legs == legs; };
    const auto all = std::ranges::count_if(standing, with);
    const auto walk = std::ranges::count_if(
        standing, [&](const RobotTrial& t) { return with(t) && t.walks_all(); });
    if (all > 0) remark += fmt::format("; with {} legs {} of {} walk", legs, walk, all);
  }
  return {
      .claim = fmt::format(
          "Of {} robots drawn at random those that can stand walk straight on, along an arc and in "
          "place",
          trials.size()),
      .safety = {{{"robots that fell", share_of(standing, [](const auto& t) { return t.fell(); })},
                  at_most(2.0)}},
      .checks = {{{"robots that do all three",
                   share_of(standing, [](const auto& t) { return t.walks_all(); })},
                  at_least(98.0)},
                 {{"mean distance from the path, of the way, worst of three walks", "%",
                   statistics::estimate(off),
                   fmt::format("worst robot {:.2f} %", statistics::greatest(off))},
                  at_most(2.0)}},
      .remark = remark};
}

figures::Csv table(std::span<const RobotTrial> trials) {
  std::string header = "seed,legs,layout,size_m,mass_kg,pace_m_s,stands,walks";
  for (const char* walk : {"straight", "arc", "spin"})
    header += fmt::format(",{0},{0}_seconds_s,{0}_way_m,{0}_off_path", walk);
  figures::Csv table(header + ",reason");
  for (const RobotTrial& t : trials) {
    const auto walk = [&](std::size_t k) { return t.walks.empty() ? WalkEnd{} : t.walks[k]; };
    std::string reason = t.cannot_stand;
    for (const WalkEnd& w : t.walks)
      if (reason.empty() && !w.walked())
        reason = w.hindrance.empty() ? w.outcome : w.outcome + ": " + w.hindrance;
    const WalkEnd a = walk(0), b = walk(1), c = walk(2);
    table.row(t.seed, t.legs, t.layout, t.size, t.mass, t.pace, t.stands(), t.walks_all(),
              a.outcome, a.seconds, a.way, a.off_path, b.outcome, b.seconds, b.way, b.off_path,
              c.outcome, c.seconds, c.way, c.off_path, reason);
  }
  return table;
}

Outcome random_robots(const ExperimentContext& context, figures::StagedFiles& files) {
  const std::uint64_t usual = context.short_form ? kRobotsInShort : kRobots;
  const std::uint64_t count = context.count > 0 ? context.count : usual;
  const std::vector<RobotTrial> trials = try_robots(context, count);
  if (trials.empty()) return {};
  const figures::Csv rows = table(trials);
  files.write("random_robots.csv", rows.text());
  const Verdict verdict = judge_random_robots(trials);
  draw(files, context, trials, verdict);
  show_one(context, trials);
  return {.verdicts = {judged_in_full_only(verdict, context.short_form)},
          .settings = {{"robots", std::to_string(count)}},
          .table = rows};
}

}  // namespace hexagait::experiments
