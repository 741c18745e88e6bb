// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/urdf/detail/robot_tree.hpp>
#include <hexagait/urdf/urdf.hpp>

namespace hexagait {

/// Size of a robot: the radius of the layout of its hips and the length of its middle leg [m].
[[nodiscard]] double size_of(const RobotTree& tree);

/// Gives every link a mass and an inertia that can be. What is missing, 0, or out of these bounds is
/// replaced by that of the link's shapes, filled evenly with options.density; a link without shapes,
/// or with only a foot, counts as a rod from its joint to the next one, a tenth as thick as long:
///
///  - mass of the robot over the cube of its size: 2 to 1000 kg/m³; else all masses are replaced
///  - mass of a link over its volume: 1 to 100 000 kg/m³, since a rod may stand for a whole motor
///  - an inertia's largest radius of gyration: 0.01 to 2 times the link's extent
///
/// options.mass scales all masses and inertias to that sum.
/// @pre every chain has its foot, and the base a shape
void settle_masses(const UrdfFile& file, const UrdfOptions& options, RobotTree& tree,
                   std::vector<Substitution>& substitutions);

}  // namespace hexagait
