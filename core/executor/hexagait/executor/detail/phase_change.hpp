// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <hexagait/executor/leg_lane.hpp>

/// How a lane goes from one phase to another.
namespace hexagait {

/// The phase begins: its time is 0.
inline void enter(LegLane& lane, LegPhase phase) noexcept {
  lane.phase = phase;
  lane.time = 0.0;
  lane.probes = false;
}

/// The foot is to leave the ground where it is.
inline void rise_from_here(LegLane& lane, const Pose& X_OB) noexcept {
  lane.p_OL = X_OB * lane.p_BF;
  lane.rises_from = lane.p_OL.z();
}

/// Begins a step at the present position of the foot.
inline void begin_step(LegLane& lane, LegPhase phase, const Pose& X_OB) noexcept {
  enter(lane, phase);
  lane.cleared = lane.regains = false;
  lane.retreats = lane.bounces = 0;
  lane.haste = 1.0;
  lane.reach_fraction = 1.0;
  lane.beside = 0.0;
  lane.transfer_clock = 0.0;
  rise_from_here(lane, X_OB);
}

/// A tick of a ramp of that time, which ends in the tick that is nearest to it.
inline void ramp(double& value, double target, double dt, double time) noexcept {
  if (value == target) return;
  const double step = 1.0 / std::max(1.0, std::round(time / dt));
  value += std::clamp(target - value, -step, step);
}

/// Takes load from this tick on.
inline void land(LegLane& lane, double dt, const SwingParams& params) noexcept {
  enter(lane, LegPhase::support);
  lane.v_O.setZero();
  lane.a_O.setZero();
  lane.without_contact = 0.0;
  lane.confirmed = lane.believed = false;
  ramp(lane.load, 1.0, dt, params.load_time);
}

}  // namespace hexagait
