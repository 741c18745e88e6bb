// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/executor/executor.hpp>
#include <hexagait/executor/lateness.hpp>
#include <hexagait/executor/tick_motion.hpp>

/// What the legs do in a tick: those that stand share the load, all of them move.
namespace hexagait {
namespace {

// Drives are not just late: a foot at full speed may be beside the line of (lag 1) by this share of
// the way that it makes within their lag.
constexpr double kUnknownLag = 0.25;

// The loads are evened out at no more than this over the lag of the drives: well damped.
constexpr double kMostLag = 0.25;

// Speed of a standing foot without contact, of that of a touchdown; lag of the drives and the period, together, that are
// short enough for it, of the time of a lift.
constexpr double kPursuit = 0.7, kPursuingLag = 0.02;

}  // namespace

// (executor 2). A foot that can't reach its set point says nothing about its load. The loads of three
// feet follow from where they are: a robot that has four legs crawls on three, and would tilt and drift.
void Executor::even_out_loads(const RobotState& state, double dt) noexcept {
  constexpr double kDeterminate = 3.0;  // feet
  if (!params_.swing.reflexes) return;
  const Vector3 up_B = state.X_OB.R.row(2);
  const auto bears = [this](LegId i) { return legs_[i].fully_loaded() && reachable_[i]; };
  double mean = 0.0, feet = 0.0;
  for (LegId i = 0; i < legs_.size(); ++i) {
    if (!bears(i)) continue;
    mean += up_B.dot(off_[i]);
    ++feet;
  }
  if (feet <= 0.0 || (feet <= kDeterminate && legs_.size() - lost_.size() == 4)) return;
  mean /= feet;
  const double period = std::max(dt, params_.base.displacement_period);
  const double rate = std::min(params_.swing.even_load_rate, kMostLag / (lag_.lag() + period));
  const double share = decay_share(rate * dt);
  for (LegId i = 0; i < legs_.size(); ++i)
    if (bears(i)) legs_[i].p_BF += share * (up_B.dot(off_[i]) - mean) * up_B;
}

// Does a leg that has no contact where it stood have to stay there: is it told to, or would the robot fall without it?
bool Executor::is_needed(LegId leg, const RobotState& state) const noexcept {
  if (!params_.swing.reflexes) return false;
  if (!legs_[leg].lacks_contact()) return false;
  if (staying_.contains(leg)) return true;
  LegArray<Vector3> feet(legs_.size());
  LegSet others;
  for (LegId i = 0; i < legs_.size(); ++i) {
    feet[i] = state.X_OB.R * state.p_BF[i];
    others.set(i, i != leg && legs_[i].on_ground() && legs_[i].without_contact <= 0.0);
  }
  const SupportPolygon polygon = support_polygon(feet, others);
  const Vector3 p_M = state.X_OB.R * p_BM();
  return polygon.size < 3 || stability_margin(polygon, p_M.head<2>()) <= 0.0;
}

void Executor::move_legs(const RobotState& state, double dt) noexcept {
  // (swing 6). A foot whose contact is known late would push itself into the ground, and others off it.
  const double prompt = 1.0 - lateness(lag_.lag() + dt, kPursuingLag * params_.swing.lift_time);
  const double pursuit = prompt * kPursuit * params_.swing.touchdown_speed;
  // (swing 7). Legs whose footholds have changed take one time for it, so that they land together.
  double turn = 0.0;
  for (const LegLane& lane : legs_)
    turn = std::max(turn, turning_time(lane, state.X_OB, params_.swing));
  for (LegId i = 0; i < legs_.size(); ++i) {
    if (lost_.contains(i)) {
      tuck(i, dt);
      continue;
    }
    const double fastest = hastened_max_speed(params_.swing, legs_[i].haste);
    const double unknown = kUnknownLag * fastest * lag_.lag();
    const double error = std::max(0.0, lag_.error(i) - unknown);
    const LegSensed sensed{state.contact[i],    error,   reachable_[i], off_[i],
                           is_needed(i, state), pursuit, turn};
    const LegPhase before = legs_[i].phase;
    if (before == LegPhase::follow)
      follow(legs_[i], plans_[i], sensed, state.X_OB, dt, rate_, params_.swing);
    else
      hexagait::advance(legs_[i], sensed, state.X_OB, dt, params_.swing);
    const bool came_down =
        before == LegPhase::follow || before == LegPhase::search || before == LegPhase::descend;
    if (came_down && legs_[i].phase == LegPhase::support) stand_where_it_is(i, state);
  }
}

// Contact is known up to a period after it was made, and until then the set point of a foot goes on
// into the ground: by 0.2 m/s · 2 · 20 ms = 8 mm, which would lift other feet. Along the normal the
// foot stands where it is measured.
void Executor::stand_where_it_is(LegId leg, const RobotState& state) noexcept {
  const Vector3 normal_B = state.X_OB.R.transpose() * legs_[leg].normal_O;
  const double above = normal_B.dot(state.p_BF[leg] - legs_[leg].p_BF);
  if (above > 0.0) legs_[leg].p_BF += above * normal_B;
}

}  // namespace hexagait
