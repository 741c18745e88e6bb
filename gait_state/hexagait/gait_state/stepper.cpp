// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/gait_state/stepper.hpp>
#include <limits>

namespace hexagait::gait_state {
namespace {

// Tolerance for the rounding of summed step times, as a fraction of the period.
constexpr double kRounding = 1e-9;

bool waits(const Stepper& stepper, LegId rear, LegId other_rear, double time, double period) {
  const double due =
      std::max(stepper.lifted_at[rear] + period, stepper.lifted_at[other_rear] + 0.5 * period);
  return time < due - kRounding * period;
}

LegSet wave(const Stepper& stepper, const StepperInput& input, const StepperParams& params) {
  const int n = stepper.lifted_at.size();
  const int edge = input.rear_edge < 0 ? hindmost_edge(n) : input.rear_edge;
  const LegId a = leg_at(edge, n), b = leg_at((edge + 1) % n, n);
  const double period = stepper.period(params);
  LegSet legs = input.may_step;
  if (waits(stepper, a, b, input.time, period)) legs.erase(a);
  if (waits(stepper, b, a, input.time, period)) legs.erase(b);
  return legs;
}

}  // namespace

Stepper::Stepper(int n, double step_time)
    : lifted_at(n, -std::numeric_limits<double>::infinity()), step_time(n, step_time) {}

double Stepper::longest_step() const noexcept {
  double longest = 0.0;
  for (const double time : step_time) longest = std::max(longest, time);
  return longest;
}

LegSet Stepper::update(const StepperInput& input, const StepperParams& params) noexcept {
  const int n = lifted_at.size();
  const LegSet landed = without(stepping, input.airborne);
  for (LegId leg = 0; !landed.empty() && leg < n; ++leg) {
    if (!landed.contains(leg)) continue;
    step_time[leg] = input.time - lifted_at[leg];
    stepping.erase(leg);
  }

  LegSet lifts = input.may_step;
  if (params.stepping == Stepping::wave) lifts = wave(*this, input, params);
  if (params.stepping == Stepping::tripod) {
    lifts = second_is_next ? second_tripod(n) : first_tripod(n);
    if (!input.airborne.empty() || input.may_step.empty()) lifts = LegSet();
    if (!lifts.empty()) second_is_next = !second_is_next;
  }

  for (LegId leg = 0; !lifts.empty() && leg < n; ++leg)
    if (lifts.contains(leg)) lifted_at[leg] = input.time;
  stepping = stepping | lifts;
  return lifts;
}

}  // namespace hexagait::gait_state
