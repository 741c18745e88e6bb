// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/balance/stance_pose.hpp>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>
#include <limits>
#include <testing/argos.hpp>
#include <testing/stance_oracle.hpp>

namespace hexagait {
namespace {

using testing::argos;
using testing::pose;
using testing::StanceOracle;

constexpr double kHeight = 0.3;

/// All feet in their nominal places under a base, all legs taking part.
StanceProblem nominal_feet(const RobotModel& model, const Pose& X_OB) {
  const int n = model.num_legs();
  StanceProblem problem{LegArray<Vector3>(n), LegSet::all(n), LegSet::all(n), kHeight, 0.04, {}};
  for (LegId i = 0; i < n; ++i) {
    const Vector3& p_BC = model.legs[i].p_BC;
    problem.p_OF[i] = X_OB * Vector3(p_BC.x(), p_BC.y(), -kHeight);
  }
  return problem;
}

/// Feet about their places under a base that leans, up to `scatter` away, on uneven ground.
StanceProblem random_problem(RandomSequence& random, double scatter) {
  const auto draw = [&](double width) { return random.uniform(-width, width); };
  StanceProblem problem =
      nominal_feet(argos(), pose(draw(3), draw(3), draw(1), draw(0.15), draw(0.15), draw(3.1)));
  for (Vector3& p : problem.p_OF) p += Vector3(draw(scatter), draw(scatter), draw(0.5 * scatter));
  problem.height = random.uniform(0.22, 0.38);
  return problem;
}

Vector2 centre_of_mass(const Pose& X_OB) { return (X_OB * argos().p_BM).head<2>(); }

double distance(const Pose& X, const Pose& Y) { return (X.R - Y.R).norm() + (X.p - Y.p).norm(); }

// ---- Closed forms.

// Feet in their nominal places under any base within the tilt: that base, whatever the present one.
TEST(StancePose, IsTheBaseUnderWhichTheFeetAreNominal) {
  RandomSequence random{.seed = 1};
  for (int trial = 0; trial < 500; ++trial) {
    const auto draw = [&](double width) { return random.uniform(-width, width); };
    const Pose X_OB = pose(draw(5), draw(5), draw(2), draw(0.3), draw(0.3), draw(3.1));
    const StancePose stance = optimise_stance(argos(), nominal_feet(argos(), X_OB));
    ASSERT_LT(distance(stance.X_OB, X_OB), 1e-8) << trial;
    ASSERT_LT(stance.objective, 1e-15);
    ASSERT_TRUE(stance.reachable());
    ASSERT_FALSE(stance.margin_shrunk);
    ASSERT_LE(stance.iterations, 6);
  }
}

// Feet farther out or in, all alike: it stays in the middle; all 5 cm higher: so does the base.
TEST(StancePose, IsLevelAndInTheMiddleAtTheHeightAskedForOnLevelFeet) {
  for (const double stretch : {0.9, 1.0, 1.08}) {
    StanceProblem problem = nominal_feet(argos(), {});
    for (Vector3& p : problem.p_OF) p = {stretch * p.x(), stretch * p.y(), 0.05};
    problem.height = 0.28;
    const StancePose stance = optimise_stance(argos(), problem);
    EXPECT_LT(distance(stance.X_OB, {Matrix3::Identity(), {0.0, 0.0, 0.33}}), 1e-8);
    EXPECT_NEAR(stance.margin, 0.490191 * stretch, 1e-6);
  }
}

// A front pair raised by h: feet heights h, 0, 0 over x = a, 0, −a regress to a slope of h / 2a.
TEST(StancePose, TiltsTowardsARaisedPairThatTakesPart) {
  StanceProblem problem = nominal_feet(argos(), {});
  problem.p_OF[0].z() += 0.02;
  problem.p_OF[1].z() += 0.02;
  const StancePose stance = optimise_stance(argos(), problem);
  const double slope = 0.02 / (2 * 0.490191);
  EXPECT_NEAR(roll_pitch_yaw(stance.X_OB.R).y(), -slope, 0.01 * slope);

  problem.reach.erase(0);
  problem.reach.erase(1);
  EXPECT_NEAR(roll_pitch_yaw(optimise_stance(argos(), problem).X_OB.R).norm(), 0.0, 1e-8);
}

// Without the rear legs the centre of mass is on the edge, and the margin takes the base 5 cm
// forward of all feet's best place: over level feet it stays level at its height all the same. To
// lean by θ costs w Σ x² θ² and gains 2 · 6 · 0.05 h θ: θ = 0.6 · 0.28/(2 · 25 · 4 · 0.49²) = 3.5
// mrad.
TEST(StancePose, StaysLevelAtItsHeightWhenTheMarginKeepsItAside) {
  StanceProblem problem = nominal_feet(argos(), {});
  problem.support = LegSet(0b001111);
  problem.margin = 0.05;
  problem.height = 0.28;
  const StancePose stance = optimise_stance(argos(), problem);
  const double mean_z = problem.p_OF[0].z();
  ASSERT_GT((stance.X_OB.p - problem.X_OB.p).head<2>().norm(), 0.01);
  EXPECT_LT(roll_pitch_yaw(stance.X_OB.R).head<2>().norm(), 0.005);
  EXPECT_NEAR(stance.X_OB.p.z() - mean_z, 0.28, 0.001);
}

// ---- Invariance.

TEST(StancePose, GoesWithTheWorldWhenThatIsMovedAboutTheVertical) {
  RandomSequence random{.seed = 2};
  for (int trial = 0; trial < 300; ++trial) {
    StanceProblem problem = random_problem(random, 0.1);
    const Pose X = pose(random.uniform(-9, 9), 1.0, -2.0, 0.0, 0.0, random.uniform(-3.1, 3.1));
    const StancePose before = optimise_stance(argos(), problem);
    for (Vector3& p : problem.p_OF) p = X * p;
    problem.X_OB = X * problem.X_OB;
    const StancePose after = optimise_stance(argos(), problem);
    ASSERT_LT(distance(after.X_OB, X * before.X_OB), 1e-6) << trial;
    ASSERT_NEAR(after.objective, before.objective, 1e-8);
  }
}

// Mirrored left and right, legs exchanged in pairs.
TEST(StancePose, IsMirroredWithItsFeet) {
  const Vector3 mirror(1.0, -1.0, 1.0);
  RandomSequence random{.seed = 3};
  for (int trial = 0; trial < 300; ++trial) {
    StanceProblem problem = random_problem(random, 0.1);
    const LegId away = trial % 6;
    problem.support.erase(away);
    const Pose before = optimise_stance(argos(), problem).X_OB;
    for (LegId i = 0; i < 6; i += 2) std::swap(problem.p_OF[i], problem.p_OF[i + 1]);
    for (Vector3& p : problem.p_OF) p = mirror.cwiseProduct(p);
    problem.support = LegSet::all(6);
    problem.support.erase(away ^ 1);
    const Pose after = optimise_stance(argos(), problem).X_OB;
    ASSERT_LT((after.p - mirror.cwiseProduct(before.p)).norm(), 1e-6) << trial;
    ASSERT_LT((after.R - mirror.asDiagonal() * before.R * mirror.asDiagonal()).norm(), 1e-6);
  }
}

// ---- Optimality.

// Where a solution can be had, no worse than the oracle's and as good as it, from two starts.
TEST(StancePose, IsTheMinimumThatSequentialLeastSquaresFinds) {
  RandomSequence random{.seed = 4};
  int held = 0;
  for (int trial = 0; trial < 90; ++trial) {
    StanceProblem problem = random_problem(random, trial % 3 == 0 ? 0.05 : 0.18);
    problem.margin = random.uniform(0.0, 0.12);
    for (int k = 0; k < trial % 4; ++k) problem.support.erase((trial + 5 * k) % 6);
    if (trial % 5 == 0) problem.reach.erase(trial % 6);
    const StancePose stance = optimise_stance(argos(), problem);
    if (!stance.reachable()) continue;
    ++held;
    const StanceOracle oracle{argos(), problem, std::min(problem.margin, stance.margin)};
    double best = std::numeric_limits<double>::infinity();
    const Pose level = pose(stance.X_OB.p.x(), stance.X_OB.p.y(), stance.X_OB.p.z(), 0.0, 0.0,
                            roll_pitch_yaw(stance.X_OB.R).z());
    for (const Pose& start : {stance.X_OB, level}) {
      const StanceOracle::Minimum found = oracle.minimum(start);
      if (found.violation < 1e-6) best = std::min(best, found.objective);
    }
    ASSERT_NEAR(stance.objective, best, 1e-6 + 1e-4 * best) << trial;
  }
  EXPECT_GT(held, 60);
}

// Hip and yaw with 0.15 rad either way of the nominal stance: now these are what holds the base.
// Where limits of several legs meet, sequential least squares may stop short of the minimum: no
// worse than it, and within the limits themselves: the clearance is there to be used up on the way.
TEST(StancePose, IsTheMinimumWithinNarrowJointLimits) {
  RobotModel model = argos();
  for (LegModel& leg : model.legs) {
    const LegJoints q = inverse_kinematics(leg, leg.p_BC).q;
    for (const int joint : {0, 1}) {
      leg.limits[joint].lower = q[joint] - 0.15;
      leg.limits[joint].upper = q[joint] + 0.15;
    }
  }
  RandomSequence random{.seed = 7};
  int held = 0;
  for (int trial = 0; trial < 60; ++trial) {
    StanceProblem problem = random_problem(random, 0.09);
    problem.height = random.uniform(0.27, 0.33);
    problem.margin = 0.0;
    const StancePose stance = optimise_stance(model, problem);
    if (!stance.reachable()) continue;
    ++held;
    const StanceOracle oracle{model, problem, 0.0};
    const StanceOracle::Minimum found = oracle.minimum(stance.X_OB);
    ASSERT_LT(found.violation, 1e-6) << trial;
    ASSERT_LT(stance.objective, found.objective + 1e-6 + 1e-4 * found.objective) << trial;
    ASSERT_LT(oracle.violation(stance.X_OB), kJointClearance) << trial;
  }
  EXPECT_GT(held, 30);
}

// Feet nominal under a base that leans by 0.75 rad: it leans by 0.6, and as well as it can.
TEST(StancePose, LeansNoFartherThanItMay) {
  RandomSequence random{.seed = 8};
  for (int trial = 0; trial < 20; ++trial) {
    const double direction = random.uniform(-3.1, 3.1);
    const Vector3 lean(0.75 * std::cos(direction), 0.75 * std::sin(direction), 0.0);
    StanceProblem problem = nominal_feet(argos(), {rotation(lean), Vector3::Zero()});
    problem.margin = 0.0;
    const StancePose stance = optimise_stance(argos(), problem);
    EXPECT_NEAR(std::acos(stance.X_OB.R(2, 2)), kMaxTilt, 1e-6);
    const StanceOracle::Minimum found = StanceOracle{argos(), problem, 0.0}.minimum(stance.X_OB);
    ASSERT_NEAR(stance.objective, found.objective, 1e-6 + 1e-4 * found.objective) << trial;
  }
}

// ---- Constraints.

/// What must hold of any answer.
void expect_stable(const StanceProblem& problem, const StancePose& stance) {
  const SupportPolygon polygon = support_polygon(problem.p_OF, problem.support);
  ASSERT_NEAR(stability_margin(polygon, centre_of_mass(stance.X_OB)), stance.margin, 1e-7);
  if (!stance.margin_shrunk) {
    ASSERT_GE(stance.margin, problem.margin - 1e-7);
  }
  ASSERT_GE(stance.margin, polygon.size >= 3 ? 0.0 : -1e-7);
  ASSERT_GE(stance.X_OB.R(2, 2), std::cos(kMaxTilt) - 1e-9);
  ASSERT_LT((stance.X_OB.R.transpose() * stance.X_OB.R - Matrix3::Identity()).norm(), 1e-12);
  for (LegId i = 0; i < 6; ++i) {
    const Vector3 p_BF = stance.X_OB.inverse() * problem.p_OF[i];
    const bool out = !inverse_kinematics(argos().legs[i], p_BF).reachable;
    ASSERT_EQ(stance.out_of_reach.contains(i), out && problem.reach.contains(i));
  }
}

// Any sets, feet anywhere within a leg's length of their places, and beyond.
TEST(StancePose, IsStableAndUprightWhateverTheFeetAre) {
  RandomSequence random{.seed = 5};
  for (int trial = 0; trial < 800; ++trial) {
    StanceProblem problem = random_problem(random, trial % 2 ? 0.2 : 0.6);
    problem.reach = LegSet(static_cast<std::uint32_t>(64 * random.u01()));
    problem.support = LegSet(static_cast<std::uint32_t>(64 * random.u01()));
    if (problem.support.empty()) problem.support.insert(2);
    expect_stable(problem, optimise_stance(argos(), problem));
    ASSERT_FALSE(HasFatalFailure()) << trial;
  }
}

// Three feet in a row on each side, as every hexapod stands, one or two of them lifted.
TEST(StancePose, KeepsItsMarginOverTwoRowsOfFeet) {
  for (LegId lifted = 0; lifted < 6; ++lifted) {
    StanceProblem problem = nominal_feet(argos(), {});
    for (Vector3& p : problem.p_OF) p.y() = p.y() > 0.0 ? 0.5 : -0.5;
    problem.support.erase(lifted);
    problem.margin = 0.3;
    const StancePose stance = optimise_stance(argos(), problem);
    expect_stable(problem, stance);
    EXPECT_FALSE(stance.margin_shrunk);
  }
}

// A triangle (0, 0), (0.6, 0), (0, 0.8) has a circle of radius (0.6 + 0.8 − 1) / 2 = 0.2 about
// (0.2, 0.2).
TEST(StancePose, ShrinksAMarginThatThePolygonHasNoRoomFor) {
  StanceProblem problem = nominal_feet(argos(), {});
  problem.support = LegSet(0b10101);
  problem.p_OF[0] = {0.0, 0.0, -kHeight};
  problem.p_OF[2] = {0.6, 0.0, -kHeight};
  problem.p_OF[4] = {0.0, 0.8, -kHeight};
  problem.reach = LegSet(0b101010);
  problem.margin = 0.5;
  const StancePose stance = optimise_stance(argos(), problem);
  EXPECT_TRUE(stance.margin_shrunk);
  EXPECT_NEAR(stance.margin, 0.2, 2e-6);
  EXPECT_LT((centre_of_mass(stance.X_OB) - Vector2(0.2, 0.2)).norm(), 1e-5);
}

TEST(StancePose, GoesOverTheSegmentOrThePointThatSupportsAndAnywhereOverNone) {
  StanceProblem problem = nominal_feet(argos(), {});
  const auto centre = [&](std::uint32_t support) {
    problem.support = LegSet(support);
    const StancePose stance = optimise_stance(argos(), problem);
    EXPECT_TRUE(stance.margin_shrunk);
    return centre_of_mass(stance.X_OB);
  };
  EXPECT_LT((centre(0b000001) - problem.p_OF[0].head<2>()).norm(), 1e-7);
  const Vector2 middle = 0.5 * (problem.p_OF[0] + problem.p_OF[2]).head<2>();
  const Vector2 a = problem.p_OF[0].head<2>(), b = problem.p_OF[2].head<2>();
  EXPECT_NEAR(cross((b - a).normalized(), centre(0b000101) - middle), 0.0, 1e-7);
  EXPECT_LT(centre(0).norm(), 1e-7);
}

// Nothing to reach: the base keeps its pose, and only its centre of mass moves, no farther than
// it must.
TEST(StancePose, StaysWhereItIsIfNoFootTakesPart) {
  StanceProblem problem = nominal_feet(argos(), {});
  problem.reach = {};
  problem.X_OB = pose(0.1, 0.05, 0.2, 0.1, -0.2, 1.0);
  EXPECT_LT(distance(optimise_stance(argos(), problem).X_OB, problem.X_OB), 1e-7);

  problem.X_OB = pose(2.0, 0.0, 0.2, 0.0, 0.0, 0.0);
  const StancePose moved = optimise_stance(argos(), problem);
  EXPECT_LT(distance(moved.X_OB, pose(0.490191 - 0.04, 0.0, 0.2, 0.0, 0.0, 0.0)), 1e-6);
}

// One foot three metres away: it is given up, by name, and the others are reached.
TEST(StancePose, GivesUpAFootThatIsTooFarAndKeepsTheOthers) {
  for (LegId far = 0; far < 6; ++far) {
    StanceProblem problem = nominal_feet(argos(), {});
    problem.p_OF[far] *= 4.0;
    const StancePose stance = optimise_stance(argos(), problem);
    LegSet only;
    only.insert(far);
    EXPECT_EQ(stance.out_of_reach, only) << far;
    expect_stable(problem, stance);
  }
}

TEST(StancePose, IsFiniteForAnyFiniteFeet) {
  RandomSequence random{.seed = 6};
  for (int trial = 0; trial < 300; ++trial) {
    StanceProblem problem = nominal_feet(argos(), {});
    for (Vector3& p : problem.p_OF)
      for (double& x : p) x = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-9, 300));
    problem.reach = LegSet(static_cast<std::uint32_t>(64 * random.u01()));
    problem.support = LegSet(static_cast<std::uint32_t>(64 * random.u01()));
    const StancePose stance = optimise_stance(argos(), problem);
    ASSERT_TRUE(stance.X_OB.p.allFinite() && stance.X_OB.R.allFinite()) << trial;
    ASSERT_FALSE(std::isnan(stance.margin) || std::isnan(stance.objective)) << trial;
  }
}

}  // namespace
}  // namespace hexagait
