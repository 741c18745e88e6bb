// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/path_following/pursuit.hpp>
#include <hexagait/sim/ground_truth.hpp>

namespace hexagait::walk {

/// Where a robot that follows a path takes its place from.
enum class LocalisedBy : std::uint8_t {
  odometry,  ///< its own, which drifts
  truth,     ///< given and without error, as by cameras in a laboratory
};
[[nodiscard]] const char* to_string(LocalisedBy localised_by) noexcept;

/// Steers a walker along a path: the loop around the walker's own. The path's frame is that of the base at
/// the start, seen from above.
class PathPilot {
 public:
  /// @param task  must outlive the pilot
  PathPilot(const path_following::PathTask& task, LocalisedBy localised_by,
            const GroundTruth& start);

  /// The command for the next tick, from the walker's record of the last one. Allocates nothing.
  [[nodiscard]] heading_control::HeadingCommand steer(const footstep_gen::Walker& walker,
                                                      const GroundTruth& truth) noexcept;

  [[nodiscard]] const path_following::PathProgress& progress() const { return progress_; }
  /// It is at the end of the path and stands.
  [[nodiscard]] bool stands_at_end(const footstep_gen::Walker& walker) const noexcept;

 private:
  const path_following::PathTask* task_;
  LocalisedBy localised_by_;
  PlanarPose start_;  ///< of the path's frame in the world
  path_following::PathProgress progress_;
};

}  // namespace hexagait::walk
