// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/balance/contact_forces.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait::contact_forces_test {
namespace {

constexpr double kWeight = 490.5;  // [N]

/// Six feet, two rows of three, on level ground, all carrying.
ContactForceProblem standing() {
  ContactForceProblem problem{{{0.0, 0.0, kWeight}, Vector3::Zero()},
                              LegArray<Vector3>(6),
                              LegArray<Vector3>(6, Vector3::UnitZ()),
                              LegArray<double>(6, 1.0)};
  for (LegId i = 0; i < 6; ++i)
    problem.p_BF[i] = {0.45 * (1 - i / 2), i % 2 == 0 ? 0.5 : -0.5, -0.3};
  return problem;
}

Wrench wrench_of(const ContactForceProblem& problem, const LegArray<Vector3>& force) {
  Wrench sum;
  for (LegId i = 0; i < force.size(); ++i) {
    sum.force += force[i];
    sum.moment += problem.p_BF[i].cross(force[i]);
  }
  return sum;
}

double mismatch(const Wrench& a, const Wrench& b) {
  return (a.force - b.force).norm() + (a.moment - b.moment).norm();
}

// By symmetry every foot carries a sixth, straight up.
TEST(ContactForces, ShareTheWeightAlikeOnARegularStance) {
  const LegArray<Vector3> force = contact_forces(standing(), {}).force;
  for (const Vector3& F : force) EXPECT_LT((F - Vector3(0, 0, kWeight / 6)).norm(), 1e-3);
}

// The wrench of forces inside their pyramids can be had, so it is: the regularisation of force
// leaves an error of 1e-6 · |F| at most.
TEST(ContactForces, ReproduceAWrenchThatIsFeasible) {
  RandomSequence random{.seed = 1};
  for (int trial = 0; trial < 500; ++trial) {
    ContactForceProblem problem = standing();
    LegArray<Vector3> inside(6, Vector3::Zero());
    for (LegId i = 0; i < 6; ++i) {
      problem.p_BF[i] += 0.1 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.u01());
      problem.load[i] = trial % 6 == i || trial % 4 == i ? 0.0 : 1.0;
      const double up = random.uniform(60.0, 200.0);
      const Vector3 sideways(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0.0);
      inside[i] = problem.load[i] * up * (Vector3::UnitZ() + sideways);
    }
    problem.wrench = wrench_of(problem, inside);
    const LegArray<Vector3> force = contact_forces(problem, {}).force;
    ASSERT_LT(mismatch(wrench_of(problem, force), problem.wrench), 0.01) << trial;
  }
}

// Any wrench, also one that would need feet that pull.
TEST(ContactForces, StayInTheFrictionConeAndWithinTheirLimits) {
  RandomSequence random{.seed = 2};
  const ContactForceParams params{.friction = 0.5, .min_normal = 5.0, .max_normal = 300.0};
  for (int trial = 0; trial < 1000; ++trial) {
    ContactForceProblem problem = standing();
    const auto draw = [&](double width) { return random.uniform(-width, width); };
    problem.wrench = {{draw(600), draw(600), draw(900)}, {draw(300), draw(300), draw(300)}};
    for (LegId i = 0; i < 6; ++i) {
      problem.normal_B[i] = Vector3(draw(1.5), draw(1.5), 1.0).normalized();
      problem.load[i] = std::max(0.0, draw(1.0));
    }
    const LegArray<Vector3> force = contact_forces(problem, params).force;
    for (LegId i = 0; i < 6; ++i) {
      const double along = problem.normal_B[i].dot(force[i]);
      const double across = (force[i] - along * problem.normal_B[i]).norm();
      ASSERT_LE(across, params.friction * along + 1e-5) << trial;
      ASSERT_GE(along, problem.load[i] * params.min_normal - 1e-5) << trial;
      ASSERT_LE(along, problem.load[i] * params.max_normal + 1e-5) << trial;
    }
  }
}

// A wrench that pushes within half of the cones sideways: friction 0.6 suffices for 0.3 of the
// weight, 0.6/√2 = 0.42 is the most along a tangent.
TEST(ContactForces, PushSidewaysUpToTheEdgeOfThePyramid) {
  ContactForceProblem problem = standing();
  problem.wrench.moment = Vector3(0, 0, -0.3).cross(Vector3(0.3 * kWeight, 0, 0));
  problem.wrench.force.x() = 0.3 * kWeight;
  EXPECT_NEAR(wrench_of(problem, contact_forces(problem, {}).force).force.x(), 0.3 * kWeight, 0.01);

  problem.wrench.force.x() = 3.0 * kWeight;
  const Vector3 most = wrench_of(problem, contact_forces(problem, {}).force).force;
  EXPECT_NEAR(most.x(), 0.6 / std::numbers::sqrt2 * most.z(), 0.01);
}

// The load of two legs in steps of ε: the largest change of a force halves with ε.
TEST(ContactForces, ChangeWithoutAJumpAsLegsAreUnloaded) {
  for (const int steps : {50, 500, 2000}) {
    ContactForceProblem problem = standing();
    problem.wrench.force.x() = 80.0;
    LegArray<Vector3> before = contact_forces(problem, {}).force;
    double largest = 0.0;
    for (int k = steps - 1; k >= 0; --k) {
      problem.load[0] = problem.load[3] = static_cast<double>(k) / steps;
      const LegArray<Vector3> force = contact_forces(problem, {}).force;
      for (LegId i = 0; i < 6; ++i) largest = std::max(largest, (force[i] - before[i]).norm());
      before = force;
    }
    EXPECT_LT(largest, 2.0 * kWeight / steps);
    EXPECT_EQ(before[0].norm() + before[3].norm(), 0.0);
  }
}

// Nothing carries: no force.
TEST(ContactForces, AreZeroIfNoLegCarries) {
  ContactForceProblem problem = standing();
  problem.load = LegArray<double>(6, 0.0);
  for (const Vector3& F : contact_forces(problem, {}).force) EXPECT_EQ(F.norm(), 0.0);
}

// Turned with the body, and for twelve legs, the most there can be.
TEST(ContactForces, CarryTheWeightOnTwelveFeet) {
  ContactForceProblem problem{{{0.0, 0.0, kWeight}, Vector3::Zero()},
                              LegArray<Vector3>(12),
                              LegArray<Vector3>(12, Vector3::UnitZ()),
                              LegArray<double>(12, 1.0)};
  for (LegId i = 0; i < 12; ++i)
    problem.p_BF[i] = {0.6 * std::cos(i * 0.5236), 0.6 * std::sin(i * 0.5236), -0.3};
  const LegArray<Vector3> force = contact_forces(problem, {}).force;
  EXPECT_LT(mismatch(wrench_of(problem, force), problem.wrench), 0.01);
  for (const Vector3& F : force) EXPECT_NEAR(F.z(), kWeight / 12, 0.01);
}

// Six feet have 18 force components and the wrench has 6: without regularisation the Hessian is
// singular.
TEST(ContactForces, SayWhetherTheirProgramWasSolved) {
  ContactForceProblem problem = standing();
  EXPECT_EQ(contact_forces(problem, {}).status, QpStatus::solved);
  const ContactForces unsolved = contact_forces(problem, {.regularisation = 0.0});
  EXPECT_EQ(unsolved.status, QpStatus::not_convex);
  for (const Vector3& F : unsolved.force) EXPECT_EQ(F.norm(), 0.0);
}

}  // namespace
}  // namespace hexagait::contact_forces_test
