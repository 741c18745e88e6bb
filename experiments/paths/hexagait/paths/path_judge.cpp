// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/experiments/walk_checks.hpp>
#include <hexagait/paths/path_judge.hpp>

namespace hexagait::experiments {
namespace {

using walk::LocalisedBy;

std::vector<PathWalk> those(const std::vector<PathWalk>& walks, const auto& predicate) {
  std::vector<PathWalk> some;
  for (const PathWalk& walk : walks)
    if (predicate(walk)) some.push_back(walk);
  return some;
}

bool is_flat(const PathWalk& walk) { return walk.terrain == "flat"; }
bool arrived(const PathWalk& walk) { return walk.summary.arrived && walk.summary.ok(); }
bool is_square(const PathWalk& walk) { return walk.shape == "square"; }

double mean_off(const PathWalk& walk) { return 1e2 * walk.summary.lateral_mean; }         // [cm]
double believed(const PathWalk& walk) { return 1e2 * walk.summary.path->believed_mean; }  // [cm]
double missed(const PathWalk& walk) { return walk.summary.path->missed / walk.look_ahead; }

}  // namespace

std::vector<Verdict> judge_paths(const std::vector<PathWalk>& walks) {
  const auto flat = those(walks, is_flat);
  const auto flat_eight = those(flat, [](const auto& w) { return !is_square(w); });
  const auto flat_square = those(flat, is_square);
  const auto rough = those(walks, [](const auto& w) { return !is_flat(w); });
  const auto rough_arrived = those(rough, arrived);
  const auto given =
      those(rough_arrived, [](const auto& w) { return w.localised_by == LocalisedBy::truth; });
  const auto own =
      those(rough_arrived, [](const auto& w) { return w.localised_by == LocalisedBy::odometry; });
  return {
      {.claim = "On flat ground a figure of eight and a square are kept, and walked to the end",
       .safety = no_fall(summaries(flat)),
       .checks = {{{"arrive", share_of(flat, arrived)}, exactly(100.0)},
                  {{"mean distance from the figure of eight, worst", "cm",
                    worst(flat_eight, mean_off)},
                   at_most(0.3)},
                  {{"mean distance from the square, worst", "cm", worst(flat_square, mean_off)},
                   at_most(1.0)},
                  {{"corner of the square missed by, of the look-ahead, worst", "",
                    worst(flat_square, missed)},
                   at_most(0.4)}}},
      {.claim = "Over boxes of up to 15 cm they are kept as well as the place is known",
       .safety = {},
       .checks =
           {{{"arrive", share_of(rough, arrived)}, at_least(75.0)},
            {{"mean distance from the path, place given, worst of those that arrive", "cm",
              worst(given, mean_off)},
             at_most(2.0)},
            {{"mean distance of odometry from the path, by odometry, worst of those that arrive",
              "cm", worst(own, believed)},
             at_most(2.0)}},
       .remark = own.empty()
                     ? ""
                     : fmt::format("by odometry they are in truth off the path by {:.1f} cm on "
                                   "average in the worst of them, since it drifts",
                                   worst(own, mean_off))}};
}

}  // namespace hexagait::experiments
