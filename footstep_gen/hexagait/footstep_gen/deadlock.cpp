// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/footstep_gen/deadlock.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <hexagait/posture/free_optimum.hpp>

namespace hexagait::footstep_gen {
namespace {

constexpr double kThere = 0.1;    // of the progress: what is left of the way
constexpr double kStands = 0.15;  // of the patience: a body that comes no nearer for so long can't
constexpr double kBehind = 1.0;   // a lag less than any other
constexpr double kOtherPath = 0.5;  // per metre of path: the command is another one

// Way of the outermost foot.
double size(const PlanarTwist& way, double arm) { return way.v.norm() + arm * std::abs(way.w); }

}  // namespace

void Deadlock::wait_from_here(const DeadlockInput& in) noexcept {
  since_ = in.time;
  from_ = in_plane(in.X_OB);
  wait_ = {};
}

void Deadlock::begin(const DeadlockInput& in) noexcept {
  PlanarPose there = in_plane(posture::free_optimum(in.p_BF, in.p_BC, in.standing));
  const double along = in.path.v.dot(there.shift), path2 = in.path.v.squaredNorm();
  if (along < 0.0) there.shift -= (along / path2) * in.path.v;
  ++escape_.tries;
  escape_.phase = EscapePhase::moves;
  escape_.failing = escape_.held = in.failing;
  escape_.way = logarithm(there);
  to_ = in_plane(in.X_OB) * there;
  since_ = nearer_ = in.time;
  nearest_ = size(escape_.way, in.arm);
}

// Or as near as it gets: a standing foot that is at the end of its leg keeps it.
bool Deadlock::is_there(const DeadlockInput& in) noexcept {
  const double left = size(escape_.left, in.arm), near = kThere * in.progress;
  if (left < nearest_ - near) {
    nearest_ = left;
    nearer_ = in.time;
  }
  return left <= near || in.time - nearer_ > kStands * in.patience;
}

Escape Deadlock::update(const DeadlockInput& in) noexcept {
  const bool starts = in.walks && !walked_;
  walked_ = in.walks;
  if (!in.walks || starts) {
    escape_ = {};
    wait_from_here(in);
    return escape_;
  }
  const gait_state::Ring ring(in.p_BF.size(), in.lost);
  const PlanarPose now = in_plane(in.X_OB);
  // In `steps` the neighbours of a failing leg step, and then it tries again.
  const double phases = escape_.phase == EscapePhase::steps ? 2.0 : 1.0;
  const bool long_enough = in.time - since_ > phases * in.patience;
  escape_.left = {};
  switch (escape_.phase) {
    case EscapePhase::none:
    case EscapePhase::steps:
      if (escape_.phase == EscapePhase::steps) escape_.held = wait_.update(in.standing, ring);
      if (size(logarithm(between(from_, now)), in.arm) > in.progress) {
        escape_ = {};
        wait_from_here(in);
      } else if (long_enough && escape_.tries >= kTries) {
        escape_.phase = EscapePhase::gave_up;
        gave_up_ = in.path;
      } else if (long_enough && in.standing.size() > 2) {
        begin(in);
      }
      break;
    case EscapePhase::moves:
      escape_.left = logarithm(between(now, to_));
      if (!long_enough && !is_there(in)) break;
      escape_.phase = EscapePhase::steps;
      escape_.left = {};
      wait_from_here(in);
      wait_.hold(escape_.failing, ring);
      break;
    case EscapePhase::gave_up:
      if (size({in.path.v - gave_up_.v, in.path.w - gave_up_.w}, in.arm) < kOtherPath) break;
      escape_ = {};
      wait_from_here(in);
      break;
  }
  return escape_;
}

void hold_back(gait_state::GaitInput& legs, LegSet held) noexcept {
  if (held.empty()) return;
  const double least = *std::ranges::min_element(legs.lag);
  for (LegId i = 0; i < legs.lag.size(); ++i)
    if (held.contains(i)) {
      legs.lag[i] = std::min(legs.lag[i], least) - kBehind;
      legs.urgent.set(i, false);
    }
}

void keep_out(BaseAutoCommand& base, const Escape& escape) noexcept {
  if (escape.phase == EscapePhase::none) return;
  base.min_advance = 0.0;
  if (escape.phase != EscapePhase::steps) base.max_advance = 0.0;
  // The leg that goes on trying would raise and lower a body that stands, and along its own axis it creeps.
  if (escape.phase == EscapePhase::gave_up)
    base.adaptation = [](const BaseAutoCommand&, const PoseAdaptationInput&) { return BaseGoal{}; };
}

}  // namespace hexagait::footstep_gen
