// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait {

/// Corrections of up that GravitySense makes while a leg in the air is held. A leg that is caught pulls at the robot, and
/// its joints say by how much. The joints of a dead or missing leg say the same, and nothing pulls. So until that leg
/// stands again up turns by no more than 0.04 rad for it, and if it is lost, what it turned is taken back. A leg that is
/// not lost after the time in which one is found to be is caught, and felt like others. A value.
class FeltWhileHeld {
 public:
  explicit FeltWhileHeld(int legs = 0) : turned_(legs, Vector3::Zero()), time_(legs, 0.0) {}

  /// @param felt   correction in this tick, body frame, across up [rad]
  /// @param held   legs in the air that do not follow their set points
  /// @param stand  legs that stand
  /// @param lost   legs that take no part any more
  /// @param dt     control period [s]
  /// @param found  time in which a leg that is lost is found to be [s]
  /// @returns the correction to be made, as `felt`
  Vector3 update(const Vector3& felt, LegSet held, LegSet stand, LegSet lost, double dt,
                 double found) noexcept;

 private:
  LegSet held_;  ///< legs that were held and have not stood since; of the others both below are 0
  LegArray<Vector3> turned_;  ///< what up has turned since a leg was held first [rad]
  LegArray<double> time_;     ///< how long ago that was [s]
};

}  // namespace hexagait
