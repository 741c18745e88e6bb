// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/navigation/navigator.hpp>
#include <numbers>

namespace hexagait::navigation {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr double kRetreat = 0.5, kRetreatFromSteep = 2.0;  // of R
constexpr double kLeastRun = 5.0, kMostRun = 20.0;         // of R
constexpr double kPatience = 15.0;                         // of T, the time of a step
constexpr double kProgress = 0.25;                         // of ℓ, the reach of a step

Turn other(Turn turn) { return turn == Turn::ccw ? Turn::cw : Turn::ccw; }

void begin(NavigationState& state, Act act, double goal, double time) {
  state.act = act;
  state.goal = goal;
  state.way = 0.0;
  state.marked_way = 0.0;
  state.marked_time = time;
}

// Straight on, for a length by lot.
void go_on(NavigationState& state, const NavigationParams& params, double time, double lot) {
  begin(state, Act::ahead, params.least_run + lot * (params.most_run - params.least_run), time);
  state.ahead = 0.0;
}

// The first half of the lots turns left, the second right, unless one side is the worse; the place
// within its half is the angle.
void react(NavigationState& state, const Danger& to, const NavigationParams& params, double time,
           double lot) {
  const double angle = 2.0 * lot - std::floor(2.0 * lot);
  state.reason = to.reason;
  ++state.met[static_cast<std::size_t>(to.reason)];
  state.turn = lot < 0.5 ? Turn::ccw : Turn::cw;
  if (to.left != to.right) state.turn = to.left ? Turn::cw : Turn::ccw;
  state.turn_to_come = params.least_turn + angle * (params.most_turn - params.least_turn);

  const bool goes_back = to.reason != Reason::wall && to.reason != Reason::wander;
  const double retreat = to.reason == Reason::steep ? params.retreat_from_steep : params.retreat;
  const double back = std::min(retreat, state.ahead);
  if (goes_back && back > 0.0)
    begin(state, Act::back, back, time);
  else
    begin(state, Act::turn, state.turn_to_come, time);
}

// The way since the last tick, in the direction of the act: [m] or [rad].
double step_of(const NavigationState& state, const PlanarPose& odometry) {
  const PlanarPose step = between(state.last, odometry);
  switch (state.act) {
    case Act::ahead:
      return step.shift.x();
    case Act::back:
      return -step.shift.x();
    case Act::turn:
      return (state.turn == Turn::ccw ? 1.0 : -1.0) * wrap_angle(step.angle);
  }
  return 0.0;
}

// Has it made no progress for too long?
bool is_blocked(NavigationState& state, const NavigationParams& params, double time) {
  const double arm = state.act == Act::turn ? params.foot_circle : 1.0;
  if (arm * (state.way - state.marked_way) > params.progress) {
    state.marked_way = state.way;
    state.marked_time = time;
  }
  return time - state.marked_time > params.patience;
}

void while_ahead(NavigationState& state, const Danger& sensed, bool blocked,
                 const NavigationParams& params, double time, double lot) {
  if (sensed.any)
    react(state, sensed, params, time, lot);
  else if (blocked)
    react(state, {Reason::blocked, true, false, false}, params, time, lot);
  else if (state.way >= state.goal)
    react(state, {Reason::wander, true, false, false}, params, time, lot);
}

void while_turning(NavigationState& state, const Danger& sensed, bool blocked,
                   const NavigationParams& params, double time, double lot) {
  if (blocked) {
    ++state.met[static_cast<std::size_t>(Reason::blocked)];
    state.turn = other(state.turn);
    begin(state, Act::turn, state.goal, time);
  } else if (state.way >= state.goal && !sensed.any) {
    go_on(state, params, time, lot);
  }
}

}  // namespace

const char* to_string(Reason reason) noexcept {
  switch (reason) {
    case Reason::steep:
      return "steep";
    case Reason::cliff:
      return "cliff";
    case Reason::touch:
      return "touch";
    case Reason::wall:
      return "wall";
    case Reason::blocked:
      return "blocked";
    case Reason::wander:
      return "wander";
  }
  return "?";
}

NavigationParams navigation_params_for(const RobotModel& model) {
  const RobotScale scale = scale_of(model);
  const SenseLayout layout = sense_layout_for(model);
  NavigationParams params;
  for (std::size_t k = 0; k < kBeams; ++k) params.to_floor[k] = layout.beams[k].to_floor;
  params.foot_circle = layout.foot_circle;
  params.retreat = kRetreat * layout.foot_circle;
  params.retreat_from_steep = kRetreatFromSteep * layout.foot_circle;
  params.least_run = kLeastRun * layout.foot_circle;
  params.most_run = kMostRun * layout.foot_circle;
  params.patience = kPatience * scale.time;
  params.progress = kProgress * scale.reach;
  return params;
}

Danger danger(const Senses& senses, const NavigationParams& params) noexcept {
  // What is not a number is no floor: a beam that fails stops the robot.
  Danger cliff{.reason = Reason::cliff}, touch{.reason = Reason::touch},
      wall{.reason = Reason::wall};
  for (std::size_t k = 0; k < kBeams; ++k) {
    const double share = senses.range[k] / params.to_floor[k];
    Danger* const seen = !(share <= params.cliff) ? &cliff : share < params.wall ? &wall : nullptr;
    if (seen == nullptr) continue;
    seen->any = true;
    (2 * k < kBeams ? seen->left : seen->right) = true;
  }
  touch.left = senses.touches[0];
  touch.right = senses.touches[1];
  touch.any = touch.left || touch.right;

  if (!(std::abs(senses.pitch) <= params.steep)) return {Reason::steep, true, false, false};
  for (const Danger& one : {cliff, touch, wall})
    if (one.any) return one;
  return {};
}

NavigationState navigate(NavigationState state, const Senses& senses,
                         const NavigationParams& params, double lot) noexcept {
  if (!state.started) {
    go_on(state, params, senses.time, lot);
    state.last = senses.odometry;
    state.started = true;
  }
  const double step = step_of(state, senses.odometry);
  state.last = senses.odometry;
  state.way += step;
  if (state.act == Act::ahead) state.ahead += step;
  if (state.act == Act::back) state.ahead -= step;

  const Danger sensed = danger(senses, params);
  const bool blocked = is_blocked(state, params, senses.time);
  switch (state.act) {
    case Act::ahead:
      while_ahead(state, sensed, blocked, params, senses.time, lot);
      break;
    case Act::back:
      if (state.way >= state.goal || blocked)
        begin(state, Act::turn, state.turn_to_come, senses.time);
      break;
    case Act::turn:
      while_turning(state, sensed, blocked, params, senses.time, lot);
      break;
  }
  return state;
}

Heading heading_of(const NavigationState& state) noexcept {
  switch (state.act) {
    case Act::ahead:
      return Heading::straight(0.0);
    case Act::back:
      return Heading::straight(std::numbers::pi);
    case Act::turn:
      return Heading::spin(state.turn);
  }
  return Heading::stop();
}

}  // namespace hexagait::navigation
