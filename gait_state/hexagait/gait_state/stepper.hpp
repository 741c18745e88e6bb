// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/gait_state/gait_state.hpp>

/// Who of those that may step does step now.
///
/// **Free**: all of them ([PC04] 3.3). On flat ground that becomes the tripod gait.
///
/// **Wave**: all wave gaits have CCN = n/2 and differ only in delays of the rear legs ([PC04] 3.2).
/// As a rule: every leg steps as soon as it may, except the two rear legs. A rear leg also waits
///
///     half a period after the other rear leg lifted, a whole one after it lifted itself
///     P = T / (1 − β)                                                               (gait 5)
///
/// with β the duty factor, T the longest of the legs' last steps. β = 1/2 is the tripod gait, 3/4
/// the tetrapod, 5/6 the slow wave of six legs, and everything between: one knob, that may be
/// turned while walking. It only ever delays a leg, so it can break no rule that the gait state
/// keeps, and no delay lasts longer than a period.
///
/// **Tripod**: waits until all legs stand, then lifts the two tripods in turn, whatever the gait
/// state ([PC04] 5.1), unless nobody may step: then the robot is to stand. What the free gait is
/// compared with.
namespace hexagait::gait_state {

enum class Stepping : std::uint8_t { free, wave, tripod };

struct StepperParams {
  Stepping stepping = Stepping::free;
  /// β of the wave gaits: share of the period in which a leg stands, 1/2 ≤ β < 1.
  double duty_factor = 0.5;
};

struct StepperInput {
  double time = 0.0;  ///< any unit, the same always; never decreases
  /// Legs that do not stand: from the update after the one that lifted them, even if their feet
  /// are still being unloaded, until they bear load again. Else a step would seem to end at once.
  LegSet airborne;
  LegSet may_step;     ///< GaitDecision::may_step
  int rear_edge = -1;  ///< wave: ring edge (gait 1) between the two rear legs; < 0: the hindmost
};

/// The memory between updates. A value: a copy continues identically. No allocation.
struct Stepper {
  LegArray<double> lifted_at;   ///< last lift, before all time if none
  LegArray<double> step_time;   ///< how long the last step took
  LegSet stepping;              ///< lifted, and not yet seen to stand again
  bool second_is_next = false;  ///< tripod: whose turn it is

  /// @param n  legs
  /// @param step_time  how long a step takes until one has been seen
  explicit Stepper(int n = 0, double step_time = 0.0);

  /// The legs that are to lift now; they are taken to do so.
  [[nodiscard]] LegSet update(const StepperInput& input, const StepperParams& params) noexcept;

  /// T of (gait 5).
  [[nodiscard]] double longest_step() const noexcept;
};

/// The ring edge between the two rearmost legs, by their numbers: for six legs 4 and 5 (5 and 6 in
/// [PC04]).
[[nodiscard]] constexpr int hindmost_edge(int n) noexcept { return n / 2; }

}  // namespace hexagait::gait_state
