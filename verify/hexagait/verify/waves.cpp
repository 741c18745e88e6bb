// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/settle.hpp>
#include <hexagait/verify/detail/theorems.hpp>
#include <hexagait/verify/detail/wave_slices.hpp>
#include <unordered_map>

namespace hexagait::verify {

using namespace gait_state;

namespace {

double duty_factor(int step_time, int half_period) { return 1.0 - step_time / (2.0 * half_period); }

std::string least_rotation(std::string text) {
  std::string least = text;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::rotate(text.begin(), text.begin() + 1, text.end());
    least = std::min(least, text);
  }
  return least;
}

/// State types by [PC04] 3.2, over one period.
std::string types_of_the_paper(int step_time, int half_period) {
  if (half_period == step_time) return "DD";
  if (half_period == 2 * step_time) return "BCBC";
  return half_period < 2 * step_time ? "BCDBCD" : "ABCABC";
}

/// The lifts of a period, legs numbered as in [PC04] Fig. 2, simultaneous ones joined by +, from
/// the paper's leg 6 on.
std::string lifts_in_words(std::span<const LegSet> lifted) {
  std::string text;
  for (const LegSet legs : lifted) {
    if (legs.empty()) continue;
    if (!text.empty()) text += ' ';
    bool first = true;
    for (LegId leg = 0; leg < kLegs; ++leg) {
      if (!legs.contains(leg)) continue;
      text += fmt::format("{}{}", first ? "" : "+", leg + 1);
      first = false;
    }
  }
  return text;
}

/// The attractor of one duty factor, and the distance of all situations from it.
class Lock {
 public:
  Lock(Theorem& theorem, const Rules& rules, int step_time, int half_period, int rear_edge,
       int longest_period)
      : theorem_(theorem),
        step_time_(step_time),
        half_period_(half_period),
        rear_edge_(rear_edge),
        situations_(balanced_states(kLegs), step_time, Scene::all),
        slices_(rules, kLegs, step_time, rear_edge, longest_period) {}

  void from(const WaveSituation& start) {
    if (!theorem_.holds()) return;
    worst_ =
        std::max(worst_, settle(
                             start, memo_,
                             [this](const WaveSituation& s) { return slices_.key(situations_, s); },
                             [this](const WaveSituation& s) { return next(s); },
                             [this](std::span<const WaveSituation> cycle) { inspect(cycle); }));
    ++starts_;
  }

  void from_all() {
    situations_.for_each_start([this](const Situation& start) { from(slices_.fresh(start)); });
  }

  [[nodiscard]] std::int64_t starts() const { return starts_; }
  [[nodiscard]] int worst() const { return worst_; }
  [[nodiscard]] const std::string& types() const { return types_; }
  [[nodiscard]] const std::string& lifts() const { return lifts_; }

 private:
  WaveSituation next(const WaveSituation& before) {
    const WaveSlice after = slices_.advance(before, half_period_);
    const bool good = theorem_.check(is_step(after.slice) && keeps_rule_1(after.slice),
                                     [&] { return where(before); });
    return good ? after.next : before;
  }

  void inspect(std::span<const WaveSituation> cycle) {
    std::vector<LegSet> lifted;
    std::size_t rear = 0;
    for (const WaveSituation& s : cycle) {
      lifted.push_back(slices_.advance(s, half_period_).slice.lifted);
      if (lifted.back().contains(leg_at(rear_edge_, kLegs))) rear = lifted.size() - 1;
    }
    theorem_.check(cycle.size() == static_cast<std::size_t>(2 * half_period_) &&
                       is_wave(lifted, kLegs, step_time_, rear_edge_),
                   [&] { return "another gait: " + where(cycle.front()); });
    std::rotate(lifted.begin(), lifted.begin() + static_cast<std::ptrdiff_t>(rear), lifted.end());
    lifts_ = lifts_in_words(lifted);
    describe_types(cycle, rear);
    theorem_.check(++attractors_ == 1,
                   [&] { return "a second attractor: " + where(cycle.front()); });
  }

  /// The types of the states of a period, one letter per state, starting with the least letter.
  void describe_types(std::span<const WaveSituation> cycle, std::size_t first) {
    types_.clear();
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const GaitState& before = cycle[(first + i) % cycle.size()].legs.state;
      const GaitState& state = cycle[(first + i + 1) % cycle.size()].legs.state;
      if (state != before) types_ += "-ABCD"[static_cast<std::size_t>(type_of(state))];
    }
    types_ = least_rotation(types_);
    theorem_.check(types_ == types_of_the_paper(step_time_, half_period_),
                   [&] { return "types " + types_ + ": " + where(cycle.front()); });
  }

