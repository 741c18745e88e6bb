// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/urdf/detail/feet.hpp>
#include <hexagait/urdf/detail/leg_candidates.hpp>

namespace hexagait {

/// What is thought of a candidate.
struct Verdict {
  std::string why_not;  ///< the reason why it is no leg; empty: it is one
  std::string problem;  ///< what is wrong with it as a leg; empty: nothing
};

/// Which chains are legs: those of two or more turning joints whose ends get below the body's
/// underside, at least 0.3 of the way that the middle one gets. Of these, what has no mirror partner
/// and is not as long as the others (0.6 to 1.6 times) is none either. What is as long as a leg, but
/// does not get down, or has too few or too many joints, is a leg with a problem: it is not left out
/// silently.
/// @param tree  with all candidates as its chains, z upwards
/// @param feet  of each chain
[[nodiscard]] std::vector<Verdict> judge(const UrdfFile& file, const RobotTree& tree,
                                         const std::vector<std::optional<FoundFoot>>& feet,
                                         const UrdfOptions& options);

/// Lowest height that a point fixed to the last link gets to within the joints' limits [m].
[[nodiscard]] double lowest_reach(const SerialChain& chain, const Vector3& p_BF0);

}  // namespace hexagait
