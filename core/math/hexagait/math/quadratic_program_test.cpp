// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nlopt.h>

#include <Eigen/Dense>
#include <algorithm>
#include <hexagait/math/quadratic_program.hpp>
#include <hexagait/sim/random.hpp>
#include <vector>

namespace hexagait {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd random_vector(int n, RandomSequence& random) {
  VectorXd v(n);
  for (double& x : v) x = random.uniform(-1.0, 1.0);
  return v;
}

/// H with eigenvalues from 1 down to `smallest`, axes anyhow.
MatrixXd random_convex(int n, double smallest, RandomSequence& random) {
  MatrixXd A(n, n);
  for (int j = 0; j < n; ++j) A.col(j) = random_vector(n, random);
  const MatrixXd Q = A.householderQr().householderQ();
  VectorXd eigenvalues(n);
  for (double& value : eigenvalues) value = std::pow(smallest, random.u01());
  return Q * eigenvalues.asDiagonal() * Q.transpose();
}

template <class Program>
Program program_of(const MatrixXd& H, const VectorXd& g) {
  Program program;
  program.H = H;
  program.g = g;
  return program;
}

/// m constraints around a point that satisfies them; some touch it, some are repeated, scaled,
/// nearly repeated, opposite (an equality) or all zero.
template <class Program>
void add_feasible(Program& program, int m, const VectorXd& inside, RandomSequence& random) {
  const int n = static_cast<int>(inside.size());
  while (program.size < m) {
    const double kind = random.u01();
    VectorXd normal = random_vector(n, random) * std::pow(10.0, random.uniform(-2.0, 2.0));
    if (program.size > 0 && kind < 0.4) {
      const VectorXd other = program.a[random.draw % static_cast<std::size_t>(program.size)];
      if (kind < 0.1) normal = other;
      if (kind >= 0.1 && kind < 0.2) normal = -2.0 * other;
      if (kind >= 0.2 && kind < 0.3) normal = other + 1e-5 * other.norm() * normal.normalized();
      if (kind >= 0.3) normal.setZero();
    }
    // A tight bunch of nearly parallel ones leaves less than rounding: that is not promised.
    const bool tight = random.u01() < 0.3 && !(kind >= 0.2 && kind < 0.3);
    const double slack = tight ? 0.0 : normal.norm() * random.uniform(1e-3, 0.5);
    program.add(normal, normal.dot(inside) + slack);
  }
}

/// (qp 2), checked from scratch. Necessary and sufficient for a minimum, as H is positive definite.
/// @param scale  of rounding in what is summed
template <class Program, class Solution>
void expect_minimum(const Program& program, const Solution& solution, double scale) {
  const MatrixXd H = MatrixXd(program.H).template selfadjointView<Eigen::Lower>();
  VectorXd gradient = H * solution.x + program.g;
  double largest = gradient.norm();
  for (int k = 0; k < solution.num_active; ++k) {
    const auto j = static_cast<std::size_t>(k);
    const auto i = static_cast<std::size_t>(solution.active[j]);
    EXPECT_GE(solution.multiplier[j], 0.0);
    gradient += solution.multiplier[j] * program.a[i];
    largest = std::max(largest, solution.multiplier[j] * program.a[i].norm());
    EXPECT_NEAR(program.a[i].dot(solution.x), program.b[i], scale * program.a[i].norm());
  }
  EXPECT_LT(gradient.norm(), scale * std::max(largest, 1.0));
  for (std::size_t i = 0; i < static_cast<std::size_t>(program.size); ++i)
    EXPECT_LE(program.a[i].dot(solution.x), program.b[i] + scale * program.a[i].norm()) << i;
}

// ½(x − c)² over x₀ ≤ 1: the nearest point to c = (3, 2, …) has x₀ = 1, and pushes with 3 − 1 = 2.
TEST(QuadraticProgram, IsTheNearestPointOfAHalfSpace) {
  PoseProgram program = program_of<PoseProgram>(MatrixXd::Identity(6, 6), VectorXd::Zero(6));
  program.g << -3, -2, 0, 0, 0, 0;
  program.add(Eigen::Vector<double, 6>::Unit(0), 1.0);
  const auto solution = solve(program);
  EXPECT_EQ(solution.status, QpStatus::solved);
  EXPECT_EQ(solution.num_active, 1);
  EXPECT_NEAR(solution.multiplier[0], 2.0, 1e-15);
  EXPECT_NEAR((solution.x - Eigen::Vector<double, 6>(1, 2, 0, 0, 0, 0)).norm(), 0.0, 1e-15);
}

// Nothing to hold it back: H x = −g.
TEST(QuadraticProgram, SolvesTheLinearSystemWithoutConstraints) {
  RandomSequence random{.seed = 1};
  for (int n = 1; n <= 36; ++n) {
    const MatrixXd H = random_convex(n, 1e-3, random);
    const VectorXd x = random_vector(n, random);
    const auto solution = solve(program_of<ForceProgram>(H, -H * x));
    EXPECT_EQ(solution.status, QpStatus::solved);
    EXPECT_EQ(solution.iterations, 0);
    EXPECT_LT((solution.x - x).norm(), 1e-11);
  }
}

TEST(QuadraticProgram, SatisfiesTheOptimalityConditionsForSixVariables) {
  RandomSequence random{.seed = 2};
  for (int trial = 0; trial < 2000; ++trial) {
    const MatrixXd H = random_convex(6, trial % 2 ? 1e-1 : 1e-3, random);
    auto program = program_of<PoseProgram>(H, 2.0 * random_vector(6, random));
    add_feasible(program, trial % 60, random_vector(6, random), random);
    const auto solution = solve(program);
    ASSERT_EQ(solution.status, QpStatus::solved) << trial;
    expect_minimum(program, solution, 1e-7);
    ASSERT_FALSE(HasFailure()) << trial;
  }
}

TEST(QuadraticProgram, SatisfiesTheOptimalityConditionsForAnyNumberOfVariables) {
  RandomSequence random{.seed = 3};
  for (int trial = 0; trial < 360; ++trial) {
    const int n = 1 + trial % 36;
    const MatrixXd H = random_convex(n, 1e-4, random);
    auto program = program_of<ForceProgram>(H, 2.0 * random_vector(n, random));
    add_feasible(program, (trial * 7) % 89, random_vector(n, random), random);
    const auto solution = solve(program);
    ASSERT_EQ(solution.status, QpStatus::solved) << trial;
    expect_minimum(program, solution, 1e-7);
    ASSERT_FALSE(HasFailure()) << trial;
  }
}

struct NloptProblem {
  const ForceProgram* program;
};

double objective(unsigned n, const double* x, double* gradient, void* context) {
  const ForceProgram& program = *static_cast<NloptProblem*>(context)->program;
  const Eigen::Map<const VectorXd> at(x, n);
  if (gradient) Eigen::Map<VectorXd>(gradient, n) = program.H * at + program.g;
  return 0.5 * at.dot(program.H * at) + program.g.dot(at);
}

void constraints(unsigned m, double* result, unsigned n, const double* x, double* gradient,
                 void* context) {
  const ForceProgram& program = *static_cast<NloptProblem*>(context)->program;
  for (unsigned i = 0; i < m; ++i) {
    result[i] = program.a[i].dot(Eigen::Map<const VectorXd>(x, n)) - program.b[i];
    if (gradient) Eigen::Map<VectorXd>(gradient + i * n, n) = program.a[i];
  }
}

/// The minimum by sequential least squares (Kraft), which shares nothing with ours.
double minimum_by_slsqp(const ForceProgram& program, VectorXd x) {
  const auto n = static_cast<unsigned>(x.size()), m = static_cast<unsigned>(program.size);
  NloptProblem problem{&program};
  nlopt_opt slsqp = nlopt_create(NLOPT_LD_SLSQP, n);
  nlopt_set_min_objective(slsqp, objective, &problem);
  const std::vector<double> tolerance(m, 1e-10);
  if (m > 0) nlopt_add_inequality_mconstraint(slsqp, m, constraints, &problem, tolerance.data());
  nlopt_set_ftol_rel(slsqp, 1e-13);
  nlopt_set_maxeval(slsqp, 500);
  double minimum = 0.0;
  EXPECT_NE(nlopt_optimize(slsqp, x.data(), &minimum), NLOPT_INVALID_ARGS);
  nlopt_destroy(slsqp);
  return minimum;
}

TEST(QuadraticProgram, FindsTheMinimumThatSequentialLeastSquaresFinds) {
  RandomSequence random{.seed = 4};
  for (int trial = 0; trial < 120; ++trial) {
    const int n = 1 + trial % 8;
    const MatrixXd H = random_convex(n, 1e-2, random);
    auto program = program_of<ForceProgram>(H, 2.0 * random_vector(n, random));
    const VectorXd inside = random_vector(n, random);
    for (int i = 0; i < trial % 25; ++i) {
      const VectorXd normal = random_vector(n, random);
      program.add(normal, normal.dot(inside) + random.uniform(0.0, 0.3));
    }
    const auto solution = solve(program);
    ASSERT_EQ(solution.status, QpStatus::solved);
    const double found = 0.5 * solution.x.dot(program.H * solution.x) + program.g.dot(solution.x);
    ASSERT_NEAR(found, minimum_by_slsqp(program, inside), 1e-7) << trial;
  }
}

// A contradiction is one with a certificate (Farkas): λ ≥ 0 with Σ λ_i a_i = 0 and Σ λ_i b_i < 0.
// Here the normals before the last span it, so that λ follows by least squares.
TEST(QuadraticProgram, NamesConstraintsThatContradictOneAnother) {
  RandomSequence random{.seed = 5};
  for (int trial = 0; trial < 1000; ++trial) {
    auto program =
        program_of<PoseProgram>(random_convex(6, 1e-2, random), 2.0 * random_vector(6, random));
    add_feasible(program, trial % 20, random_vector(6, random), random);
    VectorXd sum = VectorXd::Zero(6);  // normals that close a ring, bounds that leave no room
    double bound = -random.uniform(0.01, 1.0);
    for (int i = 0; i < 1 + trial % 6; ++i) {
      const VectorXd normal = random_vector(6, random);
      const double b = random.uniform(-1.0, 1.0);
      program.add(normal, b);
      sum -= normal;
      bound -= b;
    }
    program.add(sum, bound);
    const auto solution = solve(program);
    ASSERT_EQ(solution.status, QpStatus::infeasible) << trial;

    const int k = solution.num_active - 1;
    MatrixXd N(6, k);
    VectorXd b(k);
    for (int j = 0; j < k; ++j) {
      const auto i = static_cast<std::size_t>(solution.active[static_cast<std::size_t>(j)]);
      N.col(j) = program.a[i];
      b[j] = program.b[i];
    }
    const auto last = static_cast<std::size_t>(solution.active[static_cast<std::size_t>(k)]);
    const VectorXd lambda = N.colPivHouseholderQr().solve(-program.a[last]);
    ASSERT_LT((N * lambda + program.a[last]).norm(), 1e-5 * program.a[last].norm()) << trial;
    ASSERT_GE(k > 0 ? lambda.minCoeff() : 0.0, -1e-6) << trial;
    ASSERT_LT(b.dot(lambda) + program.b[last], 0.0) << trial;
  }
}

// x₀ ≤ 1 four times, in four scales: the same minimum as once.
TEST(QuadraticProgram, IsNotMovedByRepeatedConstraints) {
  PoseProgram program = program_of<PoseProgram>(MatrixXd::Identity(6, 6), -3 * VectorXd::Ones(6));
  for (const double scale : {1.0, 1.0, 1e-6, 1e6})
    program.add(scale * Eigen::Vector<double, 6>::Unit(0), scale);
  const auto solution = solve(program);
  EXPECT_EQ(solution.status, QpStatus::solved);
  EXPECT_EQ(solution.num_active, 1);
  EXPECT_NEAR(solution.x[0], 1.0, 1e-14);
}

TEST(QuadraticProgram, KeepsAnEqualityWrittenAsTwoInequalities) {
  RandomSequence random{.seed = 6};
  for (int trial = 0; trial < 500; ++trial) {
    auto program =
        program_of<PoseProgram>(random_convex(6, 1e-2, random), 2.0 * random_vector(6, random));
    const VectorXd at = random_vector(6, random);
    for (int i = 0; i < 1 + trial % 5; ++i) {
      const VectorXd normal = random_vector(6, random);
      program.add(normal, normal.dot(at));
      program.add(-normal, -normal.dot(at));
    }
    const auto solution = solve(program);
    ASSERT_EQ(solution.status, QpStatus::solved) << trial;
    expect_minimum(program, solution, 1e-9);
  }
}

TEST(QuadraticProgram, SaysSoIfHIsNotPositiveDefinite) {
  for (const double last : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    PoseProgram program = program_of<PoseProgram>(MatrixXd::Identity(6, 6), VectorXd::Ones(6));
    program.H(5, 5) = last;
    EXPECT_EQ(solve(program).status, QpStatus::not_convex);
    EXPECT_EQ(solve(program).x.norm(), 0.0);
  }
}

// No constraint can be met by a zero normal and a negative bound; with another bound it says
// nothing.
TEST(QuadraticProgram, TakesZeroNormalsAtTheirWord) {
  PoseProgram program = program_of<PoseProgram>(MatrixXd::Identity(6, 6), VectorXd::Ones(6));
  program.add(VectorXd::Zero(6), 0.0);
  EXPECT_EQ(solve(program).status, QpStatus::solved);
  program.add(VectorXd::Zero(6), -1e-3);
  EXPECT_EQ(solve(program).status, QpStatus::infeasible);
}

}  // namespace
}  // namespace hexagait
