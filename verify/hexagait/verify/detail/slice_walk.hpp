// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/verify/detail/situation.hpp>

namespace hexagait::verify {

/// The slice model of [PC04] 5.1 on flat ground, in its units: a step puts the foot 25 ahead of its
/// workspace centre, and per slice the body goes on until the feet, those in the air included, are
/// on average at their centres. Here lags are not made but come about.
class SliceWalk {
 public:
  /// Feet in the order that the state asks for, 2 units apart, about their centres; those in the
  /// air ahead.
  SliceWalk(const Rules& rules, const Situation& start, int step_time, Adjustment adjustment);

  /// Landings, a decision, lifts; then the body moves.
  /// @returns the legs that lifted
  LegSet advance();

  [[nodiscard]] double travelled() const { return travelled_; }
  [[nodiscard]] const GaitState& state() const { return legs_.state; }

 private:
  const Rules& rules_;
  int step_time_;
  gait_state::GaitParams params_;
  Situation legs_;
  LegArray<double> foot_;  // ahead of its centre
  gait_state::GaitLatch latch_;
  double travelled_ = 0.0;
};

}  // namespace hexagait::verify
