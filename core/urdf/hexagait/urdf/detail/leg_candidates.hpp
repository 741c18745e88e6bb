// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/urdf/detail/robot_tree.hpp>

namespace hexagait {

/// A chain that may be a leg, as the file's tree has it.
struct LegCandidate {
  JointChain joints;  ///< those that turn, hip to foot
  JointChain held;    ///< among and behind these: those that move otherwise, or branch off
};

struct LegCandidates {
  std::vector<LegCandidate> chains;
  JointChain waists;  ///< held, so that what moves against each other is one body
};

/// The chains that leave the body. The body is the root with what is fixed to it; joints that lead to
/// several chains of two or more turning joints at once, such as a waist or a floating root, are held
/// as if fixed. Where a chain branches, it goes on along the branch with most turning joints.
[[nodiscard]] LegCandidates leg_candidates(const UrdfFile& file);

}  // namespace hexagait
