// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
#include <hexagait/fg16/foot_tracks.hpp>
#include <hexagait/walk/actions/action_trial.hpp>
#include <span>

/// The claims of [FG16], judged: what each experiment measured, and the verdicts on it.
namespace hexagait::experiments {

/// A climb of Fig. 6.
struct Climbed {
  walk::ActionSummary summary;
  std::vector<double> swing_errors = {};  ///< of swinging feet from their commands [m]
  std::vector<FootTracks::Touchdown> touchdowns = {};
};
/// @param blocked          the climb in which a foothold is blocked; one of those
/// @param blocked_leg      its leg
/// @param blocked_p_MF     and where it is in the map [m]
[[nodiscard]] std::vector<Verdict> judge_climbs(std::span<const Climbed> climbs,
                                                const Climbed& blocked, LegId blocked_leg,
                                                const Vector3& blocked_p_MF);

/// A walk of Fig. 7.
struct LocalisedWalk {
  walk::ActionSummary summary;
  double commanded_jump = 0.0, localised_jump = 0.0;  ///< see FootTracks [m]
  /// Distances of feet from their footholds at touchdown, of the last metre and of all [m].
  std::vector<double> last_metre = {}, all = {};
};
/// @param way                 walked [m]
/// @param localisation_error  at most [m]
[[nodiscard]] std::vector<Verdict> judge_localised(const LocalisedWalk& combined,
                                                   const LocalisedWalk& odometry_only, double way,
                                                   double localisation_error);

}  // namespace hexagait::experiments
