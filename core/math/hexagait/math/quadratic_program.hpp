// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cstdint>

namespace hexagait {

/// A small, dense, strictly convex quadratic program
///
///     min ½ xᵀ H x + gᵀ x   subject to   a_iᵀ x ≤ b_i,  i = 0 … m − 1                     (qp 1)
///
/// All storage is inline: n is fixed or at most MaxVariables, m at most MaxConstraints.
template <int Variables, int MaxVariables, int MaxConstraints>
struct QuadraticProgram {
  using Vector = Eigen::Matrix<double, Variables, 1, 0, MaxVariables, 1>;
  using Matrix = Eigen::Matrix<double, Variables, Variables, 0, MaxVariables, MaxVariables>;

  Matrix H;  ///< symmetric, positive definite; only the lower triangle is read
  Vector g;
  std::array<Vector, static_cast<std::size_t>(MaxConstraints)> a;
  std::array<double, static_cast<std::size_t>(MaxConstraints)> b;
  int size = 0;  ///< m

  void add(const Vector& normal, double bound) {
    assert(size < MaxConstraints);
    a[static_cast<std::size_t>(size)] = normal;
    b[static_cast<std::size_t>(size)] = bound;
    ++size;
  }
};

enum class QpStatus : std::uint8_t {
  solved,
  infeasible,       ///< `active` names constraints that contradict one another
  iteration_limit,  ///< x is what was reached: not feasible yet
  not_convex,       ///< H is not positive definite to rounding; x = 0
};

/// The minimum, and the Karush-Kuhn-Tucker certificate that it is one:
///
///     H x + g + Σ u_i a_i = 0,   u_i ≥ 0,   a_iᵀ x = b_i for every active i               (qp 2)
///
/// Multipliers of constraints that are not active are 0.
template <int Variables, int MaxVariables>
struct QpSolution {
  Eigen::Matrix<double, Variables, 1, 0, MaxVariables, 1> x;
  QpStatus status = QpStatus::not_convex;
  int iterations = 0;  ///< constraints taken up or given up again
  int num_active = 0;
  std::array<int, static_cast<std::size_t>(MaxVariables) + 1> active{};  ///< indices of constraints
  std::array<double, static_cast<std::size_t>(MaxVariables) + 1> multiplier{};  ///< u of `active`
};

/// Solves (qp 1) by the dual active-set method: from the unconstrained minimum, the constraint that
/// is violated most is made active, and those that hold x back for no reason are given up on the
/// way, so that (qp 2) holds all the time but for feasibility.
///
/// Constraints may be redundant, repeated, opposite (an equality) or all zero. Feasible means: to
/// 1e-9 of |a_i| |x| + |b_i|; where that is thicker than what the constraints leave, nearly
/// parallel ones may be called infeasible. Normals nearer to parallel than 1e-9 (in the metric of
/// H⁻¹) count as parallel. At most 4 (n + m) + 20 iterations.
///
/// @see Goldfarb and Idnani, A numerically stable dual method for solving strictly convex quadratic
///      programs, Mathematical Programming 27, 1983
template <int Variables, int MaxVariables, int MaxConstraints>
[[nodiscard]] QpSolution<Variables, MaxVariables> solve(
    const QuadraticProgram<Variables, MaxVariables, MaxConstraints>& program) noexcept;

/// The sizes there are: a pose, and the contact forces of up to twelve feet.
using PoseProgram = QuadraticProgram<6, 6, 88>;
using ForceProgram = QuadraticProgram<Eigen::Dynamic, 36, 88>;

extern template QpSolution<6, 6> solve(const PoseProgram&) noexcept;
extern template QpSolution<Eigen::Dynamic, 36> solve(const ForceProgram&) noexcept;

}  // namespace hexagait
