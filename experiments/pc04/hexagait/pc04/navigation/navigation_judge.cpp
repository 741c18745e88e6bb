// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/experiments/walk_checks.hpp>
#include <hexagait/pc04/navigation/navigation_judge.hpp>

namespace hexagait::experiments {
namespace {

using navigation::Reason;

template <class Number>
double fewest(const std::vector<NavigationWalk>& walks, Number number) {
  return statistics::least(each(walks, number));
}

}  // namespace

std::vector<Verdict> judge_navigation(const std::vector<NavigationWalk>& walks) {
  const auto per_hour = [](const NavigationWalk& walk, long count) {
    return 3600.0 * static_cast<double>(count) / walk.summary.seconds;
  };
  double minutes = 0.0, path = 0.0;
  int restarts = 0;
  for (const NavigationWalk& walk : walks) {
    restarts += walk.restarts;
    minutes += walk.summary.seconds / 60.0;
    path += walk.path;
  }
  return {
      {.claim = "Genghis avoids collisions with walls and escapes from cliffs, for an hour",
       .safety = no_fall(summaries(walks)),
       .checks = {{{"walked, of the time asked for, least", "%",
                    100.0 *
                        fewest(walks, [](const auto& w) { return w.summary.seconds / w.asked(); })},
                   at_least(99.9)},
                  {{"walks that got stuck",
                    share_of(walks, [](const auto& w) { return w.summary.stuck; })},
                   exactly(0.0)},
                  {{"a foot below the floor, deepest", "mm",
                    1e3 * worst(walks, [](const auto& w) { return w.deepest; })},
                   below(10.0)}},
       .remark = fmt::format(
           "{:.0f} m in {:.0f} min; blocked twice in a row, its controller started anew {} times",
           path, minutes, restarts)},
      {.claim = "There were walls and cliffs to avoid, and it went about between them",
       .checks = {
           {{"cliffs met, fewest", "per hour",
             fewest(walks, [&](const auto& w) { return per_hour(w, w.met(Reason::cliff)); })},
            at_least(10.0)},
           {{"walls met, fewest", "per hour",
             fewest(walks,
                    [&](const auto& w) {
                      return per_hour(w, w.met(Reason::touch) + w.met(Reason::wall));
                    })},
            at_least(10.0)},
           {{"mean speed, turns included, slowest", "cm/s",
             1e2 * fewest(walks, [](const auto& w) { return w.path / w.summary.seconds; })},
            at_least(2.0)},
           {{"area covered, least", "m²", fewest(walks, [](const auto& w) { return w.area; })},
            at_least(8.0)}}}};
}

}  // namespace hexagait::experiments
