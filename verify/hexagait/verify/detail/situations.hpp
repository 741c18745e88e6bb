// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/verify/detail/situation.hpp>
#include <utility>

namespace hexagait::verify {

/// Which legs may be in the air in a start situation.
enum class Scene {
  all,        ///< any legs, including neighbours; those that are not `<a>` have slipped
  reachable,  ///< priority legs, in a step: what a controller can reach
};
[[nodiscard]] const char* to_string(Scene scene);

/// All situations of a set of states with step time T, and those that follow from them (a leg that
/// slipped may be `<a>` by the time it lands). Numbered without gaps.
class Situations {
 public:
  /// @param states  of the same number of legs, not cyclic
  Situations(std::vector<GaitState> states, int step_time, Scene scene);

  /// Number of situations.
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Number of a situation, 0 … size() − 1.
  /// @param situation  one of these
  [[nodiscard]] std::size_t key(const Situation& situation) const;

  /// Visits all start situations: every state with every combination of remaining air times 0 … T.
  /// A leg in the air is in a step if it is `<a>`; otherwise it has slipped.
  template <class Visit>
  void for_each_start(const Visit& visit) const {
    for (const GaitState& state : states_) {
      const LegSet priority = priority_legs(state);
      const LegSet may_fly = scene_ == Scene::all ? LegSet::all(state.n) : priority;
      Situation start{.state = state, .air = {}, .slipped = {}};
      do {
        start.slipped = without(airborne(start), priority);
        visit(std::as_const(start));
      } while (count_up(start, may_fly));
    }
  }

 private:
  bool count_up(Situation& situation, LegSet digits) const;
  [[nodiscard]] std::size_t radix(bool is_priority) const;

  /// Mixed-radix numbers of a state's situations: the first, and the weight of each leg's air time.
  struct Keys {
    std::size_t first = 0;
    std::array<std::size_t, kMaxLegs> weight{};
    LegSet priority;
  };

  std::vector<GaitState> states_;
  int step_time_;
  Scene scene_;
  std::size_t size_ = 0;
  std::vector<Keys> keys_;  // indexed by the state's bits
};

}  // namespace hexagait::verify
