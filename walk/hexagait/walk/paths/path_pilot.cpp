// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/walk/paths/path_pilot.hpp>

namespace hexagait::walk {
namespace {

constexpr double kStands = 0.01;  // of the greatest speed

double speed_of(const footstep_gen::Walker& walker) {  // of the base [m/s]
  return walker.record().base.planar.v.norm();
}

// After which the base stops, with its limit of acceleration [m].
double way_to_stop(const footstep_gen::Walker& walker) {
  const double speed = speed_of(walker);
  return 0.5 * speed * speed / walker.params().executor.base.acceleration;
}

}  // namespace

const char* to_string(LocalisedBy localised_by) noexcept {
  return localised_by == LocalisedBy::truth ? "truth" : "odometry";
}

PathPilot::PathPilot(const path_following::PathTask& task, LocalisedBy localised_by,
                     const GroundTruth& start)
    : task_(&task), localised_by_(localised_by), start_(in_plane(start.X_WB)) {}

heading_control::HeadingCommand PathPilot::steer(const footstep_gen::Walker& walker,
                                                 const GroundTruth& truth) noexcept {
  const PlanarPose X_PB = localised_by_ == LocalisedBy::truth
                              ? between(start_, in_plane(truth.X_WB))
                              : in_plane(walker.record().state.X_OB);
  const path_following::Pursuit now =
      path_following::pursue(progress_, *task_, X_PB, way_to_stop(walker));
  progress_ = now.progress;
  return now.command;
}

bool PathPilot::stands_at_end(const footstep_gen::Walker& walker) const noexcept {
  const auto stands = [](const LegLane& leg) { return leg.phase == LegPhase::support; };
  return progress_.arrived && std::ranges::all_of(walker.record().legs, stands) &&
         speed_of(walker) < kStands * walker.params().executor.base.max_speed;
}

}  // namespace hexagait::walk
