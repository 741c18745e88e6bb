// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/footstep_gen/neighbours_first.hpp>

namespace hexagait::footstep_gen {

void NeighboursFirst::hold(LegSet legs, const gait_state::Ring& ring) noexcept {
  held_ = held_ | legs;
  for (LegId i = 0; i < ring.legs; ++i)
    if (legs.contains(i))
      legs_[i] = {without(gait_state::neighbours_of(LegSet(1U << i), ring), held_), LegSet()};
}

LegSet NeighboursFirst::update(LegSet standing, const gait_state::Ring& ring) noexcept {
  held_ = held_ & ring.present();
  for (LegId i = 0; i < kMaxLegs; ++i) {
    if (!held_.contains(i)) continue;
    auto& [waits_for, up] = legs_[i];
    up = up | without(waits_for, standing);
    waits_for = without(waits_for, up & standing) & ring.present();
    held_.set(i, !waits_for.empty());
  }
  return held_;
}

}  // namespace hexagait::footstep_gen
