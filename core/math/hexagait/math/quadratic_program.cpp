// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/math/quadratic_program.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <limits>

namespace hexagait {
namespace {

constexpr double kFeasible = 1e-9;   // tolerated violation, relative to |a| |x| + |b|
constexpr double kRounding = 1e-14;  // the same, relative to the longest x of any iteration
constexpr double kParallel = 1e-9;   // normals at an angle with a smaller sine count as parallel
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr auto at(int i) { return static_cast<std::size_t>(i); }

/// The state of the solver. With N the active normals, J and R satisfy
///
///     Jᵀ H J = 1,   Jᵀ N = (R; 0),   R upper triangular:
///
/// The first q columns of J span the active normals in the metric of H⁻¹, the others the directions
/// in which x may still move.
template <int Variables, int MaxVariables, int MaxConstraints>
class DualActiveSet {
 public:
  using Program = QuadraticProgram<Variables, MaxVariables, MaxConstraints>;
  using Vector = typename Program::Vector;
  using Matrix = typename Program::Matrix;
  using Solution = QpSolution<Variables, MaxVariables>;

  explicit DualActiveSet(const Program& program)
      : program_(program), n_(static_cast<int>(program.g.size())), R_(n_, n_) {
    out_.x = Vector::Zero(n_);
  }

  Solution run() {
    if (!minimise_without_constraints()) return out_;
    const int limit = 4 * (n_ + program_.size) + 20;
    out_.status = QpStatus::iteration_limit;
    while (out_.status == QpStatus::iteration_limit && out_.iterations < limit) {
      const int p = most_violated();
      if (p < 0)
        out_.status = QpStatus::solved;
      else
        make_active(p, limit);
    }
    return out_;
  }

 private:
  // H = L Lᵀ, J = L⁻ᵀ, x = −J Jᵀ g. Pivots within rounding of 0 mean that H is not convex.
  bool minimise_without_constraints() {
    Matrix L = program_.H;
    for (int j = 0; j < n_; ++j) {
      const double before = L(j, j);
      const double pivot = before - L.row(j).head(j).squaredNorm();
      if (!(pivot > 1e-14 * before && pivot < kInfinity)) return false;
      L(j, j) = std::sqrt(pivot);
      for (int i = j + 1; i < n_; ++i)
        L(i, j) = (L(i, j) - L.row(i).head(j).dot(L.row(j).head(j))) / L(j, j);
    }
    J_ = Matrix::Zero(n_, n_);
    for (int j = 0; j < n_; ++j) {  // column by column, L⁻¹ below the diagonal, transposed
      J_(j, j) = 1.0 / L(j, j);
      for (int i = j + 1; i < n_; ++i)
        J_(j, i) = -L.row(i).segment(j, i - j).dot(J_.row(j).segment(j, i - j)) / L(i, i);
    }
    out_.x = -(J_ * (J_.transpose() * program_.g));
    return true;
  }

  int most_violated() {
    const double x = out_.x.norm();
    largest_x_ = std::max(largest_x_, x);
    const double length = kFeasible * x + kRounding * largest_x_;
    std::array<bool, at(MaxConstraints)> is_active{};
    for (int k = 0; k < out_.num_active; ++k) is_active[at(out_.active[at(k)])] = true;
    int worst = -1;
    double most = 0.0;
    for (int i = 0; i < program_.size; ++i) {
      const double slack = program_.b[at(i)] - program_.a[at(i)].dot(out_.x);
      if (slack >= 0.0 || is_active[at(i)]) continue;
      const double norm = program_.a[at(i)].norm();
      if (slack >= -(norm * length + kFeasible * std::abs(program_.b[at(i)]))) continue;
      const double violation = norm > 0.0 ? -slack / norm : kInfinity;
      if (violation > most) most = violation, worst = i;
    }
    return worst;
  }

  // Raises the multiplier of constraint p until p holds. Active constraints whose multiplier would
  // become negative meanwhile are dropped.
  void make_active(int p, int limit) {
    double u_p = 0.0;
    while (out_.iterations++ < limit) {
      const int q = out_.num_active;
      Vector d = -(J_.transpose() * program_.a[at(p)]);
      const double free = norm_from(d, q);
      const Vector r = multipliers_fall(d);

      // Step length until an active multiplier reaches 0, and until p holds.
      const auto [t_dual, blocking] = largest_dual_step(r);
      const double slack = program_.b[at(p)] - program_.a[at(p)].dot(out_.x);
      const bool can_move = free > kParallel * d.norm();
      const double t_primal = can_move ? -slack / (free * free) : kInfinity;
      const double t = std::min(t_dual, t_primal);
      if (t == kInfinity) return give_up(p, u_p);

      for (int k = 0; k < q; ++k) {
        double& u = out_.multiplier[at(k)];
        u = std::max(0.0, u - t * r[k]);
      }
      u_p += t;
      for (int j = q; can_move && j < n_; ++j) out_.x += t * d[j] * J_.col(j);
      if (t == t_primal) return append(p, u_p, d, free);
      drop(blocking);
    }
  }

