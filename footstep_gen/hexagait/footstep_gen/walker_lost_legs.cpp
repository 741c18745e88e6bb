// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/detail/stance_from_above.hpp>
#include <hexagait/footstep_gen/walker.hpp>

/// What a Walker does about legs that it loses, and without them.
namespace hexagait::footstep_gen {
namespace {

constexpr double kCatching = 2.5;  // times of a lift, after a leg is lost
constexpr double kWaits = 2.0;     // of the longest step: then it has all the balance it can get
constexpr double kLevel = 0.5;     // of the step height: prints that differ by less

}  // namespace

void Walker::lose_leg(LegId leg) noexcept {
  if (leg < 0 || leg >= model_->num_legs() || lost_legs().contains(leg)) return;
  executor_.lose(leg);
  record_.lost = lost_legs();
  catches_until_ =
      ticks_ + std::lround(kCatching * params_.executor.swing.lift_time / params_.control_dt);
  recentre();
}

// The stance for the legs that there are.
void Walker::recentre() noexcept {
  const LegSet lost = lost_legs();
  level_ = lost.empty() ? stance_of_all_
                        : stance_without(lost, *model_, stance_of_all_, executor_.p_BM().head<2>());
  executor_.set_stance(level_);
  record_.arc = arc_of(record_.heading);
  tracker_.follow(record_.arc.per_metre);
}

void Walker::find_faults() noexcept {
  leg_watch_.watch(*model_, executor_, record_.state, record_.measurement, params_.sensors,
                   watch_.elapsed());
  record_.findings = leg_watch_.findings();
  for (LegId i = 0; !record_.findings.silent.empty() && i < model_->num_legs(); ++i)
    if (record_.findings.silent.contains(i)) lose_leg(i);
}

// Feet that are up when a leg is lost may have left the centre of mass outside those that stand: it falls
// slowly, and they may be there first.
void Walker::catch_fall() noexcept {
  const auto [feet, p_M] = stance_from_above(executor_, record_.state.X_OB.R);
  const SupportPolygon polygon = support_polygon(feet, executor_.support());
  if (stability_margin(polygon, p_M) < -params_.step.stability_margin) executor_.put_down();
}

double Walker::last_lift() const noexcept {
  return *std::ranges::max_element(memory_.stepper.lifted_at);
}

// On about level ground legs lift one after the other: pairs that lift together stop the base between their
// steps. On rough ground no time is given away.
bool Walker::one_at_a_time() const noexcept {
  return !lost_legs().empty() && print_spread_ <= kLevel * params_.step.height;
}

// (lost 2)
bool Walker::too_soon() const noexcept {
  return one_at_a_time() && time() - last_lift() < lift_spacing(memory_.stepper.step_time,
                                                                lost_legs(), ring().size() / 2);
}

// All of the margin at first; who waits for it for long does without.
double Walker::balance_margin() const noexcept {
  const double waited = time() - std::max(last_lift(), balance_.since);
  const double patience = memory_.stepper.longest_step();
  return params_.step.stability_margin * std::clamp(kWaits - waited / patience, 0.0, 1.0);
}

void Walker::wait_for_balance() noexcept {
  // Whose turn to lift has not come yet does not wait for balance.
  if (too_soon()) record_.waits = {};
  balance_.update({.time = time(),
                   .last_lift = last_lift(),
                   .patience = kWaits * memory_.stepper.longest_step(),
                   .waits = record_.waits,
                   .support = executor_.support(),
                   .ring = ring()});
}

// Displacement of the body after which the waiting leg that lags most may lift: with a leg lost, one may
// wait for balance where all stand and nothing else moves the body.
Vector2 Walker::way_for_waiting() const noexcept {
  constexpr double kBeyond = 2.0;  // of the margin that it waits for: the last of the way is slow
  const LegId next = hindmost(record_.waits, record_.gait_input.lag);
  const Matrix3& R_OB = record_.state.X_OB.R;
  const auto [feet, p_M] = stance_from_above(executor_, R_OB);
  const LegSet rest = without(executor_.support(), LegSet(1U << next));
  return R_OB.topLeftCorner<2, 2>().transpose() *
         way_over(feet, p_M, rest, kBeyond * params_.step.stability_margin);
}

}  // namespace hexagait::footstep_gen
