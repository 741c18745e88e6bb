// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/lanes.hpp>
#include <hexagait/model/leg_solution.hpp>

namespace hexagait {

/// The first three joints of two legs, by joint.
[[nodiscard]] inline LaneVector three_lanes(const LegJoints& a, const LegJoints& b) {
  return {Lanes{a[0], b[0]}, Lanes{a[1], b[1]}, Lanes{a[2], b[2]}};
}

/// Two yaw-pitch-pitch legs at once: a lane each. All results have the bits of YawPitchPitchLeg's
/// functions for one leg.
class LegPair {
 public:
  LegPair(const LegModel& first, const LegModel& second) : a_(first), b_(second) {}

  /// Of both legs' joint angles, by joint.
  struct Angles {
    LaneVector q;     ///< joint values [rad]
    LaneVector c, s;  ///< their LegTrig
  };

  /// YawPitchPitchLeg::leg_trig() of both.
  [[nodiscard]] Angles trig(const LegJoints& q_a, const LegJoints& q_b) const noexcept;

  /// YawPitchPitchLeg::inverse_kinematics() of both, where both feet are within reach, no angle turns
  /// by more than 14° and all are within their limits; else false, and `to` is not to be used.
  /// @param p_BF  both feet [m]
  /// @param near  what they go on from
  [[nodiscard]] bool go_on(const LaneVector& p_BF, const Angles& near, Angles& to) const noexcept;

  /// One number of each leg's model.
  template <class F>
  [[nodiscard]] Lanes of(F f) const {
    return Lanes{f(a_), f(b_)};
  }

 private:
  const LegModel& a_;
  const LegModel& b_;
};

/// The first three joints of one of the two legs.
inline void put(const LaneVector& values, int lane, LegJoints& joints) {
  joints[0] = values.x[lane];
  joints[1] = values.y[lane];
  joints[2] = values.z[lane];
}

/// LegTrig and foot of all legs [m, body frame], as leg_trig() and foot_position() give them. Sizes
/// stay as they are; of trig, entries beyond a leg's joints do.
void forward_kinematics(const RobotModel& model, const LegArray<LegJoints>& q,
                        LegArray<LegTrig>& trig, LegArray<Vector3>& p_BF) noexcept;

}  // namespace hexagait
