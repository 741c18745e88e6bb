// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/leg_solution.hpp>

namespace hexagait {

/// Kinematics of a leg of 3 to 6 revolute joints about any axes.
///
/// With all joints at zero, joint i turns about the line through p_i along the unit vector a_i, and
/// the foot is at p_F, all in the body frame: LegModel's p_BJ0, axis_B0, p_BF0. Product of
/// exponentials, R_i = exp(a_i q_i):
///
///     X_i(p) = p_i + R_i (p − p_i),   p_BF = X_1(X_2(… X_n(p_F)))                         (leg 1)
///     â_i = R_1 … R_{i−1} a_i,   p̂_i = X_1(… X_{i−1}(p_i)),   J_i = â_i × (p_BF − p̂_i)   (leg 2)
///
/// LegTrig: cosine and sine of each q_i.
struct SerialLeg {
  static LegTrig leg_trig(const LegModel& leg, const LegJoints& q) noexcept;
  static Vector3 foot_position(const LegModel& leg, const LegTrig& trig) noexcept;
  static LegJacobian foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept;

  /// Jᵀ F
  static LegJoints foot_effort(const LegModel& leg, const LegTrig& trig,
                               const Vector3& force_B) noexcept;

  /// R_1 … R_n: T is parallel to the body frame when all joints are at zero.
  static Matrix3 tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept;

  /// Σ t_i + ½ Σ_{j<i} t_j × t_i with t_i = â_i dq_i.
  static Vector3 tibia_turn(const LegModel& leg, const LegTrig& trig, const LegJoints& dq) noexcept;

  /// Of the joint values within their limits that put the foot at p_BF, the one nearest to
  /// q_nominal that a continuous motion from `near` reaches. So the answer of a leg of more than
  /// three joints depends on the foot's position and not on how it came there. Nearness counts in the
  /// room s_i that joint i has about q_nominal, ¼ to 1 rad: Σ ((q_i − q_nominal,i) / s_i)². Joints
  /// that stand near a limit leave the motion to those that do not.
  ///
  /// Iterates, with e = p_BF − p(q), S = diag s, J the Jacobian of the free joints times S, and
  /// r = S⁻¹ (q_nominal − q):
  ///
  ///     Δq = S (Jᵀ (J Jᵀ + λ²)⁻¹ e + γ (1 − J⁺ J) r)                                  (leg 3)
  ///     λ² = μ e²                                                                     (leg 4)
  ///
  /// λ damps steps near singularities and far from the target; γ is the null-space gain. A joint
  /// that Δq would move beyond a limit is fixed at that limit, its contribution is subtracted from
  /// e, and Δq is solved for again. A step that does not bring the foot closer is rejected and μ
  /// rises (Levenberg-Marquardt). At most kMaxIterations steps, with γ = 0 in the second half. If
  /// they fail, the search is repeated with γ = 0 from `near`, then from the nominal stance.
  ///
  /// A target whose distance from the hip is outside [min_reach, max_reach] is unreachable and is
  /// moved to the nearest distance; the answer is then a local minimum of the foot's distance from
  /// the target.
  /// @pre 0 < min_reach <= max_reach, and q_nominal is within the limits
  static LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                        const LegJoints& near) noexcept;
  static LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                        const LegJoints& near, const LegTrig&) noexcept {
    return inverse_kinematics(leg, p_BF, near);
  }

  /// Bound on the iterations of one search.
  static constexpr int kMaxIterations = 60;
};

static_assert(LegKinematics<SerialLeg>);

}  // namespace hexagait
