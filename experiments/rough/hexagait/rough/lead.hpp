// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>
#include <span>

namespace hexagait::experiments {

/// By how much a free gait can be ahead of the waiting tripod, by the times that steps take over boxes.
Outcome lead(const ExperimentContext& context, figures::StagedFiles& files);

/// Whom a leg waits for before it lifts.
enum class WaitsFor {
  neighbours,  ///< rule 1: both have landed
  tripod,      ///< the three legs of the other tripod have
};

/// The mean time from the steps of one tripod to those of the other, of six legs that take turns with their
/// neighbours and lift as soon as those that they wait for have landed; nothing else is waited for [s].
/// @param step_times  of the steps, each drawn from these [s]; not empty
/// @param turns       how many
[[nodiscard]] double time_of_turn(std::span<const double> step_times, WaitsFor waits_for,
                                  int turns);

/// The times of the steps of a walk, and from lift to lift.
struct StepTimes {
  std::vector<double>
      steps;  ///< from lift until a neighbour may step: the foot has touched for touch_time [s]
  std::vector<double> cycles;  ///< of a leg, from lift to lift [s]
};

/// The steps of the free gait over boxes of one height.
struct LeadPoint {
  double height = 0.0;  ///< of the boxes [m]
  StepTimes times;
};

/// The lead that the step times allow is less than 5 %.
[[nodiscard]] Verdict judge_lead_of_step_times(std::span<const LeadPoint> points);

}  // namespace hexagait::experiments
