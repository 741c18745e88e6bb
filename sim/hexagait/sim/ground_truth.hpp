// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <limits>

namespace hexagait {

/// The true state of one foot, in the world frame W.
struct FootTruth {
  Vector3 p_WF = Vector3::Zero();  ///< foot centre [m]
  double normal_force = 0.0;       ///< sum of the normal forces at the foot in the last step [N]
  bool in_contact = false;         ///< the normal force is not 0

  /// Speed along the ground of the foot's material at its most loaded contact point; 0 for a foot
  /// that rolls or is in the air [m/s].
  double slip_speed = 0.0;

  /// ∫ slip_speed dt since the start of the world [m]. The slip path of a stance is the difference
  /// of two readings.
  double slip_path = 0.0;

  /// ∫ of the same velocity as a vector [m], in which sliding back and forth cancels. The norm of
  /// the difference of two readings is the net slip of a stance.
  Vector3 slip = Vector3::Zero();
};

/// The true state of the world at the end of the last physics step. For referees only: controllers
/// must not use it.
struct GroundTruth {
  double time = 0.0;                 ///< [s]
  Pose X_WB;                         ///< base in the world
  Twist V_WB;                        ///< twist of the base, axes of the base
  LegArray<FootTruth> feet;          ///< per leg
  bool base_touches_ground = false;  ///< the base link touched the ground in the last step: a fall
  bool leg_touches_ground = false;  ///< a leg touched the ground with something other than its foot
  /// Work of the joints since the start of the world, ∫ Σ |τ q̇| dt, where braking costs as much as
  /// driving [J]; NaN if the world does not tell.
  double work = std::numeric_limits<double>::quiet_NaN();
  bool finite = true;          ///< false once the physics has diverged and stopped
  long solver_complaints = 0;  ///< number of steps that the contact solver reported as ill-posed
};

}  // namespace hexagait
