// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/settle.hpp>
#include <hexagait/verify/detail/situations.hpp>
#include <hexagait/verify/detail/theorems.hpp>

namespace hexagait::verify {

using namespace gait_state;

namespace {

bool is_tripod(LegSet legs, int n) { return legs == first_tripod(n) || legs == second_tripod(n); }

/// Explores all situations of one scene, for one T.
class Exploration {
 public:
  Exploration(Theorem& theorem, const Rules& rules, int n, int step_time, Scene scene)
      : theorem_(theorem),
        n_(n),
        step_time_(step_time),
        scene_(scene),
        slices_(rules, n, step_time, Adjustment::latched),
        situations_(balanced_states(n), step_time, scene),
        memo_(situations_.size(), 0) {}

  void run() {
    situations_.for_each_start([this](const Situation& start) { from(start); });
    const int bound = scene_ == Scene::all ? n_ / 2 * step_time_ - 1 : (n_ / 2 - 1) * step_time_;
    theorem_.check(worst_ <= bound, [&] {
      return fmt::format("a transient of {} slices from {}", worst_, where(slowest_));
    });
    theorem_.cases += count_;
    theorem_.table.add(n_, to_string(scene_), step_time_, count_, worst_, bound);
  }

 private:
  void from(const Situation& start) {
    if (!theorem_.holds()) return;
    const int slices = settle(
        start, memo_, [this](const Situation& s) { return situations_.key(s); },
        [this](const Situation& s) { return next(s); },
        [this](std::span<const Situation> cycle) { inspect(cycle); });
    // Counted from the lifts of the first slice.
    const int transient = std::max(0, slices - 1);
    if (transient > worst_) slowest_ = start;
    worst_ = std::max(worst_, transient);
    ++count_;
  }

  /// A wrong slice leads back to its start: a cycle that is not the tripod gait.
  Situation next(const Situation& before) {
    const Slice slice = slices_.advance(before);
    const auto words = [&] { return fmt::format("{} → {}", where(before), to_string(slice.next)); };
    const bool good = theorem_.check(is_step(slice) && keeps_rule_1(slice), words);
    return good ? slice.next : before;
  }

  /// Checks that a cycle consists of alternate whole tripods, T slices each.
  void inspect(std::span<const Situation> cycle) {
    LegSet all;
    bool whole = static_cast<int>(cycle.size()) == 2 * step_time_;
    for (const Situation& s : cycle) {
      const LegSet lifted = slices_.advance(s).lifted;
      whole = whole && (lifted.empty() || is_tripod(lifted, n_));
      all = all | lifted;
    }
    theorem_.check(whole && all == LegSet::all(n_),
                   [&] { return "it ends in another cycle, at " + where(cycle.front()); });
  }

  [[nodiscard]] std::string where(const Situation& s) const {
    return fmt::format("{} with T = {}", to_string(s), step_time_);
  }

  Theorem& theorem_;
  int n_, step_time_;
  Scene scene_;
  Slices slices_;
  Situations situations_;
  std::vector<std::int16_t> memo_;
  std::int64_t count_ = 0;
  int worst_ = 0;
  Situation slowest_;
};

/// Largest T up to which all situations of n legs are explored.
int all_until(int n, const Scope& scope) {
  if (n > 8) return 0;
  return n == 8 ? std::min(scope.step_time, scope.step_time_8) : scope.step_time;
}

}  // namespace

Theorem convergence(const Rules& rules, const Scope& scope, const Progress& progress) {
  Theorem theorem;
  theorem.name = "convergence";
  theorem.statement =
      "From CCN = n/2, with equal step times T and legs that step as soon as they may, the tripod "
      "gait appears from every situation, after less than n/2 step times.";
  theorem.convention =
      "A situation is a state with remaining air times 0 … T. In a slice: landings, decision, "
      "lifts. Slices from the first slice's lifts to the first situation of the final cycle. All: "
      "any legs in the air; those that are not < a > at the start have slipped and keep their "
      "relations when they land. Reachable: the legs in the air are < a >. Bound: n T/2 - 1 for "
      "all, (n/2 - 1) T for the reachable ones.";
  theorem.table.columns = {"legs", "situations", "T", "count", "worst_slices", "bound"};
  for (std::size_t i = 0; i < scope.legs.size(); ++i) {
    const int n = scope.legs[i];
    for (int t = 1; t <= all_until(n, scope); ++t)
      Exploration(theorem, rules, n, t, Scene::all).run();
    for (int t = 1; t <= scope.step_time; ++t) {
      Exploration(theorem, rules, n, t, Scene::reachable).run();
      progress((static_cast<double>(i) + t / static_cast<double>(scope.step_time)) /
               static_cast<double>(scope.legs.size()));
    }
  }
  return theorem;
}

}  // namespace hexagait::verify
