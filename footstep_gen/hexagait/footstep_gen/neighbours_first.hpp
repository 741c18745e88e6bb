// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/gait_state/ring.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait::footstep_gen {

/// Legs that wait until each of their neighbours has stepped: has been off the ground, and stands again. A leg that
/// has failed lags most, so without that it would try again at once, and its neighbours would never step. A value.
class NeighboursFirst {
 public:
  /// These wait from now on, all at once: not for each other, nor for those that wait already.
  void hold(LegSet legs, const gait_state::Ring& ring) noexcept;
  /// In each tick.
  /// @returns those that still wait
  LegSet update(LegSet standing, const gait_state::Ring& ring) noexcept;
  /// These wait no longer.
  void release(LegSet legs) noexcept { held_ = without(held_, legs); }
  [[nodiscard]] LegSet held() const noexcept { return held_; }

 private:
  struct Waiting {
    LegSet waits_for;  ///< neighbours that have not stepped yet
    LegSet up;         ///< neighbours that have left the ground since the leg waits
  };
  LegSet held_;
  LegArray<Waiting> legs_{kMaxLegs, Waiting{}};
};

}  // namespace hexagait::footstep_gen
