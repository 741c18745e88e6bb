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
/// All storage is inline. n is fixed, or at most MaxVariables; m is at most MaxConstraints.
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
  infeasible,       ///< the constraints in `active` contradict each other
  iteration_limit,  ///< stopped early; x is not feasible
  not_convex,       ///< H is not numerically positive definite; x = 0
};

[[nodiscard]] const char* to_string(QpStatus status) noexcept;

/// The minimiser and its Karush-Kuhn-Tucker certificate:
///
///     H x + g + Σ u_i a_i = 0,   u_i ≥ 0,   a_iᵀ x = b_i for every active i               (qp 2)
///
/// Multipliers of inactive constraints are 0.
template <int Variables, int MaxVariables>
struct QpSolution {
  Eigen::Matrix<double, Variables, 1, 0, MaxVariables, 1> x;
  QpStatus status = QpStatus::not_convex;
  int iterations = 0;  ///< constraints added to or dropped from the active set
  int num_active = 0;
  std::array<int, static_cast<std::size_t>(MaxVariables) + 1> active{};  ///< indices of constraints
  std::array<double, static_cast<std::size_t>(MaxVariables) + 1> multiplier{};  ///< u of `active`
};

/// Solves (qp 1) by the dual active-set method. It starts at the unconstrained minimum and
/// repeatedly adds the most violated constraint to the active set, dropping constraints whose
/// multiplier would become negative: every iterate satisfies (qp 2) except for feasibility.
///
/// Constraints may be redundant, repeated, opposite (an equality) or all zero. A constraint counts
/// as satisfied within 1e-9 (|a_i| |x| + |b_i|). Normals that differ by an angle of less than 1e-9
/// in the metric of H⁻¹ count as parallel. At most 4 (n + m) + 20 iterations.
///
/// Limitation: if the feasible set is thinner than that tolerance, nearly parallel constraints that
/// are all tight may be reported as infeasible.
///
/// @see Goldfarb and Idnani, A numerically stable dual method for solving strictly convex quadratic
///      programs, Mathematical Programming 27, 1983
template <int Variables, int MaxVariables, int MaxConstraints>
[[nodiscard]] QpSolution<Variables, MaxVariables> solve(
    const QuadraticProgram<Variables, MaxVariables, MaxConstraints>& program) noexcept;

/// The two instances: a pose, and the contact forces of up to twelve feet.
using PoseProgram = QuadraticProgram<6, 6, 88>;
using ForceProgram = QuadraticProgram<Eigen::Dynamic, 36, 88>;

extern template QpSolution<6, 6> solve(const PoseProgram&) noexcept;
extern template QpSolution<Eigen::Dynamic, 36> solve(const ForceProgram&) noexcept;

}  // namespace hexagait
