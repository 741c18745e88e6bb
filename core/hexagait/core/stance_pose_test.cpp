// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nlopt.h>

#include <algorithm>
#include <functional>
#include <hexagait/core/kinematics.hpp>
#include <hexagait/core/random.hpp>
#include <hexagait/core/stance_pose.hpp>
#include <hexagait/core/support_polygon.hpp>
#include <limits>
#include <vector>

namespace hexagait {
namespace {

constexpr double kHeight = 0.3;

const RobotModel& argos() {
  static const RobotModel model = load_urdf(HEXAGAIT_SOURCE_DIR "/robots/argos.urdf");
  return model;
}

Pose pose(double x, double y, double z, double roll, double pitch, double yaw) {
  return {rotation_z(yaw) * rotation({0.0, pitch, 0.0}) * rotation({roll, 0.0, 0.0}), {x, y, z}};
}

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

// ---- The oracle: (stance 1) and its constraints written down again, over x, y, z and roll, pitch,
// yaw, by numerical derivatives and sequential least squares.

struct Oracle {
  const RobotModel& model;
  const StanceProblem& problem;
  double margin;

  static Pose pose_of(const double* x) { return pose(x[0], x[1], x[2], x[3], x[4], x[5]); }

  double objective(const double* x) const {
    const Pose X_BO = pose_of(x).inverse();
    double sum = 0.0;
    for (LegId i = 0; i < model.num_legs(); ++i) {
      const Vector3& c = model.legs[i].p_BC;
      if (!problem.reach.contains(i)) continue;
      const Vector3 p_BF = X_BO * problem.p_OF[i];
      sum += std::pow(p_BF.x() - c.x(), 2) + std::pow(p_BF.y() - c.y(), 2) +
             kHeightWeight * std::pow(p_BF.z() + problem.height, 2);
    }
    return sum;
  }

  // Every one must be ≤ 0. As many whatever the pose is.
  std::vector<double> constraints(const double* x) const {
    const Pose X_OB = pose_of(x), X_BO = X_OB.inverse();
    std::vector<double> g;
    add_polygon(g, (X_OB * model.p_BM).head<2>());
    for (LegId i = 0; i < model.num_legs(); ++i)
      if (problem.reach.contains(i)) add_leg(g, model.legs[i], X_BO * problem.p_OF[i]);
    g.push_back(std::cos(kMaxTilt) - X_OB.R(2, 2));
    return g;
  }

  // A pair of feet with no foot on its right is an edge.
  void add_polygon(std::vector<double>& g, const Vector2& p) const {
    const auto foot = [&](LegId i) { return Vector2(problem.p_OF[i].head<2>()); };
    for (LegId a = 0; a < 6; ++a) {
      for (LegId b = 0; b < 6; ++b) {
        if (a == b || !problem.support.contains(a) || !problem.support.contains(b)) continue;
        const Vector2 edge = (foot(b) - foot(a)).normalized();
        bool is_edge = true;
        for (LegId c = 0; c < 6; ++c)
          is_edge = is_edge && (c == a || c == b || !problem.support.contains(c) ||
                                cross(edge, foot(c) - foot(a)) >= 0.0);
        if (is_edge) g.push_back(margin - cross(edge, p - foot(a)));
      }
    }
  }

  // Yaw, and the triangle hip, knee, foot: the hip angle from the elevation and the law of cosines.
  static void add_leg(std::vector<double>& g, const LegModel& leg, const Vector3& p_BF) {
    const Vector3 p = leg.X_BH.inverse() * p_BF;
    const double yaw = std::atan2(p.y(), p.x());
    const double a = std::hypot(p.x(), p.y()) - leg.coxa, d = std::hypot(a, p.z());
    const double cosine =
        (leg.femur * leg.femur + d * d - leg.tibia * leg.tibia) / (2.0 * leg.femur * d);
    const double hip = std::atan2(-p.z(), a) - std::acos(std::clamp(cosine, -1.0, 1.0));
    g.insert(
        g.end(),
        {d - leg.max_reach + kReachClearance, leg.min_reach + kReachClearance - d,
         yaw - leg.limits[0].upper + kJointClearance, leg.limits[0].lower + kJointClearance - yaw,
         hip - leg.limits[1].upper + kJointClearance, leg.limits[1].lower + kJointClearance - hip});
  }

