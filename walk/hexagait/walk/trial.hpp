// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/walk/paths/path_pilot.hpp>
#include <hexagait/walk/referee/referee.hpp>
#include <hexagait/walk/schedule.hpp>
#include <limits>

namespace hexagait::walk {

/// Says where to go before each tick, from the controller's record of the last one.
using Steer = std::function<heading_control::Heading(const footstep_gen::TickRecord&)>;

struct TrialOptions {
  Schedule schedule;  ///< commands over time, at least one
  Steer steer;        ///< if there is one, the schedule's headings do not matter
  /// If there is one, it is followed, and the walk is judged by it; headings do not matter.
  std::optional<path_following::PathTask> path;
  LocalisedBy localised_by = LocalisedBy::odometry;           ///< of who follows a path
  double seconds = 40.0;                                      ///< time limit [s]
  double distance = std::numeric_limits<double>::infinity();  ///< path limit [m]
  double turn =
      std::numeric_limits<double>::infinity();  ///< limit of the turn, to either side [rad]
  /// Bound of the speed along the path, at the farthest workspace centre [m/s].
  double speed = std::numeric_limits<double>::infinity();
  RefereeParams referee;  ///< see params_for()
  double settle = 0.2;    ///< the robot stands for this long before the walk [s]
};

/// Called after every tick with the controller's record, the truth, and the referee so far.
using Observer =
    std::function<void(const footstep_gen::TickRecord&, const GroundTruth&, const Referee&)>;

/// Walks in a loop of plant, controller and referee, until the time, path or turn limit, the end of the path, a
/// fall, a fault or until it is stuck.
/// @param truth  the plant's ground truth, updated by its write()
/// @throws InvalidInput  if the schedule is empty
[[nodiscard]] Summary run_trial(footstep_gen::Walker& walker, Plant& plant,
                                const GroundTruth& truth, const TrialOptions& options,
                                const Observer& observer = {});

/// Joint positions with every foot at its workspace centre [rad].
[[nodiscard]] LegArray<LegJoints> nominal_posture(const RobotModel& model);

/// The same with every foot displaced by a random vector, uniform in a disc of radius `spread` [m].
/// A pure function of its arguments.
[[nodiscard]] LegArray<LegJoints> random_posture(const RobotModel& model, double spread,
                                                 std::uint64_t seed);

}  // namespace hexagait::walk
