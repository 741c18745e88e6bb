// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/footstep_gen/tick_record.hpp>
#include <hexagait/walk/referee/path_judge.hpp>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace hexagait::walk {

/// A base that tilts by more than this has fallen [rad].
inline constexpr double kFallTilt = std::numbers::pi / 3.0;

/// What a robot that is stuck waits for.
struct Hindrance {
  LegId leg = 0;
  LegPhase phase = LegPhase::support;  ///< in which it is; of one that finds no ground, descend
  double seconds = 0.0;                ///< since it last stood; of a leg that stands, lifted [s]
  int retreats = 0;                    ///< tries of its present step that failed
  int no_ground = 0;                   ///< how often it found no ground since the robot last got on
};

/// "leg LF has been off the ground for 4.2 s: it finds no ground, …".
[[nodiscard]] std::string cause_in_words(const Hindrance& hindrance, const RobotModel& robot);

/// The same, and what may help.
[[nodiscard]] std::string in_words(const Hindrance& hindrance, const RobotModel& robot);

/// "deadlock: body moves 4 cm left; after its neighbours RF steps": what a robot did to get out of one, or
/// why it gave up.
[[nodiscard]] std::string in_words(const footstep_gen::Escape& escape, const RobotModel& robot);

struct Summary;

/// "its body touched the ground, tilted by 3°": it stood over something that no foot had met, or toppled.
/// @pre it fell
[[nodiscard]] std::string fall_in_words(const Summary& summary);

/// What the controller found out about its legs and the ground, and did about it, a sentence each; empty:
/// nothing.
[[nodiscard]] std::vector<std::string> found_in_words(const Summary& summary,
                                                      const RobotModel& robot);

/// How well a robot walked, by ground truth. What was not computed is 0; what is a statistic of
/// nothing is NaN.
struct Summary {
  double seconds = 0.0;   ///< walked [s]
  double distance = 0.0;  ///< along the commanded curves, of the base's origin [m]
  double turned = 0.0;    ///< net turn of the body [rad]
  double speed = 0.0;     ///< distance / seconds [m/s]

  double lateral_mean = 0.0, lateral_max = 0.0,
         lateral_end = 0.0;                     ///< |distance from the curve| [m]
  double heading_max = 0.0, heading_end = 0.0;  ///< |true − ideal heading| [rad]
  double odometry_position = 0.0;               ///< |odometry − truth| at the end [m]
  double odometry_heading = 0.0;                ///< the same of the yaw, signed [rad]
  double odometry_height = 0.0;                 ///< the same of the height, signed [m]
  double odometry_tilt = 0.0;                   ///< greatest angle between up and odom's z [rad]

  /// Slip of a stance: |∫ v dt| of the foot's material contact point along the ground, from its
  /// first touch to the last one before it is off the ground for 50 ms, or to the end of the walk
  /// [m]. Bounces at touchdown, and dragging at lift-off, are in it.
  double slip_mean = 0.0, slip_p95 = 0.0;
  int stances = 0;  ///< all, those that had not ended included

  /// Downward speed of a foot in the last control period before the first touch of a stance [m/s]. NaN without steps.
  double touchdown_median = std::numeric_limits<double>::quiet_NaN();
  double touchdown_p95 = std::numeric_limits<double>::quiet_NaN();

  /// Stability margin of the centre of mass in the true support polygon, negative outside [m].
  /// Ticks without any foot on the ground have none.
  double margin_min = 0.0, margin_p5 = 0.0;
  double roll_max = 0.0, pitch_max = 0.0;     ///< [rad], absolute
  double height_min = 0.0, height_max = 0.0;  ///< of the base's origin [m]

  /// Work of the joints per weight and way, ∫ Σ |τ q̇| dt / (m g d), with g = 9.81 m/s². NaN where the
  /// world does not tell the work, or without way.
  double cost_of_transport = std::numeric_limits<double>::quiet_NaN();

  int steps = 0;                          ///< lifts commanded
  std::optional<int> tripod_after_steps;  ///< see first_tripod_gait()

  /// Lifts commanded while a neighbour was in truth off the ground, or was lifted with it. What the
  /// controller knew does not matter.
  int rule1_violations = 0;
  /// The same by the controller's own record: lifts that it commanded beside a leg that it lifts or
  /// takes to be off the ground.
  int rule1_commanded = 0;
  double neighbour_flight = 0.0;  ///< time in which two neighbours were off the ground [s]
  double leg_touch_time = 0.0;    ///< in which a leg touched the ground, not with its foot [s]
  int contact_losses = 0;  ///< times a leg in support lost all contact, after its first 20 ms
  /// Those of them that lasted longer than 20 ms, or in which the foot went more than 5 mm from where
  /// it last touched. The others are bounces, most of them when another foot strikes the ground.
  int real_contact_losses = 0;
  LegSet lost;                         ///< legs that the controller does without, at the end
  footstep_gen::LegFindings findings;  ///< what it has found out about its legs, at the end
  double very_rough = 0.0;             ///< time for which the free gait was a wave, (step 8) [s]
  int escapes = 0;                     ///< tries to get out of a deadlock
  footstep_gen::Escape escape;         ///< the last of them, or that it has given up
  bool refused = false;                ///< it did not walk, since too few legs were left
  bool fell = false;                   ///< the base touched the ground, or tilted by more than 60°
  /// Its roll or pitch when it fell, whichever was more [rad]. NaN where the state was none, or it did not fall.
  double fall_tilt = std::numeric_limits<double>::quiet_NaN();
  /// No progress for too long: RefereeParams::progress and patience; and what was in the way.
  bool stuck = false;
  Hindrance hindrance;
  bool arrived = false;             ///< the distance asked for, or the end of the path, was reached
  std::optional<PathSummary> path;  ///< if it followed one
  footstep_gen::Fault fault = footstep_gen::Fault::none;  ///< why the controller stopped, if it did

  double real_time_factor = 0.0;             ///< simulated seconds per second of processor time
  double tick_median = 0.0, tick_p99 = 0.0;  ///< wall time of a controller tick [ns]
  std::uint64_t state_hash = 0;  ///< of the true pose and all joints at every tick (FNV-1a)

  /// Walked to the end as asked.
  [[nodiscard]] bool ok() const {
    return !fell && !stuck && !refused && fault == footstep_gen::Fault::none;
  }
};

}  // namespace hexagait::walk
