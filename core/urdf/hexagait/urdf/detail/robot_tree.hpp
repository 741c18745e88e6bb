// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/text/violations.hpp>
#include <optional>

namespace hexagait {

/// A revolute joint where it stands when all joints are zero.
struct TreeJoint {
  std::string name;
  Vector3 p_BJ0 = Vector3::Zero();     ///< a point on its axis [m]
  Vector3 axis_B0 = Vector3::UnitZ();  ///< unit vector; 0 if the URDF gives no direction
  JointLimits limits;
};

/// Links one behind the other, hanging from the base: joints[i] moves links[i].
struct SerialChain {
  std::vector<TreeJoint> joints;
  std::vector<LinkModel> links;
  /// The sphere of the last link that is farthest from the last joint, if it has one; in B, all
  /// joints zero.
  struct Foot {
    Vector3 p_BF0 = Vector3::Zero();  ///< centre [m]
    double radius = 0.0;              ///< [m]
  };
  std::optional<Foot> foot;
};

/// A robot as its URDF describes it, before anyone asks whether it has legs. Links that are fixed
/// to another one have been merged into it.
struct RobotTree {
  std::string name;
  LinkModel base;
  std::vector<SerialChain> chains;
};

/// Reads the text of a URDF. Movable joints must be revolute or continuous (then the limits are
/// ±π), every merged link must have mass, and no chain may branch. Collision meshes are left out;
/// visual geometry is not read.
/// @param violations  receives everything that is wrong; the tree may then be incomplete
/// @returns nothing if the text is no URDF at all
[[nodiscard]] std::optional<RobotTree> read_robot_tree(const std::string& xml,
                                                       Violations& violations);

}  // namespace hexagait
