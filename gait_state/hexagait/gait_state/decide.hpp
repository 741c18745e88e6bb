// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/gait_state/stepper.hpp>

/// Which legs lift in this tick: the gait state says who may (latch.hpp), the stepper who does
/// (stepper.hpp). Every walker of the library decides by this one function.
namespace hexagait::gait_state {

/// What decides beside the legs themselves.
struct StepConditions {
  double time = 0.0;    ///< see StepperInput
  int rear_edge = -1;   ///< see StepperInput
  bool walking = true;  ///< false: no leg lifts, steps under way still end

  /// Legs that count as standing and feel nothing at this moment: after a bounce, or on an edge. No
  /// neighbour of theirs lifts until they feel the ground again, or count as off it.
  LegSet unsure = {};

  /// Of legs that would lift now, those that balance allows; empty: all. It must fit into a
  /// std::function without allocation: capture no more than a pointer.
  std::function<LegSet(LegSet)> steady = {};

  /// A robot that lifts one leg at a time: those that lift are `open`, whatever relations and stepper.
  bool crawls = false;
  LegSet open = {};
};

struct StepDecision {
  GaitDecision gait;
  LegSet lifts;             ///< legs that lift now
  LegSet waits;             ///< legs that may lift and are held back, by the stepper or a neighbour
  LegSet rule1_violations;  ///< legs that lift with a neighbour that lifts or is off the ground
};

/// The memory of decide(). A value: a copy continues identically. No allocation.
struct GaitMemory {
  GaitLatch latch;
  Stepper stepper;

  /// @param n  legs
  /// @param step_time  how long a step takes until one has been seen, in the unit of time
  explicit GaitMemory(int n = 0, double step_time = 0.0) : stepper(n, step_time) {}
};

/// One update of latch and stepper. Rule 1 ([PC04] 3.1) is checked independently of both.
[[nodiscard]] StepDecision decide(GaitMemory& memory, const GaitInput& legs,
                                  const StepConditions& conditions, const GaitParams& gait,
                                  const StepperParams& stepper) noexcept;

}  // namespace hexagait::gait_state
