// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// Cosines and sines of one leg's angles: of a yaw-pitch-pitch leg the canonical k₁, k₂ and
/// k₂ + k₃; of a serial leg its joint values q. Entries beyond the leg's joints are 1 and 0.
struct LegTrig {
  LegJoints c = LegJoints::Ones();
  LegJoints s = LegJoints::Zero();
};

/// The result of inverse_kinematics().
struct LegSolution {
  LegJoints q = LegJoints::Zero();  ///< joint values, always within their limits [rad]
  LegTrig trig;                     ///< of q
  bool reachable = false;           ///< the foot is at the requested place, to 1 nm
};

/// Targets of feet are clamped to this, so that squares stay finite [m].
inline constexpr double kFarAway = 1e6;

/// The functions that the kinematics of one kind of leg consist of; kinematics.hpp specifies them
/// and calls those of a leg's kind.
template <class Kind>
concept LegKinematics = requires(const LegModel& leg, const LegJoints& q, const LegTrig& trig,
                                 const Vector3& p_BF) {
  { Kind::leg_trig(leg, q) }
  noexcept->std::same_as<LegTrig>;
  { Kind::foot_position(leg, trig) }
  noexcept->std::same_as<Vector3>;
  { Kind::foot_jacobian(leg, trig) }
  noexcept->std::same_as<LegJacobian>;
  { Kind::foot_effort(leg, trig, p_BF) }
  noexcept->std::same_as<LegJoints>;
  { Kind::tibia_rotation(leg, trig) }
  noexcept->std::same_as<Matrix3>;
  { Kind::tibia_turn(leg, trig, q) }
  noexcept->std::same_as<Vector3>;
  { Kind::inverse_kinematics(leg, p_BF, q) }
  noexcept->std::same_as<LegSolution>;
  { Kind::inverse_kinematics(leg, p_BF, q, trig) }
  noexcept->std::same_as<LegSolution>;
};

/// Is q within the limits, up to a rounding error of 1e-9 rad?
[[nodiscard]] inline bool within(const JointLimits& limits, double q) noexcept {
  constexpr double kRounding = 1e-9;
  return limits.lower - kRounding <= q && q <= limits.upper + kRounding;
}

}  // namespace hexagait
