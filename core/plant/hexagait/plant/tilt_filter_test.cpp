// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/plant/tilt_filter.hpp>

namespace hexagait {
namespace {

constexpr double kGravity = 9.81, kTime = 2.0;

/// A body that turns with the rate w(t), and what an ideal unit in it feels.
struct Body {
  Matrix3 R_OB = Matrix3::Identity();
  Vector3 rate = Vector3::Zero();

  InertialMeasurement turned(const Vector3& w, double dt) {
    R_OB = R_OB * rotation(w * dt);
    rate = w;
    return felt();
  }
  InertialMeasurement felt() const { return {kGravity * up(), rate}; }
  Vector3 up() const { return R_OB.row(2).transpose(); }
};

double angle(const Vector3& a, const Vector3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

class AnyPeriod : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Tilt, AnyPeriod, ::testing::Values(0.001, 0.002, 0.005, 0.01, 0.02));

TEST_P(AnyPeriod, StartsWhereTheAccelerationPoints) {
  TiltFilter filter(kTime);
  const Body body{rotation({0.3, -0.2, 1.0}), Vector3::Zero()};
  filter.reset(body.felt());
  EXPECT_LT(angle(filter.up_B(), body.up()), 1e-12);
}

// A body that pitches and rolls to and fro, whose own accelerations are as large as that of a walk: the
// gyroscope follows the turns, and the accelerations cancel.
TEST_P(AnyPeriod, FollowsTurnsAndNotAccelerations) {
  const double dt = GetParam();
  TiltFilter filter(kTime);
  Body body;
  filter.reset(body.felt());
  double worst = 0.0;
  for (double t = 0.0; t < 20.0; t += dt) {
    InertialMeasurement imu =
        body.turned({0.6 * std::cos(3.0 * t), -0.4 * std::sin(2.0 * t), 0.3}, dt);
    imu.acceleration +=
        body.R_OB.transpose() * Vector3(1.0 * std::sin(6.0 * t), 0.5, 2.0 * std::cos(9.0 * t));
    imu.acceleration -= body.R_OB.transpose() * Vector3(0.0, 0.5, 0.0);
    filter.update(imu, dt);
    worst = std::max(worst, angle(filter.up_B(), body.up()));
  }
  EXPECT_LT(worst, 0.02);
}

// A gyroscope that is off by 3 °/s: without an estimate of it, up would stay 0.1 rad off.
TEST_P(AnyPeriod, FindsTheBiasOfTheGyroscope) {
  const double dt = GetParam();
  const Vector3 bias(0.05, -0.03, 0.0);
  TiltFilter filter(kTime);
  const Body body{rotation({0.1, 0.2, 0.0}), Vector3::Zero()};
  InertialMeasurement imu = body.felt();
  filter.reset(imu);
  EXPECT_EQ(filter.rate_bias(), Vector3::Zero());
  imu.rate += bias;  // it drifted after the start
  double worst = 0.0;
  for (double t = 0.0; t < 20.0 * kTime; t += dt) {
    filter.update(imu, dt);
    worst = std::max(worst, angle(filter.up_B(), body.up()));
  }
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(angle(filter.up_B(), body.up()), 1e-3);
  // Along up it turns nothing, and can't be known.
  const Vector3 across = bias - bias.dot(body.up()) * body.up();
  EXPECT_LT((filter.rate_bias() - across).norm(), 1e-3);
}

// The same answer at any control period.
TEST(Tilt, HasATimeConstantThatIsThatOfItsParameter) {
  for (const double dt : {0.001, 0.02}) {
    TiltFilter filter(kTime);
    Body body;
    filter.reset(body.felt());
    body.R_OB = rotation({0.1, 0.0, 0.0});  // a turn that the gyroscope did not feel
    double t = 0.0;
    for (; angle(filter.up_B(), body.up()) > 0.1 / std::exp(1.0); t += dt)
      filter.update(body.felt(), dt);
    EXPECT_GT(t, 0.5 * kTime);
    EXPECT_LT(t, 1.1 * kTime);
  }
}

// A hard blow, after which the body comes to rest slowly.
TEST(Tilt, IsNotMovedByWhatStartsAndStopsTheBody) {
  TiltFilter filter(kTime);
  const Body body;
  filter.reset(body.felt());
  InertialMeasurement hard = body.felt(), soft = body.felt();
  hard.acceleration += Vector3(50.0, 0.0, 0.0);
  soft.acceleration -= Vector3(1.0, 0.0, 0.0);
  for (int k = 0; k < 5; ++k) filter.update(hard, 0.002);
  for (int k = 0; k < 250; ++k) filter.update(soft, 0.002);
  EXPECT_LT(angle(filter.up_B(), body.up()), 0.005);
}

}  // namespace
}  // namespace hexagait