  // The minimum near a start: x, and by how much it violates a constraint at most.
  struct Minimum {
    double objective, violation;
  };
  Minimum minimum(const Pose& start) const {
    const Vector3 rpy = roll_pitch_yaw(start.R);
    double x[6] = {start.p.x(), start.p.y(), start.p.z(), rpy.x(), rpy.y(), rpy.z()};
    const auto m = static_cast<unsigned>(constraints(x).size());
    nlopt_opt slsqp = nlopt_create(NLOPT_LD_SLSQP, 6);
    nlopt_set_min_objective(slsqp, nlopt_objective, const_cast<Oracle*>(this));
    const std::vector<double> tolerance(m, 1e-9);
    nlopt_add_inequality_mconstraint(slsqp, m, nlopt_constraints, const_cast<Oracle*>(this),
                                     tolerance.data());
    nlopt_set_xtol_abs1(slsqp, 1e-10);
    nlopt_set_maxeval(slsqp, 200);
    double value = 0.0;
    (void)nlopt_optimize(slsqp, x, &value);
    nlopt_destroy(slsqp);
    const std::vector<double> g = constraints(x);
    return {objective(x), *std::max_element(g.begin(), g.end())};
  }

  // By how much a pose violates a constraint at most.
  double violation(const Pose& X) const {
    const Vector3 rpy = roll_pitch_yaw(X.R);
    const double x[6] = {X.p.x(), X.p.y(), X.p.z(), rpy.x(), rpy.y(), rpy.z()};
    const std::vector<double> g = constraints(x);
    return *std::max_element(g.begin(), g.end());
  }

  static double nlopt_objective(unsigned n, const double* x, double* gradient, void* self) {
    const auto& oracle = *static_cast<const Oracle*>(self);
    for (unsigned k = 0; gradient && k < n; ++k) {
      std::vector<double> up(x, x + n), down(x, x + n);
      up[k] += 1e-6, down[k] -= 1e-6;
      gradient[k] = (oracle.objective(up.data()) - oracle.objective(down.data())) / 2e-6;
    }
    return oracle.objective(x);
  }

  static void nlopt_constraints(unsigned m, double* result, unsigned n, const double* x,
                                double* gradient, void* self) {
    const auto& oracle = *static_cast<const Oracle*>(self);
    std::ranges::copy(oracle.constraints(x), result);
    for (unsigned k = 0; gradient && k < n; ++k) {
      std::vector<double> up(x, x + n), down(x, x + n);
      up[k] += 1e-6, down[k] -= 1e-6;
      const std::vector<double> high = oracle.constraints(up.data());
      const std::vector<double> low = oracle.constraints(down.data());
      for (unsigned i = 0; i < m; ++i) gradient[i * n + k] = (high[i] - low[i]) / 2e-6;
    }
  }
};

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
    const Oracle oracle{argos(), problem, std::min(problem.margin, stance.margin)};
    double best = std::numeric_limits<double>::infinity();
    const Pose level = pose(stance.X_OB.p.x(), stance.X_OB.p.y(), stance.X_OB.p.z(), 0.0, 0.0,
                            roll_pitch_yaw(stance.X_OB.R).z());
    for (const Pose& start : {stance.X_OB, level}) {
      const Oracle::Minimum found = oracle.minimum(start);
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
    const Oracle oracle{model, problem, 0.0};
    const Oracle::Minimum found = oracle.minimum(stance.X_OB);
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
    const Oracle::Minimum found = Oracle{argos(), problem, 0.0}.minimum(stance.X_OB);
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
