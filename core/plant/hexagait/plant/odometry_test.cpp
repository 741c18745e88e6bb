// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/plant/odometry.hpp>
#include <hexagait/plant/testing/point_feet.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/control_period.hpp>
#include <testing/round_params.hpp>

namespace hexagait {
namespace {

using namespace testing;

// On its belly, feet are anywhere and tell nothing: level is what the body says it is.
TEST(OdometryReset, TakesABodyThatLiesForLevelWhereverItsFeetAre) {
  const RobotModel model = point_footed(6);
  RobotState state = standing(six_feet());
  state.p_BF[0].z() += 0.4;
  state.p_BF[3].z() += 0.2;
  Odometry odometry(model, testing::round_params().tolerance);
  odometry.reset(state, RestsOn::belly);
  EXPECT_EQ(state.X_OB.R, Matrix3::Identity());
  EXPECT_EQ(state.X_OB.p, Vector3::Zero());
  EXPECT_EQ(state.print_O[3], state.p_BF[3]);

  // With no foot to rely on it stays there.
  odometry.update(state, LegArray<double>(6, 0.0), kDt);
  EXPECT_LT(distance(state.X_OB, {}), 1e-12);
}

// Up is measured 0.1 rad off: body and footholds turn together about the middle of the feet that stand,
// without yaw, and the next update finds them where they are.
TEST(OdometryLevel, TurnsBodyAndFootholdsAboutTheMiddleOfTheFeet) {
  const RobotModel model = point_footed(6);
  RobotState state = standing(six_feet());
  Odometry odometry(model, testing::round_params().tolerance);
  odometry.reset(state);
  LegArray<double> footing(6, 1.0);
  footing[3] = footing[5] = 0.0;
  odometry.update(state, footing, kDt);
  const RobotState before = state;
  const Vector3 up_B = rotation({0.06, -0.08, 0.0}) * Vector3::UnitZ();
  odometry.level(state, up_B, footing);

  EXPECT_LT((state.X_OB.R * up_B - Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(state.X_OB.R(1, 0), 0.0, 0.01);  // no yaw: |turn|² only
  Vector3 middle = Vector3::Zero(), middle_before = Vector3::Zero();
  for (const LegId i : {0, 1, 2, 4}) {
    middle += state.p_OF[i] / 4.0;
    middle_before += before.p_OF[i] / 4.0;
    EXPECT_LT((state.print_O[i] - state.p_OF[i]).norm(), 1e-12);
  }
  EXPECT_LT((middle - middle_before).norm(), 1e-12);
  EXPECT_GT((state.print_O[0] - before.print_O[0]).norm(), 0.02);

  const Pose level = state.X_OB;
  odometry.update(state, footing, kDt);
  EXPECT_LT(distance(state.X_OB, level), 1e-12);
  EXPECT_LT(state.V_B.v.norm() + state.V_B.w.norm(), 1e-9);
}

// z of odom is the normal of the plane through the feet, its origin ρ below their centres: however
// the body is held, its pose is found but for what feet on a plane cannot tell, x, y and yaw.
TEST(OdometryReset, LevelsTheFrameOnTheFeet) {
  RobotModel model = point_footed(6);
  model.foot_radius = 0.02;
  const Matrix3 R = rotation({0.0, 0.1, 0.0}) * rotation({0.2, 0.0, 0.0});
  RobotState state = standing(six_feet());
  for (Vector3& p : state.p_BF)
    p = R.transpose() * Vector3(p.x(), p.y(), model.foot_radius - kHeight);
  Odometry odometry(model, testing::round_params().tolerance);
  odometry.reset(state);
  EXPECT_LT((state.X_OB.R.row(2) - R.row(2)).norm(), 1e-12);
  EXPECT_NEAR(state.X_OB.R(1, 0), 0.0, 1e-12) << "x ahead";
  EXPECT_GT(state.X_OB.R(0, 0), 0.0);
  EXPECT_NEAR(state.X_OB.R.determinant(), 1.0, 1e-12);
  EXPECT_LT((state.X_OB.p - Vector3(0.0, 0.0, kHeight)).norm(), 1e-12);
  for (const Vector3& p : state.p_OF) EXPECT_NEAR(p.z(), model.foot_radius, 1e-12);
}

// Feet in a row along `axis` tell the slope along it and none across it; feet on one spot none.
TEST(OdometryReset, TakesTheGroundForLevelAcrossFeetInARow) {
  const RobotModel model = point_footed(4);
  for (const double angle : {0.0, 0.6, 1.5707963}) {
    const Vector3 axis(std::cos(angle), std::sin(angle), 0.0);
    const double slope = 0.1;
    LegArray<Vector3> row(4), spot(4, Vector3(0.1, 0.2, -kHeight));
    for (LegId i = 0; i < 4; ++i)
      row[i] = 0.2 * (i - 1.0) * axis + Vector3(0, 0, slope * 0.2 * (i - 1.0) - kHeight);
    Odometry odometry(model, testing::round_params().tolerance);
    RobotState state = standing(row);
    odometry.reset(state);
    ASSERT_TRUE(state.X_OB.R.allFinite() && state.X_OB.p.allFinite()) << angle;
    const Vector3 up_B = (Vector3::UnitZ() - slope * axis).normalized();
    EXPECT_LT((state.X_OB.R.row(2).transpose() - up_B).norm(), 1e-9) << angle;
    for (const Vector3& p : state.p_OF) EXPECT_NEAR(p.z(), 0.0, 1e-9) << angle;

    state = standing(spot);
    odometry.reset(state);
    EXPECT_LT((state.X_OB.R - Matrix3::Identity()).norm(), 1e-12);
    EXPECT_NEAR(state.X_OB.p.z(), kHeight, 1e-12);
  }
}

// Footholds at rest and a constant twist: X_OB = X_0 exp(V t). One Gauss-Newton step a tick is
// exact to first order in its turn for any axis: |w dt|²/2 is left over. It is made good at the
// next tick and doesn't add up: when the body stops, the estimate is exact.
TEST(Odometry, ReproducesAnyTwistOverFixedFootholds) {
  const RobotModel model = point_footed(6);
  RandomSequence random{.seed = 1};
  for (int trial = 0; trial < 20; ++trial) {
    const auto u = [&](double bound) { return random.uniform(-bound, bound); };
    const Twist V{{u(0.5), u(0.5), u(0.1)}, {u(0.2), u(0.2), u(0.5)}};
    RobotState state = standing(six_feet());
    Odometry odometry(model, testing::round_params().tolerance);
    odometry.reset(state);
    const Pose X_0 = state.X_OB;
    const LegArray<Vector3> foothold_O = state.p_OF;
    for (int tick = 1; tick <= 500; ++tick) {
      const Pose X_OB = X_0 * travelled(V, tick * kDt);
      for (LegId i = 0; i < 6; ++i) state.p_BF[i] = X_OB.inverse() * foothold_O[i];
      odometry.update(state, LegArray<double>(6, 1.0), kDt);
      ASSERT_LT(distance(state.X_OB, X_OB), 0.5 * (V.w * kDt).squaredNorm() + 1e-9);
    }
    EXPECT_LT((state.V_B.w - V.w).norm(), 1e-5);
    EXPECT_LT((state.V_B.v - V.v).norm(), 1e-3) << "mean over the tick: differs by |w| |v| dt / 2";
    for (int tick = 0; tick < 2; ++tick) odometry.update(state, LegArray<double>(6, 1.0), kDt);
    EXPECT_LT(distance(state.X_OB, X_0 * travelled(V, 500 * kDt)), 1e-11);
  }
}

// Turning about the vertical, a principal axis of six symmetric feet, it is exact to second order.
// The regularisation, 1e-6 m² beside a moment of inertia of ~2 m², and the third order leave (5e-7
// + |w dt|²/6) |w dt| = 7e-10 rad.
TEST(Odometry, IsExactToANanometreOnTheLevel) {
  const RobotModel model = point_footed(6);
  const Twist V{{0.5, -0.2, 0.0}, {0.0, 0.0, 0.5}};
  RobotState state = standing(six_feet());
  Odometry odometry(model, testing::round_params().tolerance);
  odometry.reset(state);
  const Pose X_0 = state.X_OB;
  for (int tick = 1; tick <= 1000; ++tick) {
    const Pose X_OB = X_0 * travelled(V, tick * kDt);
    for (LegId i = 0; i < 6; ++i) state.p_BF[i] = X_OB.inverse() * (X_0 * six_feet()[i]);
    odometry.update(state, LegArray<double>(6, 1.0), kDt);
    ASSERT_LT(distance(state.X_OB, X_OB), 2e-9);
  }
}

// Ten seconds on six feet whose positions have a noise of 1 mm per axis, as from 2 mrad at the
// joints. Footholds are taken from the first, noisy sample: the pose is off by 1 mm/√6 and by
// 1 mm/√(Σ l²) = 0.6 mrad, three times that at worst; from then on it must not stray. If footholds
// followed feet that only seem to slide, it would by 4 cm.
TEST(Odometry, DoesNotStrayWithTheNoiseOfTheJoints) {
  const RobotModel model = point_footed(6);
  for (const double dt : {0.002, 0.02}) {
    RandomSequence random{.seed = 5};
    const auto noise = [&random] {  // variance of a sum of 12: 12/12
      double sum = -6.0;
      for (int k = 0; k < 12; ++k) sum += random.u01();
      return 1e-3 * sum;
    };
    const auto noisy = [&](RobotState& state) {
      state.p_BF = six_feet();
      for (Vector3& p : state.p_BF) p += Vector3(noise(), noise(), noise());
    };
    RobotState state = standing(six_feet());
    Odometry odometry(model, testing::round_params().tolerance);
    odometry.reset(state);
    const Pose X_0 = state.X_OB;
    Vector3 mean = Vector3::Zero();
    double turn = 0.0;
    const int ticks = 5000, last = 500;
    for (int k = 0; k < ticks; ++k) {
      noisy(state);
      odometry.update(state, LegArray<double>(6, 1.0), dt);
      if (k < ticks - last) continue;
      mean += (state.X_OB.p - X_0.p) / last;
      turn += rotation_vector(X_0.R.transpose() * state.X_OB.R).z() / last;
    }
    EXPECT_LT(mean.norm(), 3.0 * 0.41e-3);
    EXPECT_LT(std::abs(turn), 3.0 * 0.6e-3);
  }
}

// One foot of six slides by 2 cm in half a second. Least squares would share it out: the centroid
// alone moves by 20 mm / 6 = 3.3 mm. Rejected, it is followed at the distance at which it is
// trusted just so little that the anchor keeps up, e⁵/(1 + e⁴) = 0.08 in mm per tick: e = 0.63 mm.
// It pulls the base by e/6 = 0.1 mm and turns it by e l/I = 0.2 mrad (l = 0.64 m, I = 2 m²). Rows
// of feet make it hard: a slide along x keeps the distance to the leg opposite, along y that to
// two.
TEST(Odometry, IsNotDraggedAlongByAFootThatSlides) {
  const RobotModel model = point_footed(6);
  for (LegId slider = 0; slider < 6; ++slider) {
    for (const Vector3& way : {Vector3(0.02, 0.0, 0.0), Vector3(0.0, 0.02, 0.0)}) {
      RobotState state = standing(six_feet());
      Odometry odometry(model, testing::round_params().tolerance);
      odometry.reset(state);
      const Pose X_0 = state.X_OB;
      for (int tick = 1; tick <= 250; ++tick) {
        state.p_BF[slider] = six_feet()[slider] + way * tick / 250.0;
        odometry.update(state, LegArray<double>(6, 1.0), kDt);
        ASSERT_LT(distance(state.X_OB, X_0), 0.5e-3) << "leg " << slider;
      }
      EXPECT_NEAR((state.p_OF[slider] - X_0 * state.p_BF[slider]).norm(), 0.0, 1e-3);
    }
  }
}

// Two of six that slide together keep their own distance, but agree with only one of five.
TEST(Odometry, IsNotDraggedAlongByTwoFeetThatSlideTogether) {
  const RobotModel model = point_footed(6);
  RobotState state = standing(six_feet());
  Odometry odometry(model, testing::round_params().tolerance);
  odometry.reset(state);
  const Pose X_0 = state.X_OB;
  for (int tick = 1; tick <= 250; ++tick) {
    for (const LegId slider : {0, 5})
      state.p_BF[slider] = six_feet()[slider] + Vector3(0.02 * tick / 250.0, 0.0, 0.0);
    odometry.update(state, LegArray<double>(6, 1.0), kDt);
    ASSERT_LT(distance(state.X_OB, X_0), 1e-3) << "least squares: 20 mm · 2/6";
  }
}

// A slip, not a slide: 2 cm in one tick. Its distance to every other foot changes by at least
// 20 mm · cos 75°: trust below 1 / (1 + 5⁴) at once, so that its share of 20 mm is nothing.
TEST(Odometry, IgnoresAFootThatSlipsInATick) {
  const RobotModel model = point_footed(6);
  RobotState state = standing(six_feet());
  Odometry odometry(model, testing::round_params().tolerance);
  odometry.reset(state);
  const Pose X_0 = state.X_OB;
  state.p_BF[3] += Vector3(0.012, 0.016, 0.0);
  for (int tick = 0; tick < 10; ++tick) {
    odometry.update(state, LegArray<double>(6, 1.0), kDt);
    EXPECT_LT(distance(state.X_OB, X_0), 1e-4);
  }
}

// Two feet leave the turn about their line open, one foot all turns, no foot everything: what is
// open stays as it was, the rest is followed.
TEST(Odometry, FollowsAShiftWithOneOrTwoFeetAndStaysWithNone) {
  const RobotModel model = point_footed(6);
  for (int feet = 0; feet <= 2; ++feet) {
    RobotState state = standing(six_feet());
    Odometry odometry(model, testing::round_params().tolerance);
    odometry.reset(state);
    LegArray<double> footing(6, 0.0);
    for (LegId i = 0; i < feet; ++i) footing[i] = 1.0;
    const Vector3 way(0.02, -0.01, 0.005);
    for (int tick = 1; tick <= 100; ++tick) {
      for (LegId i = 0; i < 6; ++i) state.p_BF[i] = six_feet()[i] - way * tick / 100.0;
      odometry.update(state, footing, kDt);
    }
    const Vector3 expected = Vector3(0.0, 0.0, kHeight) + (feet > 0 ? way : Vector3::Zero());
    EXPECT_LT(distance(state.X_OB, {Matrix3::Identity(), expected}), 1e-9) << feet << " feet";
  }
}

// A leg in the air says nothing of the body, and stands where it comes down: its foothold and its
// print are those of the landing, not of the lift.
TEST(Odometry, AnchorsAFootAnewWhereItLands) {
  const RobotModel model = point_footed(6);
  RobotState state = standing(six_feet());
  Odometry odometry(model, testing::round_params().tolerance);
  odometry.reset(state);
  const Pose X_0 = state.X_OB;
  LegArray<double> footing(6, 1.0);
  footing[2] = 0.0;
  const Vector3 print = state.print_O[2];
  for (int tick = 1; tick <= 100; ++tick) {
    state.p_BF[2] += Vector3(0.002, 0.0, 0.0005);
    odometry.update(state, footing, kDt);
  }
  EXPECT_LT(distance(state.X_OB, X_0), 1e-12);
  EXPECT_EQ(state.print_O[2], print);
  const Vector3 landing = state.p_OF[2];
  footing[2] = 1.0;
  for (int tick = 1; tick <= 100; ++tick) odometry.update(state, footing, kDt);
  EXPECT_LT(distance(state.X_OB, X_0), 1e-12);
  EXPECT_LT((state.print_O[2] - landing).norm(), 1e-12);
}

// (odometry 8) Three feet on one side, a few millimetres off a line, that slide by a millimetre: legs of two joints tell
// of no roll about it, and of the turns that they do tell of as before.
TEST(Odometry, SeesNoTurnAboutARowOfFeetThatSlide) {
  RobotModel model = point_footed(6);
  for (LegModel& leg : model.legs) leg.kind = LegKind::yaw_pitch;
  RobotState state = standing(six_feet());
  state.p_BF[2].y() += 0.004;
  Odometry odometry(model, testing::round_params().tolerance);
  odometry.reset(state);
  const Matrix3 before = state.X_OB.R;
  LegArray<double> footing(6, 0.0);
  for (const LegId i : {0, 2, 4}) footing[i] = 1.0;
  odometry.update(state, footing, kDt);
  state.p_BF[2].z() += 0.001;
  for (int k = 0; k < 50; ++k) odometry.update(state, footing, kDt);
  EXPECT_LT(rotation_vector(before.transpose() * state.X_OB.R).norm(), 0.002);

  const Matrix3 turned = rotation({0.0, 0.01, 0.02});
  for (Vector3& p : state.p_BF) p = turned.transpose() * p;
  for (int k = 0; k < 5; ++k) odometry.update(state, footing, kDt);
  EXPECT_LT(rotation_vector((before * turned).transpose() * state.X_OB.R).norm(), 0.004);
}

}  // namespace
}  // namespace hexagait
