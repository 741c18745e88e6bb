// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/math/quadratic_program.hpp>

namespace hexagait {

/// Force and moment about the body's origin, axes of the body.
struct Wrench {
  Vector3 force = Vector3::Zero();   ///< [N]
  Vector3 moment = Vector3::Zero();  ///< [N m]
};

struct ContactForceParams {
  /// Coefficient between foot and ground. Larger than the true one: feet slip; smaller: less
  /// horizontal force is available.
  double friction = 0.6;
  double min_normal = 0.0;    ///< of a fully loaded foot [N]
  double max_normal = 600.0;  ///< of a fully loaded foot [N]
  /// Weight of the squared force on a fully loaded foot against the squared wrench error. Larger:
  /// the wrench is met less exactly; smaller: the program becomes ill-conditioned. Positive.
  double regularisation = 1e-6;
  double moment_arm = 0.4;  ///< a moment counts as a force on this lever arm [m]
};

struct ContactForceProblem {
  Wrench wrench;               ///< desired, of the ground on the robot
  LegArray<Vector3> p_BF;      ///< feet, body frame [m]
  LegArray<Vector3> normal_B;  ///< of the ground at each foot, outwards, unit vectors
  LegArray<double> load;       ///< fraction of its load that each leg carries, 0 in the air … 1
};

/// The result of contact_forces().
struct ContactForces {
  LegArray<Vector3> force;             ///< of the ground on each foot, body frame [N]
  QpStatus status = QpStatus::solved;  ///< of (force 1); forces are 0 if it is not_convex
};

/// The forces of the ground on the feet that come nearest to a wrench. With λ the regularisation
/// and w_i the load of leg i:
///
///     min |Σ F_i − F|² + |Σ p_i × F_i − M|² / arm² + λ Σ |F_i|² / w_i                 (force 1)
///     w_i min_normal ≤ n_i · F_i ≤ w_i max_normal
///     |t_i · F_i| ≤ friction / √2 · n_i · F_i      for two tangents t_i                (force 2)
///
/// The pyramid (force 2) lies within the friction cone. Forces are continuous in all inputs, and
/// that of a leg fades to 0 as it is unloaded.
///
/// @returns forces, 0 for legs without load, and whether the program was solved
/// @see [FG16] IV: "an optimization based contact force distribution"
[[nodiscard]] ContactForces contact_forces(const ContactForceProblem& problem,
                                           const ContactForceParams& params) noexcept;

}  // namespace hexagait
