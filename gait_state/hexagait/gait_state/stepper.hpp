// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <hexagait/gait_state/gait_state.hpp>
#include <limits>

/// Which of the legs that may step do so now.
///
/// **Free**: all of them ([PC04] 3.3). On flat ground this converges to the tripod gait.
///
/// **Wave**: all wave gaits have CCN = n/2 and differ only in delays of the rear legs ([PC04] 3.2).
/// Every leg steps as soon as it may, except the two rear legs. A rear leg also waits
///
///     for half a period after the other rear leg lifted, and a whole one after it lifted itself,
///     P = T / (1 − β)                                                               (gait 5)
///
/// with β the duty factor and T the longest of the legs' last step times. β = 1/2 is the tripod
/// gait, 3/4 the tetrapod gait and 5/6 the slow wave of six legs; β may change continuously while
/// walking. The rule only ever delays a leg, so it breaks no rule that the gait state keeps, and no
/// delay lasts longer than a period.
///
/// **Tripod**: waits until all legs stand, then lifts the two tripods in turn, independently of the
/// gait state ([PC04] 5.1), except that no leg lifts if none may step. For comparison with the free
/// gait.
namespace hexagait::gait_state {

enum class Stepping : std::uint8_t { free, wave, tripod };

struct StepperParams {
  Stepping stepping = Stepping::free;
  /// β of the wave gaits: fraction of the period in which a leg stands, 1/2 ≤ β < 1.
  double duty_factor = 0.5;
  /// The most that T of (gait 5) is taken to be: a leg that searched for long is not waited for so long again.
  double longest_step = std::numeric_limits<double>::infinity();
};

struct StepperInput {
  double time = 0.0;  ///< in any fixed unit; never decreases
  /// Legs that do not stand: from the update after the one that lifted them, also while they are
  /// still being unloaded, until they bear load again. Otherwise a step would seem to end at once.
  LegSet airborne;
  LegSet may_step;     ///< GaitDecision::may_step
  int rear_edge = -1;  ///< wave: ring edge (gait 1) between the two rear legs; < 0: hindmost_edge()
};

/// The state between updates. A value: a copy continues identically. Does not allocate.
struct Stepper {
  LegArray<double> lifted_at;   ///< time of the last lift; −∞ before the first
  LegArray<double> step_time;   ///< duration of the last step
  LegSet stepping;              ///< lifted, and not yet standing again
  bool second_is_next = false;  ///< tripod: the second tripod lifts next

  /// @param n          number of legs
  /// @param step_time  initial value of the step time
  explicit Stepper(int n = 0, double step_time = 0.0);

  /// @returns the legs that lift now; they are assumed to do so
  [[nodiscard]] LegSet update(const StepperInput& input, const StepperParams& params) noexcept;

  /// T of (gait 5) without its bound.
  [[nodiscard]] double longest_step() const noexcept;
  /// T of (gait 5).
  [[nodiscard]] double longest_step(const StepperParams& params) const noexcept {
    return std::min(longest_step(), params.longest_step);
  }
  /// P of (gait 5).
  [[nodiscard]] double period(const StepperParams& params) const noexcept {
    return longest_step(params) / (1.0 - params.duty_factor);
  }
};

/// The ring edge between the two legs of the last pair: of six legs 4 and 5 (5 and 6 in [PC04]).
[[nodiscard]] constexpr int hindmost_edge(int n) noexcept { return n / 2; }

}  // namespace hexagait::gait_state
