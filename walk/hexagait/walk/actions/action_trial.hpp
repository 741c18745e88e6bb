// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/script/action_runner.hpp>
#include <hexagait/sim/ground_truth.hpp>
#include <limits>

namespace hexagait::walk {

/// Returns the pose of the map in odom, X_OM, as a localisation would: called before every tick. It
/// may be noisy and may jump.
using Localisation = std::function<Pose(const ActionRecord&, const GroundTruth&)>;

struct ActionTrialOptions {
  double settle = 0.2;               ///< the robot stands for this long before the action [s]
  double rest = 0.5;                 ///< and is observed for this long after it [s]
  double seconds = 600.0;            ///< time limit of the action [s]
  RestsOn rests_on = RestsOn::feet;  ///< what carries the robot at the start
  Localisation localisation = {};    ///< none: exact, the map is the world
};

/// How an action went, measured by ground truth.
struct ActionSummary {
  ActionResult result;         ///< what the controller reports
  Fault fault = Fault::none;   ///< why the controller stopped, if it did
  double seconds = 0.0;        ///< from the action's start to its result [s]
  bool out_of_time = false;    ///< the time limit ended it
  bool fell = false;           ///< the base tilted by more than 60°, or hit the ground at 0.6 m/s
  bool base_touched = false;   ///< the base touched the ground, also when lying down
  bool leg_touched = false;    ///< a leg touched the ground with something other than its foot
  bool stands_at_end = false;  ///< the base is off the ground and all feet are on it

  /// Least stability margin of the centre of mass in the polygon of the feet in contact, negative
  /// outside [m], and the step (from 1) in which it occurred. Not measured while the base touches.
  double margin_min = std::numeric_limits<double>::infinity();
  int margin_step = 0;
  double tilt_max = 0.0;                      ///< roll or pitch of the base, absolute [rad]
  double height_min = 0.0, height_max = 0.0;  ///< of the base's origin in the world [m]
  double odometry_position = 0.0;             ///< |odometry − truth| in the end [m]

  /// Largest deviations of the base from its plan while it followed one: vertical, horizontal [m]
  /// and tilt [rad]. They include the error of odometry.
  double off_plan_height = 0.0, off_plan_sideways = 0.0, off_plan_tilt = 0.0;
  double foot_force_max = 0.0;   ///< largest normal force on a foot [N]
  std::uint64_t state_hash = 0;  ///< of the true pose and all joints at every tick (FNV-1a)

  /// The action succeeded and the robot did not fall.
  [[nodiscard]] bool ok() const { return result.outcome == Outcome::succeeded && !fell; }
};

/// Called after every tick of the action; false ends the trial at once.
using ActionObserver = std::function<bool(const ActionRecord&, const GroundTruth&)>;

/// Runs an action in a loop of plant and controller, until its result or a fall.
/// @param runner  is restarted; the observer may stop() or pause() it
/// @param truth   the plant's ground truth, updated by its write()
[[nodiscard]] ActionSummary run_action(ActionRunner& runner, Plant& plant, const GroundTruth& truth,
                                       const action::Action& action,
                                       const ActionTrialOptions& options = {},
                                       const ActionObserver& observer = {});

}  // namespace hexagait::walk
