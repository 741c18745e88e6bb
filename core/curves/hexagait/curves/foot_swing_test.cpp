// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/curves/foot_curve.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/random_vector.hpp>
#include <vector>

namespace hexagait::foot_swing_test {
namespace {

using testing::random_vector;

constexpr SwingProfile kProfiles[] = {SwingProfile::straight, SwingProfile::triangle,
                                      SwingProfile::square, SwingProfile::trapezoid};
constexpr double kLiftOff = 0.1;  // [m/s]
constexpr double kMilli = 1e-3;   // what a swing may leave its box by [m]

/// A random swing, and its polygon as (along the chord, along the normal), worked out once more.
struct Case {
  PointState start;
  FootSwing swing;
  double duration = 0.0;
  Vector3 u, n;  // unit vectors
  std::vector<Vector2> knots;
  FootCurve curve;

  Vector2 plane(const Vector3& v) const { return {v.dot(u), v.dot(n)}; }
  Vector2 place(double t) const { return plane(curve.at(t).p - start.p); }
};

std::vector<Vector2> polygon(SwingProfile profile, double c, double z, double h) {
  const double top = std::max(z, 0.0) + h;
  if (profile == SwingProfile::straight) return {{0, 0}, {c, z}};
  if (profile == SwingProfile::triangle) return {{0, 0}, {c / 2, top}, {c, z}};
  if (profile == SwingProfile::square) return {{0, 0}, {0, top}, {c, top}, {c, z}};
  return {{0, 0}, {0.1 * c, h}, {0.5 * c, z + h}, {0.9 * c, z + h}, {c, z}};
}

// Chords 0 … 0.6 m, heights 0 … 0.3 m, some of them 0 or a hair; tilted by up to 40°; target up to
// 0.3 m above or below.
Case random_case(RandomSequence& random, int k) {
  Case c;
  const Matrix3 R =
      rotation(rotation_z(random.uniform(-3.1, 3.1)) * Vector3(random.uniform(0.0, 0.698), 0, 0)) *
      rotation_z(random.uniform(-3.1, 3.1));
  c.u = R.col(0), c.n = R.col(2);
  const double small[] = {0.0, 1e-12, 1e-4, 1.1e-3, 0.01};
  const auto some = [&](double largest) {
    const double x = random.u01();
    return x < 0.3 ? small[static_cast<int>(x * 5 / 0.3)] : random.uniform(0.0, largest);
  };
  const double chord = some(0.6), h = some(0.3), z = some(0.3) * (random.u01() < 0.5 ? -1 : 1);
  c.start.p = random_vector(random, 3.0);
  if (random.u01() < 0.5) c.start.v = kLiftOff * c.n;
  c.swing.target = c.start.p + chord * c.u + z * c.n;
  c.swing.profile = kProfiles[k % 4];
  c.swing.profile_height = h;
  c.swing.normal = c.n;
  c.knots = polygon(c.swing.profile, chord, z, h);
  c.duration = swing_duration(c.start.p, c.swing, 0.65, 0.45);
  c.curve.plan_swing(c.start, c.swing, c.duration);
  return c;
}

template <class Check>
void for_random_swings(std::uint64_t seed, int count, Check check) {
  RandomSequence random{.seed = seed};
  for (int k = 0; k < count; ++k) {
    SCOPED_TRACE(k);
    check(random_case(random, k));
    if (::testing::Test::HasFatalFailure()) return;
  }
}

// A triangle 0.4 m wide and 0.15 m high: two sides of √(0.2² + 0.15²) = 0.25 m; a square, 0.4 + 2 ·
// 0.15; 0.3 m/s.
TEST(FootSwing, LastsForThePolygonsLengthOverTheVelocityButNotBelowTheMinimum) {
  FootSwing swing{.target = {1.4, 0.0, 0.0}, .profile_height = 0.15};
  EXPECT_NEAR(swing_duration({1, 0, 0}, swing, 0.3, 0.45), 0.5 / 0.3, 1e-15);
  EXPECT_EQ(swing_duration({1, 0, 0}, swing, 3.0, 0.45), 0.45);
  swing.profile = SwingProfile::square;
  EXPECT_NEAR(swing_duration({1, 0, 0}, swing, 0.3, 0.45), 0.7 / 0.3, 1e-15);
}

// Symmetric: the sideways motion is one minimum-jerk motion, the apex is in the middle of time and
// way; 1.875 · 0.4 / 0.8 there.
TEST(FootSwing, OverATriangleIsMinimumJerkSideways) {
  FootCurve curve;
  const FootSwing swing{.target = {0.4, 0.0, 0.0}, .touchdown_speed = 0.0};
  curve.plan_swing({}, swing, 0.8);
  for (double x = 0.0; x <= 1.0; x += 0.05)
    EXPECT_NEAR(curve.at(0.8 * x).p.x(), 0.4 * x * x * x * (10 + x * (-15 + 6 * x)), 1e-15);
  EXPECT_NEAR(curve.at(0.4).p.z(), 0.08, 1e-15);
  EXPECT_NEAR(curve.at(0.4).v.x(), 1.875 * 0.5, 1e-14);
  EXPECT_NEAR(curve.at(0.4).v.z(), 0.0, 1e-15);
}

TEST(FootSwing, BeginsInItsStartStateAndArrivesWithTheTouchdownVelocity) {
  for_random_swings(1, 4000, [](const Case& c) {
    const PointState begin = c.curve.at(0.0), end = c.curve.at(c.duration);
    ASSERT_EQ(c.curve.duration(), c.duration);
    ASSERT_EQ(begin.p, c.start.p);
    ASSERT_EQ(begin.v, c.start.v);
    ASSERT_EQ(end.p, c.swing.target);
    ASSERT_LT((end.v + 0.2 * c.n).norm(), 1e-15);
    ASSERT_EQ(end.a.norm(), 0.0);
    ASSERT_EQ(c.curve.at(c.duration + 1.0).p, end.p) << "clamped";
    ASSERT_EQ(c.curve.at(-1.0).v, begin.v) << "clamped";
  });
}

TEST(FootSwing, StaysInItsKnotsBoxAndNeverRunsBackwards) {
  for_random_swings(2, 4000, [](const Case& c) {
    Vector2 low = c.knots[0], high = c.knots[0];
    for (const Vector2& knot : c.knots) low = low.cwiseMin(knot), high = high.cwiseMax(knot);
    for (int i = 0; i <= 200; ++i) {
      const PointState state = c.curve.at(c.duration * i / 200);
      const Vector2 at = c.plane(state.p - c.start.p);
      ASSERT_GE((at - low).minCoeff(), -kMilli) << i;
      ASSERT_GE((high - at).minCoeff(), -kMilli) << i;
      ASSERT_GE(state.v.dot(c.u), -1e-9) << i;
      ASSERT_NEAR((state.p - c.start.p).dot(c.n.cross(c.u)), 0.0, 1e-12) << "off its plane";
    }
  });
}

// Nearest of 2000 samples; between two of them the foot moves by up to 2 v_peak T/2000, to which
// the distance from a knot is half: 2.4 m · 1.875² / 4000 at most, but at knots it is slow.
TEST(FootSwing, PassesItsKnotsWithinAMillimetre) {
  for_random_swings(3, 400, [](const Case& c) {
    for (const Vector2& knot : c.knots) {
      double nearest = 1.0;
      for (int i = 0; i <= 2000; ++i)
        nearest = std::min(nearest, (c.place(c.duration * i / 2000) - knot).norm());
      ASSERT_LT(nearest, kMilli) << knot.transpose();
    }
  });
}

// The derivatives at hand are those of the position: differences over 2e-6 T of a polynomial that
// varies over its pieces. And across every time, also nodes: over ε the state changes by no more
// than its derivative's bound allows. The jerk is bounded by 60 way/T³ of the shortest piece:
// within 9 ms 0.2 m/s goes, 6 v/τ² = 15000 m/s³, or a lift-off of 0.1 m/s in 18 ms.
TEST(FootSwing, IsContinuousUpToItsAcceleration) {
  for_random_swings(4, 2000, [](const Case& c) {
    const double e = 1e-6;
    for (int i = 1; i < 100; ++i) {
      const double t = c.duration * i / 100;
      const PointState left = c.curve.at(t - e), now = c.curve.at(t), right = c.curve.at(t + e);
      ASSERT_LT((right.p - left.p - 2 * e * now.v).norm(), 1e-12 + 1e-9);
      ASSERT_LT((right.v - left.v - 2 * e * now.a).norm(), 2e-7);
      ASSERT_LT((right.a - left.a).norm(), 2 * e * 1e5);
    }
  });
}

// A scan from end to end: a jump of velocity or acceleration anywhere would be found by its step.
// Halving the sampling halves the largest step of something continuous, but not that of a jump.
TEST(FootSwing, HasNoJumpAnywhere) {
  for_random_swings(5, 60, [](const Case& c) {
    double largest[2] = {0.0, 0.0};
    for (const int fine : {0, 1}) {
      const int n = fine == 1 ? 32000 : 16000;
      Vector3 last = c.curve.at(0.0).a;
      for (int i = 1; i <= n; ++i) {
        const Vector3 a = c.curve.at(c.duration * i / n).a;
        largest[fine] = std::max(largest[fine], (a - last).norm());
        last = a;
      }
    }
    ASSERT_LT(largest[1], 0.6 * largest[0] + 1e-9);
  });
}

// Replaced in mid-air, in whatever state: begins there, ends as it should, is finite and bounded,
// and continuous, for the same reasons. 0.3 m around everything: 1.5 m/s are braked at 15 m/s²
// within v τ/2, τ = 1.5 v / 15: 0.11 m; 40 m/s² add 40 τ²/12 = 0.075 m.
TEST(FootSwing, CanBeReplacedInMidAir) {
  RandomSequence random{.seed = 6};
  for (int k = 0; k < 4000; ++k) {
    Case c = random_case(random, k);
    c.start.v = random_vector(random, 0.85);
    c.start.a = random_vector(random, 23.0);
    c.curve.plan_swing(c.start, c.swing, c.duration);
    ASSERT_EQ(c.curve.at(0.0).a, c.start.a);
    ASSERT_EQ(c.curve.at(c.duration).p, c.swing.target);
    const double e = 1e-6;
    for (int i = 1; i < 100; ++i) {
      const double t = c.duration * i / 100;
      const PointState left = c.curve.at(t - e), right = c.curve.at(t + e);
      ASSERT_LT((right.p - left.p - 2 * e * c.curve.at(t).v).norm(), 1e-9);
      ASSERT_LT((right.a - left.a).norm(), 2 * e * 1e5);
      const Vector2 at = c.place(t);
      ASSERT_LT(at.norm(), 0.3 + c.swing.profile_height + c.knots.back().norm());
    }
  }
}

// Minimum jerk between stops of way d in time T accelerates by 5.7735 d/T²; with T in proportion to
// √d it is the same for all of a square's sides, (Σ √d)² / T² times that. 0.01, 0.3, 0.01 m in 0.5
// s: 32.5 m/s² · 0.56; in proportion to d they would be 242 m/s².
TEST(FootSwing, AcceleratesEquallyOnShortAndLongSides) {
  FootCurve curve;
  const FootSwing swing{.target = {0.3, 0, 0},
                        .profile = SwingProfile::square,
                        .profile_height = 0.01,
                        .touchdown_speed = 0.0};
  curve.plan_swing({}, swing, 0.5);
  Vector3 largest = Vector3::Zero();
  for (int i = 0; i <= 5000; ++i) largest = largest.cwiseMax(curve.at(0.5 * i / 5000).a.cwiseAbs());
  const double expected = 5.7735 * std::pow(2 * std::sqrt(0.01) + std::sqrt(0.3), 2) / 0.25;
  EXPECT_NEAR(largest.x(), expected, 1e-3 * expected);
  EXPECT_NEAR(largest.z(), expected, 1e-3 * expected);
}

// The same swing, turned and shifted.
TEST(FootSwing, IsTheSameInEveryFrame) {
  const Pose X{rotation({0.3, -0.8, 1.9}), {5.0, -3.0, 1.0}};
  for_random_swings(7, 200, [&](const Case& c) {
    FootCurve moved;
    FootSwing swing = c.swing;
    swing.target = X * swing.target;
    swing.normal = 3.0 * (X.R * swing.normal);
    moved.plan_swing({X * c.start.p, X.R * c.start.v, c.start.a}, swing, c.duration);
    if ((c.knots.back() - c.knots.front()).x() < 1e-6) return;  // no chord, no direction
    for (double t = 0.0; t < c.duration; t += 0.05)
      ASSERT_LT((moved.at(t).p - X * c.curve.at(t).p).norm(), 1e-9);
  });
}

TEST(FootSwing, IsFiniteWhateverItIsGiven) {
  FootCurve curve;
  const auto check = [&] {
    for (int i = 0; i <= 20; ++i) {
      const PointState s = curve.at(curve.duration() * i / 20);
      ASSERT_TRUE(s.p.allFinite() && s.v.allFinite() && s.a.allFinite());
    }
  };
  for (const SwingProfile profile : kProfiles) {
    curve.plan_swing({}, {.profile = profile, .profile_height = 0.0}, 0.45);
    check();
    curve.plan_swing({}, {.profile = profile, .profile_height = -1.0, .normal = {0, 0, 0}}, 0.0);
    check();
    curve.plan_swing({{}, {1, 1, 1}, {9, 9, 9}}, {.target = {0, 0, 1e-9}, .profile = profile},
                     -1.0);
    check();
  }
}

}  // namespace
}  // namespace hexagait::foot_swing_test
