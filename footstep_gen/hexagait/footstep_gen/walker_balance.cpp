// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/executor/lateness.hpp>
#include <hexagait/footstep_gen/detail/stance_from_above.hpp>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/model/leg_weight.hpp>

/// Which legs of a Walker may lift, for balance, and where its body goes for those that wait.
namespace hexagait::footstep_gen {
namespace {

constexpr double kLevel = 0.5;     // of the step height: prints that differ by less
constexpr double kPrompt = 0.015;  // of the time of a lift: drives that need no more balance

// Is a path steep? 0 up to a slope of 14°, 1 from 24° on, by its sine: those over boxes seldom come so far.
double steepness(double sine) noexcept {
  constexpr double kGentle = 0.25, kSteep = 0.40;
  return std::clamp((sine - kGentle) / (kSteep - kGentle), 0.0, 1.0);
}

}  // namespace

double Walker::last_lift() const noexcept {
  return *std::ranges::max_element(memory_.stepper.lifted_at);
}

// A foot that is ahead already may step where it stands, again and again, while another leg waits: that gains nothing.
void Walker::note_gain() noexcept {
  for (LegId i = 0; i < model_->num_legs(); ++i)
    if (record_.lifts.contains(i) && record_.gait_input.lag[i] > 0.0) last_gain_ = time();
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

// How late the drives are for balance: 0 up to a share kPrompt of a lift, 1 from twice as much on.
double Walker::late() const noexcept {
  return lateness(executor_.least_drive_lag(), kPrompt * params_.executor.swing.lift_time);
}

// Sine of how steeply the path leads up, as the body lies.
double Walker::climb() const noexcept {
  const Vector2& way = record_.arc.per_metre.v;
  const double length = way.norm();
  return length > 0.0 ? record_.state.X_OB.R.row(2).head<2>().dot(way) / length : 0.0;
}

// The same of how steeply it leads down very rough ground; 0 on other ground.
double Walker::descent() const noexcept { return record_.very_rough ? -climb() : 0.0; }

// Centre of mass by which the robot keeps its balance, (balance 2).
Vector3 Walker::balanced_mass() const noexcept {
  const double share = steepness(std::abs(descent()));
  if (share <= 0.0) return model_->p_BM;
  return model_->p_BM + share * (centre_of_mass(*model_, record_.state.q) - model_->p_BM);
}

// (balance 1), (balance 2). With a leg lost a leg may wait where all stand and nothing else moves the body, which goes
// farther than it must then: the last of the way is slow.
Walker::AskedBalance Walker::asked_balance() const noexcept {
  const double margin = params_.step.stability_margin;
  if (!lost_legs().empty()) return {.margin = margin, .beyond = 2.0, .steps = 2.0};
  if (!record_.very_rough) return {};
  // Odometry's tilt is off by some degrees on the way down; an inertial unit's is not.
  const double more = record_.measurement.imu ? 1.0 : 2.0;
  return {.margin = 3.0 * (1.0 + late()) * margin,
          .beyond = 1.0,
          .steps = 4.0,
          .base = (1.0 + more * steepness(descent())) * margin};
}

// All of the margin at first; who waits for it for long does without.
double Walker::balance_margin() const noexcept {
  const AskedBalance asked = asked_balance();
  const double last = lost_legs().empty() ? last_gain_ : std::max(last_lift(), balance_.since);
  const double waited = time() - last;
  const double step = memory_.stepper.longest_step(gait_here());
  const double left = asked.steps * step - waited;
  return left > 0.0 ? asked.margin * std::min(1.0, left / step) : 0.0;
}

LegSet Walker::steady(LegSet legs) const noexcept {
  if (crawls()) return legs;
  legs = without(legs, record_.escape.held);
  if (too_soon()) return {};
  const auto [feet, p_M] = stance_from_above(executor_, record_.state.X_OB.R);
  const LegSet lifts =
      steady_lifts(feet, p_M, executor_.support(), legs, record_.gait_input.lag, balance_margin());
  if (!one_at_a_time() || lifts.empty()) return lifts;
  return LegSet(1U << hindmost(lifts, record_.gait_input.lag));
}

// Rule 1.
LegSet Walker::may_crawl() const noexcept {
  if (!record_.heading.moving()) return {};
  const int n = model_->num_legs();
  const LegSet support = executor_.support();
  return without(support, gait_state::neighbours_of(without(LegSet::all(n), support), ring()));
}

// Legs that begin no step when they lose their contact, by rule 1: a neighbour is up. They don't wait for one on its
// way down, which may look for the ground for long.
LegSet Walker::beside_steps() const noexcept {
  LegSet up;
  for (LegId i = 0; i < model_->num_legs(); ++i) up.set(i, is_up(executor_.legs()[i].phase));
  return gait_state::neighbours_of(up, ring());
}

LiftGateDecision Walker::gate() noexcept {
  const int n = model_->num_legs();
  const Matrix3& R_OB = record_.state.X_OB.R;
  const Vector2 path = record_.arc.per_metre.v;
  const auto [feet, p_M] = stance_from_above(executor_, R_OB);
  LiftGateInput in{.feet = feet,
                   .p_M = p_M,
                   .support = executor_.support(),
                   .may_step = may_crawl(),
                   .lag = record_.gait_input.lag,
                   .along = LegArray<double>(n, 0.0),
                   .path = (R_OB * Vector3(path.x(), path.y(), 0.0)).head<2>(),
                   .margin = params_.step.lift_margin};
  for (LegId i = 0; i < n; ++i)
    in.along[i] = record_.arc.direction[i].dot(stance().p_BC[i].head<2>());
  LiftGateDecision decision = gate_.update(in);
  decision.sway = R_OB.topLeftCorner<2, 2>().transpose() * decision.sway;
  return decision;
}

void Walker::wait_for_balance() noexcept {
  // Whose turn to lift has not come yet does not wait for balance.
  if (too_soon()) record_.waits = {};
  balance_.update({.time = time(),
                   .last_lift = last_lift(),
                   .patience = asked_balance().steps * memory_.stepper.longest_step(),
                   .waits = record_.waits,
                   .support = executor_.support(),
                   .ring = ring()});
}

// Displacement of the body after which the waiting leg that lags most may lift.
Vector2 Walker::way_for_waiting() const noexcept {
  const LegId next = hindmost(record_.waits, record_.gait_input.lag);
  const Matrix3& R_OB = record_.state.X_OB.R;
  const auto [feet, p_M] = stance_from_above(executor_, R_OB);
  const LegSet rest = without(executor_.support(), LegSet(1U << next));
  const AskedBalance asked = asked_balance();
  return R_OB.topLeftCorner<2, 2>().transpose() *
         way_over(feet, p_M, rest, asked.beyond * asked.margin);
}

}  // namespace hexagait::footstep_gen
