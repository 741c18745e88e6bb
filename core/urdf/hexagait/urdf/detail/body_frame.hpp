// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/urdf/detail/meshes.hpp>
#include <hexagait/urdf/detail/robot_tree.hpp>
#include <hexagait/urdf/urdf.hpp>

namespace hexagait {

/// The rotation that makes z point upwards: none if the hips lie in a level plane. Where they lie
/// flatter across another axis of the file, by a factor of 3, that one is up, in the sense in which
/// most feet hang down from their hips.
/// @pre every chain has its foot, in the file's axes
[[nodiscard]] Matrix3 upright(const RobotTree& tree, const UrdfOptions& options,
                              std::vector<Substitution>& substitutions);

/// The body frame in a tree whose z is up: x to the front, which is the long axis of mirror symmetry,
/// of about equals the nearest to the file's x. The origin stays where it is if it is in the plane of
/// symmetry (to 2 % of the layout's radius), not far from the hips' middle along it (a quarter of
/// that radius), and not far above or below (half a leg); else it is put into the hips' middle.
[[nodiscard]] Pose body_frame(const RobotTree& tree, const UrdfOptions& options,
                              std::vector<Substitution>& substitutions);

/// Gives the body a shape if it has none: the bounding box of its meshes, else of its visuals, else of
/// its hips.
void settle_body_shape(const UrdfFile& file, Meshes& meshes, RobotTree& tree,
                       std::vector<Substitution>& substitutions);

}  // namespace hexagait
