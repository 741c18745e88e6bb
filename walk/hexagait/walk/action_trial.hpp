// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/script/action_runner.hpp>
#include <hexagait/sim/ground_truth.hpp>
#include <limits>

namespace hexagait::walk {

/// Where the map is in odom (X_OM), by a localisation: asked before every tick. It may be noisy and
/// jump, as they do.
using Localisation = std::function<Pose(const ActionRecord&, const GroundTruth&)>;

struct ActionTrialOptions {
  double settle = 0.2;               ///< the plant stands for so long before the action begins [s]
  double rest = 0.5;                 ///< and is watched for so long after it [s]
  double seconds = 600.0;            ///< the action may take so long; then it is stopped [s]
  RestsOn rests_on = RestsOn::feet;  ///< how the robot is taken over
  Localisation localisation = {};    ///< none: one that knows the truth; map is the world
};

/// How an action went, by ground truth.
struct ActionSummary {
  ActionResult result;         ///< what the controller says
  Fault fault = Fault::none;   ///< why the controller stopped, if it did
  double seconds = 0.0;        ///< from its start to its result [s]
  bool out_of_time = false;    ///< it had not ended by itself
  bool fell = false;           ///< the base tilted by more than 60°, or hit the ground at a speed
  bool base_touched = false;   ///< the base touched the ground, as it does when the robot lies down
  bool leg_touched = false;    ///< a leg touched the ground with something other than its foot
  bool stands_at_end = false;  ///< the base is off the ground and all feet are on it

  /// Least margin of the centre of mass in the polygon of the feet that truly touch, negative
  /// outside, and the step (from 1) in which it was; while the body itself does not touch [m].
  double margin_min = std::numeric_limits<double>::infinity();
  int margin_step = 0;
  double tilt_max = 0.0;                      ///< roll or pitch of the base, absolute [rad]
  double height_min = 0.0, height_max = 0.0;  ///< of the base's origin in the world [m]
  double odometry_position = 0.0;             ///< |odometry − truth| in the end [m]

  /// How far the base was from where its plans wanted it, at most, while it followed one: up or
  /// down, sideways [m], and how it leaned [rad]. Odometry's error is in it.
  double off_plan_height = 0.0, off_plan_sideways = 0.0, off_plan_tilt = 0.0;
  double foot_force_max = 0.0;   ///< largest normal force on a foot [N]
  std::uint64_t state_hash = 0;  ///< of the true pose and all joints at every tick (FNV-1a)

  /// The action did what it says, and nobody was hurt.
  [[nodiscard]] bool ok() const { return result.outcome == Outcome::succeeded && !fell; }
};

/// Called after every tick of the action; false ends the trial at once.
using ActionObserver = std::function<bool(const ActionRecord&, const GroundTruth&)>;

/// Carries out an action: the loop of plant and controller, to the action's result, or to a fall.
/// @param runner  is started anew; the observer may stop() or pause() it
/// @param truth   the plant's ground truth, which it keeps up to date
[[nodiscard]] ActionSummary run_action(ActionRunner& runner, Plant& plant, const GroundTruth& truth,
                                       const action::Action& action,
                                       const ActionTrialOptions& options = {},
                                       const ActionObserver& observer = {});

}  // namespace hexagait::walk