  [[nodiscard]] std::string where(const WaveSituation& s) const {
    return fmt::format("{}; rear edge {}, T = {}, period {}, rear legs lifted {} and {} slices ago",
                       to_string(s.legs), rear_edge_, step_time_, 2 * half_period_, s.since[0],
                       s.since[1]);
  }

  Theorem& theorem_;
  int step_time_, half_period_, rear_edge_;
  Situations situations_;
  WaveSlices slices_;
  std::unordered_map<std::size_t, std::int16_t> memo_;
  std::int64_t starts_ = 0;
  int worst_ = 0, attractors_ = 0;
  std::string types_, lifts_;
};

}  // namespace

Theorem wave_gaits(const Rules& rules, const Scope& scope) {
  Theorem theorem;
  theorem.name = "wave_gaits";
  theorem.statement =
      "Under the rear-leg rule (gait 5) every situation with CCN = 3 converges to the exact wave "
      "gait "
      "of the duty factor, with the state types that [PC04] 3.2 gives.";
  theorem.convention =
      "All situations, as for convergence; T and the period 2h in slices, duty factor 1 - T/2h. "
      "Wave: a leg lifts T after the one behind it, the sides half a period apart. For every edge "
      "of the ring as the rear one where 6 are given, else the hindmost. Slices until the final "
      "cycle; lifts of a period, legs numbered 1 … 6 as in [PC04], + together; types of its "
      "states.";
  theorem.table.columns = {"duty_factor",  "T",     "period", "situations", "rear_edges",
                           "worst_slices", "types", "lifts"};
  for (int t = 1; t <= std::min(scope.step_time, 3); ++t) {
    const int edges = t < 3 ? kLegs : 1;
    for (int half = t; half <= 3 * t; ++half) {
      std::int64_t starts = 0;
      int worst = 0;
      std::string lifts, types;
      for (int e = 0; e < edges; ++e) {
        // The hindmost edge last, so that the table lists the lifts of the paper.
        const int rear_edge = (hindmost_edge(kLegs) + edges - 1 - e) % kLegs;
        Lock lock(theorem, rules, t, half, rear_edge, 2 * half);
        lock.from_all();
        starts += lock.starts();
        worst = std::max(worst, lock.worst());
        lifts = lock.lifts();
        types = lock.types();
      }
      theorem.cases += starts;
      theorem.table.add(duty_factor(t, half), t, 2 * half, starts, edges, worst, types, lifts);
    }
  }
  return theorem;
}

Theorem duty_factor_changes(const Rules& rules, const Scope& scope) {
  Theorem theorem;
  theorem.name = "duty_factor_changes";
  theorem.statement =
      "The duty factor may change at any slice: rule 1 holds, and once it stays constant the gait "
      "converges to the wave gait again.";
  theorem.convention =
      "From the reachable situations with rear legs that have not lifted yet, with every duty "
      "factor "
      "of the list in every slice: all situations that result, including the clocks of the rear "
      "legs, "
      "and from each, with each duty factor, the slices until the final cycle.";
  theorem.table.columns = {"T", "duty_factors", "situations", "worst_slices"};
  const int t = std::min(scope.step_time, 3), longest = 6 * t;
  const Situations situations(balanced_states(kLegs), t, Scene::all);
  const WaveSlices slices(rules, kLegs, t, hindmost_edge(kLegs), longest);

  // All situations that any sequence of duty factors reaches.
  std::unordered_map<std::size_t, bool> seen;
  std::vector<WaveSituation> reached;
  const auto reach = [&](const WaveSituation& s) {
    if (seen.try_emplace(slices.key(situations, s), true).second) reached.push_back(s);
  };
  situations.for_each_start([&](const Situation& s) {
    if (s.slipped.empty()) reach(slices.fresh(s));
  });
  for (std::size_t i = 0; i < reached.size() && theorem.holds(); ++i) {
    for (int half = t; half <= 3 * t; ++half) {
      const WaveSituation before = reached[i];
      const WaveSlice after = slices.advance(before, half);
      if (theorem.check(is_step(after.slice) && keeps_rule_1(after.slice),
                        [&] { return to_string(before.legs); }))
        reach(after.next);
      ++theorem.cases;
    }
  }
  int worst = 0;
  for (int half = t; half <= 3 * t; ++half) {
    Lock lock(theorem, rules, t, half, hindmost_edge(kLegs), longest);
    for (const WaveSituation& s : reached) lock.from(s);
    worst = std::max(worst, lock.worst());
  }
  theorem.table.add(t, 2 * t + 1, static_cast<std::int64_t>(reached.size()), worst);
  return theorem;
}

}  // namespace hexagait::verify
