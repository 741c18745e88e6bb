// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/leg_solution.hpp>

/// Kinematics of a leg of 3 to 6 revolute joints about any axes. Behind kinematics.hpp, whose
/// functions say what theirs of the same names return.
///
/// With all joints at zero, joint i turns about the line through p_i along a_i (unit vector), and
/// the foot is at p_F, all in the body frame: LegModel's p_BJ0, axis_B0, p_BF0. Product of
/// exponentials, R_i = exp(a_i q_i):
///
///     X_i(p) = p_i + R_i (p − p_i),   p_BF = X_1(X_2(… X_n(p_F)))                         (leg 1)
///     â_i = R_1 … R_{i−1} a_i,   p̂_i = X_1(… X_{i−1}(p_i)),   J_i = â_i × (p_BF − p̂_i)    (leg 2)
///
/// LegTrig: cosine and sine of each q_i.
namespace hexagait::serial {

[[nodiscard]] LegTrig leg_trig(const LegModel& leg, const LegJoints& q) noexcept;
[[nodiscard]] Vector3 foot_position(const LegModel& leg, const LegTrig& trig) noexcept;
[[nodiscard]] LegJacobian foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept;

/// R_1 … R_n: of the frame that is parallel to the body's with all joints at zero.
[[nodiscard]] Matrix3 tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept;

/// Σ t_i + ½ Σ_{j<i} t_j × t_i,  t_i = â_i dq_i: each axis as the ones before have half turned it.
[[nodiscard]] Vector3 tibia_turn(const LegModel& leg, const LegTrig& trig,
                                 const LegJoints& dq) noexcept;

/// Of the joint values within their limits that put the foot at p_BF, those nearest to the nominal
/// ones, as far as one gets from `near` on a continuous path: so what a leg of more than three
/// joints answers depends on the foot and not on the way there.
///
/// Iterates, with e = p_BF − p(q), J of the joints that are free, and r what is left to q_nominal:
///
///     Δq = Jᵀ (J Jᵀ + λ²)⁻¹ e + γ (1 − J⁺ J) r                                            (leg 3)
///     λ² = μ e²:  next to singularities, and far from the answer, steps are small         (leg 4)
///
/// A joint that Δq would take beyond a limit goes to it and is no longer free, its part of e is
/// taken off, and Δq is solved for again. A step that doesn't bring the foot nearer is not taken,
/// and μ rises (Levenberg and Marquardt). At most kMaxIterations steps, γ = 0 in the second half of
/// them; if they fail, so many with γ = 0 from `near`, and from the nominal stance.
///
/// Where the target is nearer to or farther from the hip than [min_reach, max_reach], it counts as
/// unreachable and is moved there; the answer then is a minimum of the distance, if only of those
/// around.
/// @pre 0 < min_reach <= max_reach, and q_nominal is within the limits
[[nodiscard]] LegSolution inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                             const LegJoints& near) noexcept;

/// Bound on the iterations of a search.
inline constexpr int kMaxIterations = 60;

}  // namespace hexagait::serial
