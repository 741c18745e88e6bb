// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/text/violations.hpp>
#include <hexagait/urdf/detail/feet.hpp>

namespace hexagait {

/// Gives each chain its foot, and its last link a ball there. All feet have one radius: --foot-radius,
/// else that of the file's spheres, else the least of the end links' shapes, else 0.025 of the middle
/// leg's length. A shape that the foot is taken from is replaced by the ball; a last link without any
/// shape left gets a rod to it.
/// @param feet        of each chain
/// @param violations  receives chains without a foot, and spheres that differ
void settle_feet(const UrdfFile& file, const UrdfOptions& options,
                 const std::vector<std::optional<FoundFoot>>& feet, RobotTree& tree,
                 Violations& violations, std::vector<Substitution>& substitutions);

}  // namespace hexagait
