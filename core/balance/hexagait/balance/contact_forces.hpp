// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait {

/// Force and moment about the origin of the body, axes of the body.
struct Wrench {
  Vector3 force = Vector3::Zero();   ///< [N]
  Vector3 moment = Vector3::Zero();  ///< [N m]
};

struct ContactForceParams {
  /// Of foot and ground. Larger than true: feet slip; smaller: less sideways force can be had.
  double friction = 0.6;
  double min_normal = 0.0;    ///< of a fully loaded foot [N]
  double max_normal = 600.0;  ///< of a fully loaded foot [N]
  /// Price of force on a fully loaded foot, relative to that of wrench error. Larger: the wrench is
  /// met less exactly; smaller: rounding. Must be positive.
  double price = 1e-6;
  double moment_arm = 0.4;  ///< a moment weighs like a force on this arm [m]
};

struct ContactForceProblem {
  Wrench wrench;               ///< what the ground is to do to the robot
  LegArray<Vector3> p_BF;      ///< feet, body frame [m]
  LegArray<Vector3> normal_B;  ///< of the surface at each foot, out of the ground, unit vectors
  LegArray<double> share;      ///< 0 for a leg in the air … 1 for one that carries fully
};

/// Forces of the ground on the feet that come nearest to a wrench:
///
///     min |Σ F_i − F|² + |Σ p_i × F_i − M|² / arm² + price Σ |F_i|² / share_i         (force 1)
///     share_i min_normal ≤ n_i · F_i ≤ share_i max_normal
///     |t_i · F_i| ≤ friction / √2 · n_i · F_i      for two tangents t_i                (force 2)
///
/// The pyramid (force 2) is inside the friction cone. A force is continuous in everything, and at
/// most share_i max_normal along its normal: it fades as its leg is unloaded.
///
/// @returns forces in the body frame [N]; 0 for legs without share
/// @see [FG16] IV: "an optimization based contact force distribution"
[[nodiscard]] LegArray<Vector3> contact_forces(const ContactForceProblem& problem,
                                               const ContactForceParams& params) noexcept;

}  // namespace hexagait
