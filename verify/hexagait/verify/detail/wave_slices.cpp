// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/verify/detail/wave_slices.hpp>

namespace hexagait::verify {

using namespace gait_state;

WaveSlices::WaveSlices(const Rules& rules, int n, int step_time, int rear_edge, int longest_period)
    : rules_(rules),
      slices_(rules, n, step_time, Adjustment::latched),
      n_(n),
      rear_edge_(rear_edge),
      longest_period_(longest_period) {}

WaveSlice WaveSlices::advance(const WaveSituation& situation, int half_period) const {
  const std::array rear = {leg_at(rear_edge_, n_), leg_at((rear_edge_ + 1) % n_, n_)};
  const StepperParams params{.stepping = Stepping::wave,
                             .duty_factor = 1.0 - slices_.step_time() / (2.0 * half_period)};
  Stepper stepper(n_, slices_.step_time());
  for (std::size_t i = 0; i < 2; ++i) stepper.lifted_at[rear[i]] = -situation.since[i];

  WaveSlice result;
  result.slice = slices_.advance(situation.legs, [&](LegSet may_step, LegSet air) {
    return rules_.step(
        stepper, {.time = 0.0, .airborne = air, .may_step = may_step, .rear_edge = rear_edge_},
        params);
  });
  result.next.legs = result.slice.next;
  for (std::size_t i = 0; i < 2; ++i) {
    const int since = result.slice.lifted.contains(rear[i]) ? 0 : situation.since[i];
    result.next.since[i] = std::min(since + 1, longest_period_);
  }
  return result;
}

WaveSituation WaveSlices::fresh(const Situation& legs) const {
  return {legs, {longest_period_, longest_period_}};
}

std::size_t WaveSlices::key(const Situations& legs, const WaveSituation& situation) const {
  const auto radix = static_cast<std::size_t>(longest_period_ + 1);
  return (legs.key(situation.legs) * radix + static_cast<std::size_t>(situation.since[0])) * radix +
         static_cast<std::size_t>(situation.since[1]);
}

bool is_wave(std::span<const LegSet> lifted, int n, int step_time, int rear_edge) {
  const int period = static_cast<int>(lifted.size());
  const LegId rear = leg_at(rear_edge, n);
  int start = 0;
  while (start < period && !lifted[static_cast<std::size_t>(start)].contains(rear)) ++start;
  if (start == period) return false;
  std::vector<LegSet> expected(lifted.size());
  for (int j = 0; j < n / 2; ++j) {
    const auto at = [&](int slice) -> LegSet& {
      return expected[static_cast<std::size_t>((start + slice) % period)];
    };
    at(j * step_time).insert(leg_at((rear_edge - j + n) % n, n));
    at(j * step_time + period / 2).insert(leg_at((rear_edge + 1 + j) % n, n));
  }
  return std::equal(lifted.begin(), lifted.end(), expected.begin());
}

}  // namespace hexagait::verify
