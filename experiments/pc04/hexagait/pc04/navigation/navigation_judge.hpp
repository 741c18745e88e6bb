// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
#include <hexagait/pc04/navigation/navigation_walk.hpp>
#include <vector>

namespace hexagait::experiments {

/// [PC04] 5.2 on navigation: no fall; and that there was something to fall from and to run into, and
/// the robot went about.
[[nodiscard]] std::vector<Verdict> judge_navigation(const std::vector<NavigationWalk>& walks);

}  // namespace hexagait::experiments
