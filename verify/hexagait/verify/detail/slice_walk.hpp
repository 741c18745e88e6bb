// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/verify/detail/situation.hpp>

namespace hexagait::verify {

/// The slice model of [PC04] 5.1 on flat ground, in its units: a step puts the foot 25 ahead of its
/// workspace centre, and in each slice the body advances until the feet, including those in the
/// air, are on average at their centres. Lags follow from the walk instead of being constructed.
class SliceWalk {
 public:
  /// Starts with the feet in the order of the state, 2 units apart, around their centres; those in
  /// the air are ahead.
  SliceWalk(const Rules& rules, const Situation& start, int step_time, Adjustment adjustment);

  /// One slice: landings, decision, lifts; then the body moves.
  /// @returns the legs that lifted
  LegSet advance();

  [[nodiscard]] double travelled() const { return travelled_; }
  [[nodiscard]] const GaitState& state() const { return legs_.state; }

 private:
  const Rules& rules_;
  int step_time_;
  gait_state::GaitParams params_;
  Situation legs_;
  LegArray<double> foot_;  // position ahead of the centre
  gait_state::GaitLatch latch_;
  double travelled_ = 0.0;
};

}  // namespace hexagait::verify
