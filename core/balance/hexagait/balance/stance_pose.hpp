// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/model/robot_model.hpp>
#include <limits>

namespace hexagait {

inline constexpr double kMaxTilt = 0.6;          ///< of the base against the vertical [rad]
inline constexpr double kReachClearance = 5e-4;  ///< kept from the ends of a leg's reach [m]
/// Weight of heights over horizontal places in (stance 1): height and tilt follow the heights of
/// the feet, and hardly their horizontal places. With 1 a base that (stance 2) keeps on one side
/// leans by 5° over level feet, and stands 1 cm higher than it was told.
inline constexpr double kHeightWeight = 25.0;
inline constexpr double kJointClearance = 1e-3;  ///< kept from the limits of yaw and hip [rad]

/// What the base is to be held over.
struct StanceProblem {
  LegArray<Vector3> p_OF;  ///< targets of moving feet, present places of the others, odom [m]
  LegSet reach;            ///< legs that the pose is adapted to
  LegSet support;          ///< legs over whose support polygon the centre of mass must stay
  double height = 0.0;     ///< of the base above the mean height of the feet in `reach` [m]
  double margin = 0.04;    ///< of the centre of mass from the edge of the polygon [m]
  Pose X_OB;               ///< present pose: stays where the feet leave it open
};

/// How the base is held best.
struct StancePose {
  Pose X_OB;
  /// Distance of the centre of mass from the edge of the polygon [m], as by stability_margin():
  /// −∞ without support.
  double margin = -std::numeric_limits<double>::infinity();
  bool margin_shrunk = false;  ///< the polygon does not allow the margin asked for
  LegSet out_of_reach;         ///< legs of `reach` that don't reach their feet from here
  double objective = 0.0;      ///< (stance 1) [m²]
  int iterations = 0;

  [[nodiscard]] bool reachable() const { return out_of_reach.empty(); }
};

/// The base pose from which the feet are nearest to where they are in the nominal stance:
///
///     min Σ eᵀ W e,   e = R_BO (p_OF − p_OB) − p_BN,   p_BN = (p_BC.x, p_BC.y, −height)  (stance
///     1)
///      W = diag(1, 1, kHeightWeight), over the six parameters of X_OB and all legs in `reach`,
///      with
///     n_jᵀ p_OM ≤ b_j − margin     for every edge of the support polygon               (stance 2)
///     leg reach, yaw and hip limits, each kept by the clearance above, for all in `reach`
///     tilt ≤ kMaxTilt
///
/// Roll and pitch follow: a raised foot that takes part tilts the base. M is the centre of mass of
/// the nominal stance, carried with the base.
///
/// By Newton's method: (stance 1) with its exact Hessian (of Gauss and Newton where that is not
/// convex), the kinematic limits linearised, a quadratic program each, at most ten; usually three.
/// Its unknowns are the place of M and a turn about it: (stance 2) is linear in them and holds
/// exactly. The search starts from the best level pose, which is a closed form.
///
/// A margin that the polygon has no room for is shrunk to what it has. On two feet or one the
/// centre of mass goes over the segment or the point; without support (stance 2) is left out. If
/// the legs cannot all reach, stability comes first, and the legs that pull farthest are given up.
///
/// @see [FG16] II-D; the nominal stance instead of its nominal joint positions, as in [PC04]
[[nodiscard]] StancePose optimise_stance(const RobotModel& model,
                                         const StanceProblem& problem) noexcept;

}  // namespace hexagait
