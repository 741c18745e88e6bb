// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/walk/referee.hpp>
#include <hexagait/walk/schedule.hpp>
#include <limits>

namespace hexagait::walk {

struct TrialOptions {
  Schedule schedule;                                          ///< what to do when
  double seconds = 40.0;                                      ///< how long, at most [s]
  double distance = std::numeric_limits<double>::infinity();  ///< how far, at most [m]
  double settle = 0.2;  ///< the plant stands for so long before the walk begins [s]
};

/// Called after every tick: the controller's record, the truth, and the referee so far.
using Observer =
    std::function<void(const footstep_gen::TickRecord&, const GroundTruth&, const Referee&)>;

/// Walks: the loop of plant, controller and referee, to the end of the schedule's time, to the
/// distance, or to a fall.
/// @param truth  the plant's ground truth, which it keeps up to date
[[nodiscard]] Summary run_trial(footstep_gen::Walker& walker, Plant& plant,
                                const GroundTruth& truth, const TrialOptions& options,
                                const Observer& observer = {});

/// Joint positions that put every foot at its workspace centre.
[[nodiscard]] LegArray<LegJoints> nominal_posture(const RobotModel& model);

/// The same with every foot displaced by a random vector, uniform in a disc of `spread` [m]. A pure
/// function of its arguments.
[[nodiscard]] LegArray<LegJoints> random_posture(const RobotModel& model, double spread,
                                                 std::uint64_t seed);

}  // namespace hexagait::walk
