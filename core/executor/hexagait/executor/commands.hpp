// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/math/planar.hpp>
#include <limits>

namespace hexagait {

/// Free Gait command `Footstep` ([FG16] II-C): lift the foot, carry it over, put it down.
///
/// A Footstep for a leg that is already in the air replaces the target; the foot goes on from its
/// present position, velocity and acceleration (receding horizon).
struct Footstep {
  LegId leg = 0;
  Vector3 p_OT = Vector3::Zero();  ///< foothold, centre of the foot, in odom [m]; z is a guess
  double profile_height = 0.10;    ///< clearance above the higher of start and target [m]
};

/// What a pose adaptation sees.
struct PoseAdaptationInput {
  LegArray<Vector3> p_BF;          ///< feet, as commanded, in the body frame [m]
  LegArray<Vector3> p_BC;          ///< workspace centres [m]
  LegArray<Vector3> footprint_BF;  ///< where each foot last stood, measured, in the body frame [m]
  LegSet support;                  ///< legs that carry the body
};

/// Where the base should go from where it is: the answer of a pose adaptation.
struct BaseGoal {
  double advance = 0.0;  ///< along BaseAuto::path, in its own measure [m]
  double height = 0.0;   ///< along body z [m]
  double roll = 0.0;     ///< about body x [rad]
  double pitch = 0.0;    ///< about body y [rad]
};

struct BaseAuto;

/// A strategy that says how the body is best held over its feet ([FG16] II-D: "the underlying pose
/// adaptation algorithm should be adapted for different types of robots").
using PoseAdaptation = BaseGoal (*)(const BaseAuto&, const PoseAdaptationInput&);

/// Free Gait command `BaseAuto` ([FG16] II-D) with the pose adaptation left to the sender.
struct BaseAuto {
  PoseAdaptation adaptation = nullptr;  ///< none: the base stays where it is
  PlanarTwist path;                     ///< unit motion along the commanded path, per metre of path
  PlanarTwist correction;  ///< back to the path: displacement still to be made [m, rad]
  double max_advance = std::numeric_limits<double>::infinity();  ///< workspace left [m of path]
  double max_speed = std::numeric_limits<double>::infinity();    ///< along the path [m/s]
};

}  // namespace hexagait
