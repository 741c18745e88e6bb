// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/math/planar.hpp>
#include <limits>

namespace hexagait {

/// How far below its target a foot looks for ground. Deeper is a hole: the foot rises straight up, and comes
/// down at the target again, which is to be another one by then.
struct SearchDepth {
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  double at_end = kNever;       ///< where the leg's reach ends [m]
  double beside_hole = kNever;  ///< finite where a hole is known [m]
  /// Contact between these two depths is contact with an edge, (step 11) [m]: the foot tries a closer place.
  double edge = kNever, edge_end = 0.0;
  /// Contact deeper than edge_end may be that with the wall of a hole, (step 12): the foot presses. It takes measured
  /// joints to tell whether it sinks.
  bool presses = false;

  /// Contact below the ground that is expected may be that with the wall of a hole.
  [[nodiscard]] bool hole_known() const { return beside_hole < kNever; }
};

/// The footstep of one leg: lift the foot, carry it over, put it down ([FG16] II-C). Streamed by a
/// gait generator; action::Footstep is that of a script.
///
/// For a leg that is already in the air the command replaces the target; the foot continues from
/// its present position, velocity and acceleration (receding horizon).
struct FootstepCommand {
  LegId leg = 0;
  Vector3 p_OT = Vector3::Zero();  ///< target of the foot's centre, in odom [m]; z is an estimate
  double profile_height = 0.0;     ///< clearance above the higher of start and target [m]
  /// How many times as fast as SwingParams says, (swing 4). Of a step that has begun it stays.
  double haste = 1.0;
  /// How many times SwingParams::descent_speed it has, (step 9).
  double descent = 1.0;
  /// How many times SwingParams::touchdown_speed and, down to the clearance below, search_speed it has, (step 6).
  double touchdown = 1.0;
  /// Share of SwingParams::touchdown_margin over which it is slow, (step 10).
  double slow_way = 1.0;
  SearchDepth depth = {};
};

/// The input of a pose adaptation.
struct PoseAdaptationInput {
  LegArray<Vector3> p_BF;  ///< set points of the feet, body frame [m]
  LegArray<Vector3> p_BC;  ///< workspace centres, body frame [m]
  /// Last measured footprint of each foot, body frame [m]; lower by BaseAutoCommand::lowering where it searches below.
  LegArray<Vector3> footprint_BF;
  LegSet support;       ///< legs that carry the body
  LegSet lost = {};     ///< legs that count for nothing; p_BF is at their centre
  LegSet blocked = {};  ///< legs in the air that have met an obstacle in this step
};

/// The desired displacement of the base: the result of a pose adaptation.
struct BaseGoal {
  double advance = 0.0;  ///< along BaseAutoCommand::path [m of path]
  double height = 0.0;   ///< along body z [m]
  double roll = 0.0;     ///< about body x [rad]
  double pitch = 0.0;    ///< about body y [rad]
};

struct BaseAutoCommand;

/// Computes how the body is best held over its feet ([FG16] II-D: "the underlying pose adaptation
/// algorithm should be adapted for different types of robots").
using PoseAdaptation = BaseGoal (*)(const BaseAutoCommand&, const PoseAdaptationInput&);

/// Moves the base along a path to where a pose adaptation wants it ([FG16] II-D). Streamed by a
/// gait generator; action::BaseAuto is that of a script.
struct BaseAutoCommand {
  PoseAdaptation adaptation = nullptr;  ///< null: the base stays where it is
  PlanarTwist path;                     ///< twist along the commanded path, per metre of path
  PlanarTwist correction;               ///< displacement back to the path [m, rad]
  /// Displacement besides the path, as fast as the base moves along it [m].
  Vector2 sway = Vector2::Zero();
  /// How far the base may go along the path, and back [m of path]; 0 is between them.
  double max_advance = std::numeric_limits<double>::infinity();
  double min_advance = -std::numeric_limits<double>::infinity();
  double max_speed = std::numeric_limits<double>::infinity();  ///< along the path [m/s]
  /// Deceleration that the support polygon allows to motion away from the path [m/s²]. 0: what
  /// BaseParams::acceleration allows.
  double max_braking = 0.0;
  /// Share of the depth that a foot has searched below its last footprint by which it counts as lower there, so that the
  /// body comes down towards it; 0 … 1.
  double lowering = 1.0;
};

}  // namespace hexagait
