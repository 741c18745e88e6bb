// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait {

/// What is true of one foot, in the world frame W.
struct FootTruth {
  Vector3 p_WF = Vector3::Zero();  ///< foot centre [m]
  double normal_force = 0.0;       ///< sum of the normal forces at the foot in the last step [N]
  bool in_contact = false;         ///< any normal force

  /// Speed of the material contact point: the velocity that the foot's body has at the contact,
  /// tangential to the ground, at the most loaded contact. A rolling foot has none. 0 in the air
  /// [m/s]
  double slip_speed = 0.0;

  /// ∫ slip_speed dt since the world began [m]. Never decreases: the slip path of a stance is a
  /// difference of two readings, and no step between two readings is lost.
  double slip_path = 0.0;

  /// ∫ v dt of the same velocity as a vector [m]: what it comes to when sliding back and forth
  /// cancels. The net slip of a stance is the norm of the difference of two readings.
  Vector3 slip = Vector3::Zero();
};

/// What is true in the world. For the referee alone: no controller may see any of it.
/// Positions, velocities and forces are those at the end of the last physics step.
struct GroundTruth {
  double time = 0.0;                 ///< [s]
  Pose X_WB;                         ///< base in the world
  Twist V_WB;                        ///< velocity of the base, expressed in the base
  LegArray<FootTruth> feet;          ///< per leg
  bool base_touches_ground = false;  ///< the base link touched in the last step: a fall
  bool leg_touches_ground = false;   ///< a leg touched with something other than its foot
  bool finite = true;                ///< false once the physics has blown up; then all has stopped
  long solver_complaints = 0;        ///< steps that the contact solver called ill-posed, so far
};

}  // namespace hexagait
