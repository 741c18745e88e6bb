// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/situations.hpp>
#include <hexagait/verify/detail/slice_walk.hpp>
#include <hexagait/verify/detail/theorems.hpp>
#include <limits>
#include <map>

namespace hexagait::verify {

using namespace gait_state;

namespace {

/// Slices until the first whole tripod after which only whole tripods lift, T slices apart; −1 if
/// more than `longest`.
int until_tripods(SliceWalk walk, int n, int step_time, int longest) {
  std::vector<LegSet> lifted;
  for (int i = 0; i <= longest + 2 * step_time; ++i) lifted.push_back(walk.advance());
  int first = -1;
  LegSet last;
  for (int i = longest + 2 * step_time; i >= 0; --i) {
    const LegSet now = lifted[static_cast<std::size_t>(i)];
    if (now.empty()) continue;
    const bool whole = now == first_tripod(n) || now == second_tripod(n);
    const bool in_turn = first < 0 || (now != last && first - i == step_time);
    if (!whole || !in_turn) break;
    first = i;
    last = now;
  }
  return first >= 0 && first <= longest ? first : -1;
}

}  // namespace

Theorem latched_convergence(const Rules& rules, const Scope& scope) {
  Theorem theorem;
  theorem.name = "latched_convergence";
  theorem.statement =
      "With the latched adjustment (gait 4) the tripod gait appears from every state, whatever its "
      "CCN, as soon as from CCN = n/2.";
  theorem.convention =
      "Every state, every set of remaining air times 0 … T of priority legs, T = 1 up to the one "
      "given. In the slice model: feet start in the state's order, and lags follow. Slices until "
      "whole tripods lift alternately from then on, the worst for the greatest T; bound "
      "(n/2 - 1) T.";
  theorem.table.columns = {"legs", "T_up_to", "situations", "worst_slices", "bound"};
  for (const int n : scope.legs) {
    const int longest = n > 8 ? std::min(scope.step_time, 2) : scope.step_time;
    std::int64_t starts = 0;
    int worst = 0;
    for (int t = 1; t <= longest; ++t) {
      const Situations situations(non_cyclic_states(n), t, Scene::reachable);
      const int bound = (n / 2 - 1) * t;
      situations.for_each_start([&](const Situation& start) {
        const SliceWalk walk(rules, start, t, Adjustment::latched);
        const int slices = until_tripods(walk, n, t, bound);
        theorem.check(slices >= 0, [&] {
          return fmt::format("no tripod gait after {} slices from {} with T = {}", bound,
                             to_string(start), t);
        });
        if (t == longest) worst = std::max(worst, slices);
        ++starts;
      });
    }
    theorem.cases += starts;
    theorem.table.add(n, longest, starts, worst, (n / 2 - 1) * longest);
  }
  return theorem;
}

namespace {

constexpr int kStepTime = 6;  // 1 slice up and forward, 5 down

struct Speeds {
  std::int64_t starts = 0;
  double slowest = std::numeric_limits<double>::infinity(), fastest = 0.0;
};

/// Settled speed of a walk without adjustment, relative to the 50 units per step of the tripod
/// gait.
double settled_speed(SliceWalk& walk) {
  constexpr int kSettling = 720, kMeasured = 360;  // whole cycles of 12, 18 and 36 slices
  for (int i = 0; i < kSettling; ++i) walk.advance();
  const double before = walk.travelled();
  for (int i = 0; i < kMeasured; ++i) walk.advance();
  return (walk.travelled() - before) / kMeasured / (50.0 / kStepTime);
}

}  // namespace

Theorem speed(const Rules& rules, const Scope&) {
  Theorem theorem;
  theorem.name = "speed";
  theorem.statement =
      "Without adjustment speed falls faster than m: to 1/5 of the tripod gait's for m = 1; for m "
      "= 2 "
      "it is in between and depends on the phases of the legs.";
  theorem.convention =
      "The slice model of [PC04] 5.1 on flat ground, six legs, T = 6, no adjustment. "
      "Relative to 50 units in 6 slices, over 360 slices after 720. With equal strokes it would be "
      "m / (6 - m).";
  theorem.table.columns = {"CCN", "start", "situations", "slowest", "fastest", "equal_strokes"};

  std::map<std::pair<int, bool>, Speeds> table;
  const Situations situations(non_cyclic_states(kLegs), kStepTime, Scene::reachable);
  situations.for_each_start([&](const Situation& start) {
    const int ccn = start.state.ccn(), m = std::min(ccn, kLegs - ccn);
    SliceWalk walk(rules, start, kStepTime, Adjustment::none);
    const double speed = settled_speed(walk);
    const double least = m == 3 ? 1.0 : 0.2, most = m == 1 ? 0.2 : 1.0;
    theorem.check(least - 1e-9 < speed && speed < most + 1e-9 && walk.state().ccn() == ccn,
                  [&] { return fmt::format("{:.4f} from {}", speed, to_string(start)); });
    for (const bool stands : {true, false}) {
      if (stands && !airborne(start).empty()) continue;
      Speeds& speeds = table[{ccn, stands}];
      ++speeds.starts;
      speeds.slowest = std::min(speeds.slowest, speed);
      speeds.fastest = std::max(speeds.fastest, speed);
    }
    ++theorem.cases;
  });
  for (const auto& [key, speeds] : table) {
    const auto& [ccn, stands] = key;
    const double m = std::min(ccn, kLegs - ccn);
    theorem.table.add(ccn, stands ? "all stand" : "reachable", speeds.starts, speeds.slowest,
                      speeds.fastest, m / (kLegs - m));
  }
  return theorem;
}

}  // namespace hexagait::verify
