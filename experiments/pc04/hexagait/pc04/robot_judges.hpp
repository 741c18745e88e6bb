// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
#include <hexagait/walk/referee/summary.hpp>
#include <string>
#include <vector>

/// The claims of [PC04] 5.2 on other robots than Argos, judged.
namespace hexagait::experiments {

/// What is judged of random headings.
struct RandomHeadings {
  walk::Summary summary;
  double size = 0.0;           ///< L of the robot [m]
  double speed = 0.0;          ///< greatest of the base between commands [m/s]
  double acceleration = 0.0;   ///< that its controller allows [m/s²]
  double sharpest = 0.0;       ///< greatest change of the direction of motion [rad]
  double longest_pause = 0.0;  ///< between two lifts [s]
  double step_time = 0.0;      ///< median [s]
};
[[nodiscard]] std::vector<Verdict> judge_fig11(const RandomHeadings& walk);

/// One walk with displacements of one period.
struct DisplacementWalk {
  std::string heading;
  double period = 0.0;  ///< 0: smooth [s]
  walk::Summary summary;
  /// How far a foot got from where it touched down, each stance: not only at its end [m].
  std::vector<double> slips;
};
/// @param walks   of several headings, each smooth and with several periods
/// @param period  of Lauron's servos [s]
[[nodiscard]] std::vector<Verdict> judge_fig12(const std::vector<DisplacementWalk>& walks,
                                               double period);

}  // namespace hexagait::experiments
