// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/model/kinematics.hpp>

namespace hexagait {

bool within_limits(const LegModel& leg, const LegJoints& q) noexcept {
  for (int i = 0; i < leg.num_joints(); ++i)
    if (!within(leg.limits[i], q[i])) return false;
  return true;
}

Pose link_pose(const LegModel& leg, int link, const LegJoints& q) noexcept {
  assert(0 <= link && link < leg.num_joints());
  Pose X_BB0;  // displacement of the link from its pose with all joints at zero
  for (int i = 0; i <= link; ++i)
    X_BB0 = X_BB0 * rotation_about(leg.p_BJ0[i], rotation(leg.axis_B0[i] * q[i]));
  return X_BB0 * leg.links[link].X_BL0;
}

}  // namespace hexagait
