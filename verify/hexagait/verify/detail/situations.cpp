// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/verify/detail/situations.hpp>

namespace hexagait::verify {

using namespace gait_state;

const char* to_string(Scene scene) { return scene == Scene::all ? "all" : "reachable"; }

Situations::Situations(std::vector<GaitState> states, int step_time, Scene scene)
    : states_(std::move(states)),
      step_time_(step_time),
      scene_(scene),
      keys_(std::size_t{1} << states_.front().n) {
  for (const GaitState& state : states_) {
    Keys& keys = keys_[state.bits];
    keys.first = size_;
    keys.priority = priority_legs(state);
    std::size_t count = 1;
    for (LegId leg = 0; leg < state.n; ++leg) {
      keys.weight[static_cast<std::size_t>(leg)] = count;
      count *= radix(keys.priority.contains(leg));
    }
    size_ += count;
  }
}

// Values of a leg's digit: on the ground, T air times in a step, and for a priority leg T after a
// slip.
std::size_t Situations::radix(bool is_priority) const {
  const auto t = static_cast<std::size_t>(step_time_);
  if (scene_ == Scene::reachable) return is_priority ? t + 1 : 1;
  return is_priority ? 2 * t + 1 : t + 1;
}

std::size_t Situations::key(const Situation& situation) const {
  const Keys& keys = keys_[situation.state.bits];
  const LegSet slipped = situation.slipped & keys.priority;
  std::size_t key = keys.first;
  for (std::size_t leg = 0; leg < static_cast<std::size_t>(situation.state.n); ++leg) {
    const int digit =
        situation.air[leg] + (slipped.contains(static_cast<LegId>(leg)) ? step_time_ : 0);
    key += static_cast<std::size_t>(digit) * keys.weight[leg];
  }
  assert(key < size_);
  return key;
}

bool Situations::count_up(Situation& situation, LegSet digits) const {
  for (LegId leg = 0; leg < situation.state.n; ++leg) {
    if (!digits.contains(leg)) continue;
    std::int8_t& digit = situation.air[static_cast<std::size_t>(leg)];
    if (digit < step_time_) return ++digit, true;
    digit = 0;
  }
  return false;
}

}  // namespace hexagait::verify
