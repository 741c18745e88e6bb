// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/model/robot_model.hpp>
#include <limits>

namespace hexagait {

inline constexpr double kMaxTilt = 0.6;          ///< of the base from the horizontal [rad]
inline constexpr double kReachClearance = 1e-3;  ///< kept from the ends of a leg's reach, of it
inline constexpr double kJointClearance = 1e-3;  ///< kept from the limits of yaw and hip [rad]

/// Weight of vertical against horizontal errors in (stance 1): height and tilt follow the heights
/// of the feet, hardly their horizontal positions. With 1, a base that (stance 2) holds to one side
/// would lean by 5° over level feet and stand 1 cm too high.
inline constexpr double kHeightWeight = 25.0;

/// The stance for which a base pose is sought.
struct StanceProblem {
  LegArray<Vector3> p_OF;  ///< targets of moving feet, positions of the others, odom [m]
  LegSet reach;            ///< legs that the pose is adapted to
  LegSet support;          ///< legs whose support polygon must contain the centre of mass
  double height = 0.0;     ///< desired, above the mean height of the feet in `reach` [m]
  double margin = 0.0;     ///< desired, of the centre of mass from the edges of the polygon [m]
  Pose X_OB;               ///< present pose; kept where the feet do not determine the new one
};

/// The result of optimise_stance().
struct StancePose {
  Pose X_OB;
  /// stability_margin() of the centre of mass [m]; −∞ without support.
  double margin = -std::numeric_limits<double>::infinity();
  bool margin_shrunk = false;  ///< the polygon is too small for the desired margin
  LegSet out_of_reach;         ///< legs of `reach` that cannot reach their feet from this pose
  double objective = 0.0;      ///< (stance 1) [m²]
  int iterations = 0;

  [[nodiscard]] bool reachable() const { return out_of_reach.empty(); }
};

/// The base pose that brings the feet as close as possible to their nominal positions:
///
///     min Σ eᵀ W e,   e = R_BO (p_OF − p_OB) − p_BN                                    (stance 1)
///     p_BN = (p_BC.x, p_BC.y, −height),   W = diag(1, 1, kHeightWeight)
///     n_jᵀ p_OM ≤ b_j − margin     for every edge of the support polygon               (stance 2)
///
/// over the six parameters of X_OB, with the sum over all legs in `reach`, subject to (stance 2),
/// the reach and the yaw and hip limits of these legs less the clearances above, and tilt ≤
/// kMaxTilt. M is the centre of mass of the nominal stance, moved with the base. Roll and pitch
/// follow from the feet: a raised foot in `reach` tilts the base.
///
/// Newton's method with the exact Hessian of (stance 1) (Gauss-Newton where that is not convex) and
/// linearised kinematic limits: a quadratic program per iteration, usually three, at most 16. The
/// unknowns are the position of M and a rotation about it, in which (stance 2) is linear and holds
/// exactly. The search starts from the best level pose, which has a closed form.
///
/// A margin that is too large for the polygon is reduced. On two feet or one, the centre of mass is
/// placed over the segment or the point; without support (stance 2) is left out. If not all legs
/// can reach their feet, stability has priority, and the legs farthest from their nominal positions
/// are given up.
///
/// @see [FG16] II-D; nominal foot positions, as in [PC04], in place of its nominal joint positions
[[nodiscard]] StancePose optimise_stance(const RobotModel& model,
                                         const StanceProblem& problem) noexcept;

}  // namespace hexagait