  double norm_from(const Vector& d, int first) const {
    double sum = 0.0;
    for (int j = first; j < n_; ++j) sum += d[j] * d[j];
    return std::sqrt(sum);
  }

  // R⁻¹ d: decrease of the active multipliers per unit of the new one.
  Vector multipliers_fall(const Vector& d) const {
    Vector r(n_);
    for (int k = out_.num_active - 1; k >= 0; --k) {
      double sum = d[k];
      for (int j = k + 1; j < out_.num_active; ++j) sum -= R_(k, j) * r[j];
      r[k] = sum / R_(k, k);
    }
    return r;
  }

  struct DualStep {
    double length = kInfinity;
    int blocking = -1;
  };
  DualStep largest_dual_step(const Vector& r) const {
    DualStep step;
    for (int k = 0; k < out_.num_active; ++k) {
      if (!(r[k] > 0.0)) continue;
      const double length = std::max(out_.multiplier[at(k)], 0.0) / r[k];
      if (length < step.length) step = {length, k};
    }
    return step;
  }

  void give_up(int p, double u_p) {
    out_.status = QpStatus::infeasible;
    out_.active[at(out_.num_active)] = p;
    out_.multiplier[at(out_.num_active)] = u_p;
    ++out_.num_active;
  }

  // A reflection of the free columns of J, after which only the first meets the new normal.
  void append(int p, double u_p, Vector& d, double free) {
    const int q = out_.num_active;
    const double reflected = d[q] >= 0.0 ? -free : free;
    d[q] -= reflected;
    Vector Jd = Vector::Zero(n_);
    for (int j = q; j < n_; ++j) Jd += d[j] * J_.col(j);
    Jd *= 1.0 / (free * std::abs(d[q]));
    for (int j = q; j < n_; ++j) J_.col(j) -= d[j] * Jd;
    d[q] = reflected;
    for (int i = 0; i <= q; ++i) R_(i, q) = d[i];
    out_.active[at(q)] = p;
    out_.multiplier[at(q)] = u_p;
    ++out_.num_active;
  }

  // Removes column k of R; plane rotations make the rest upper triangular again.
  void drop(int k) {
    const int q = --out_.num_active;
    for (int j = k; j < q; ++j) {
      for (int i = 0; i <= j + 1; ++i) R_(i, j) = R_(i, j + 1);
      out_.active[at(j)] = out_.active[at(j + 1)];
      out_.multiplier[at(j)] = out_.multiplier[at(j + 1)];
    }
    for (int j = k; j < q; ++j) {
      const double radius = portable::hypot(R_(j, j), R_(j + 1, j));
      const double c = R_(j, j) / radius, s = R_(j + 1, j) / radius;
      for (int i = j; i < q; ++i) {
        const double upper = R_(j, i), lower = R_(j + 1, i);
        R_(j, i) = c * upper + s * lower;
        R_(j + 1, i) = c * lower - s * upper;
      }
      const Vector first = J_.col(j);
      J_.col(j) = c * first + s * J_.col(j + 1);
      J_.col(j + 1) = c * J_.col(j + 1) - s * first;
    }
  }

  const Program& program_;
  int n_;
  Solution out_;
  Matrix J_, R_;
  double largest_x_ = 0.0;
};

}  // namespace

const char* to_string(QpStatus status) noexcept {
  switch (status) {
    case QpStatus::solved:
      return "solved";
    case QpStatus::infeasible:
      return "infeasible";
    case QpStatus::iteration_limit:
      return "iteration limit";
    case QpStatus::not_convex:
      return "not convex";
  }
  return "?";
}

template <int Variables, int MaxVariables, int MaxConstraints>
QpSolution<Variables, MaxVariables> solve(
    const QuadraticProgram<Variables, MaxVariables, MaxConstraints>& program) noexcept {
  return DualActiveSet<Variables, MaxVariables, MaxConstraints>(program).run();
}

template QpSolution<6, 6> solve(const PoseProgram&) noexcept;
template QpSolution<Eigen::Dynamic, 36> solve(const ForceProgram&) noexcept;

}  // namespace hexagait
