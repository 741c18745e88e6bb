// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// Sines and cosines of one leg's angles: of a yaw-pitch-pitch leg the canonical k₁, k₂ and
/// k₂ + k₃, of a serial leg its joint values q. Those that a leg doesn't have are of 0, or stay.
struct LegTrig {
  LegJoints c = LegJoints::Ones();
  LegJoints s = LegJoints::Zero();
};

/// What inverse_kinematics() found.
struct LegSolution {
  LegJoints q = LegJoints::Zero();  ///< joint values, never outside their limits [rad]
  LegTrig trig;                     ///< of q
  bool reachable = false;           ///< is the foot where it was asked to be?
};

/// Is q within the limits? An excess of up to 1e-9 rad (rounding) is allowed.
[[nodiscard]] inline bool within(const JointLimits& limits, double q) noexcept {
  constexpr double kRounding = 1e-9;
  return limits.lower - kRounding <= q && q <= limits.upper + kRounding;
}

}  // namespace hexagait
