// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/urdf/detail/robot_tree.hpp>
#include <hexagait/urdf/urdf.hpp>

namespace hexagait {

/// Where a joint may be.
struct JointRange {
  double lower = 0.0, upper = 0.0;  ///< [rad]
  std::string substituted;          ///< what the file says instead; empty: just this
  std::string problem;              ///< what is wrong and what would be right; empty: nothing
};

/// A continuous joint may turn by ±π, as may one whose limits are 1000 or more. Limits that are
/// missing, or both 0, are ±π/2 of the first joint of a leg, which may not turn the leg into the body,
/// and ±5π/6 of the others, which fold a link back onto the one before but for the thickness of both.
[[nodiscard]] JointRange range_of(const FileJoint& joint, bool first, const UrdfOptions& options);

/// Gives every joint a speed and an effort that can be. With the leg's length l, the robot's mass m
/// and gravity g, what is not positive, or more than 20 √(g/l) or 20 m g l, is replaced by 1.5 √(g/l)
/// and 0.5 m g l.
void settle_drives(const UrdfFile& file, const UrdfOptions& options, RobotTree& tree,
                   std::vector<Substitution>& substitutions);

}  // namespace hexagait
