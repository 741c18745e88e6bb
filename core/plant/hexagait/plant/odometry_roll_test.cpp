// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/plant/odometry.hpp>
#include <hexagait/plant/testing/point_feet.hpp>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>
#include <testing/round_params.hpp>

namespace hexagait {
namespace {

using namespace testing;

/// A robot whose legs all point forwards, in parallel planes, with spherical feet of 2 cm.
RobotModel parallel_legs() {
  RobotModel model = point_footed(4);
  model.foot_radius = 0.02;
  for (LegId i = 0; i < 4; ++i) {
    LegModel& leg = model.legs[i];
    leg.X_BH.p = {i < 2 ? 0.4 : -0.4, i % 2 == 0 ? 0.2 : -0.2, 0.0};
    leg.coxa = 0.08, leg.femur = 0.28, leg.tibia = 0.38;
    leg.min_reach = 0.15, leg.max_reach = 0.63;
  }
  return model;
}

void measure(const RobotModel& model, RobotState& state, LegId i, const Vector3& p_BF) {
  const LegSolution solution = inverse_kinematics(model.legs[i], p_BF);
  ASSERT_TRUE(solution.reachable);
  state.q[i] = solution.q;
  state.trig[i] = leg_trig(model.legs[i], solution.q);
  state.p_BF[i] = p_BF;
}

/// Pitch of the tibia in the plane of a leg that points forwards: canonical k₂ + k₃ [rad].
double tibia_pitch(const RobotState& state, LegId i) { return state.q[i][1] + state.q[i][2]; }

// A wheel: the body shifts ahead without turning, each tibia turns by θ about y, and its foot rolls
// ahead by ρ θ, exactly. Odometry that takes the feet for points believes the body to be short of
// that: ρ · 15° = 5.24 mm.
TEST(Odometry, KnowsThatSphericalFeetRoll) {
  const RobotModel rolling = parallel_legs();
  RobotModel point = rolling;
  point.foot_radius = 0.0;
  RobotState state = standing(LegArray<Vector3>(4));
  const auto stand = [&](LegId i, double shift, double roll) {
    const Vector3 p = rolling.legs[i].X_BH.p + Vector3(0.40 + roll - shift, 0.0, -0.30);
    measure(rolling, state, i, p);
  };
  for (LegId i = 0; i < 4; ++i) stand(i, 0.0, 0.0);
  const ToleranceParams tolerance = testing::round_params().tolerance;
  Odometry knows(rolling, tolerance), ignores(point, tolerance);
  RobotState naive = state;
  knows.reset(state);
  ignores.reset(naive);

  const double pitch_0 = tibia_pitch(state, 0);
  double shift = 0.0, theta = 0.0;
  while (theta < 15.0 * std::numbers::pi / 180.0) {
    shift += 0.5 * kDt;
    for (LegId i = 0; i < 4; ++i)  // the roll depends on the pitch and the pitch on the roll
      for (int k = 0; k < 12; ++k)
        stand(i, shift, k == 0 ? 0.0 : rolling.foot_radius * (tibia_pitch(state, i) - pitch_0));
    theta = tibia_pitch(state, 0) - pitch_0;
    naive.q = state.q, naive.trig = state.trig, naive.p_BF = state.p_BF;
    knows.update(state, LegArray<double>(4, 1.0), kDt);
    ignores.update(naive, LegArray<double>(4, 1.0), kDt);
    ASSERT_NEAR(state.X_OB.p.x(), shift, 1e-9);
  }
  EXPECT_NEAR(naive.X_OB.p.x() - shift, -0.02 * theta, 1e-6);
  EXPECT_NEAR(naive.X_OB.p.x() - shift, -0.00524, 5e-5);
}

// Argos' front, middle and rear legs, each turning its own way, under a body that advances, sways
// and turns: the rolling constraint dp = dφ × ρ n integrated at a tenth of the tick, dφ the tibia's
// rotation from exact orientations. What is left is second order in a tick's turn (1e-3 rad · ρ),
// with random sign in time; point feet err by the whole roll.
TEST(Odometry, FollowsTheRollOfEveryFootWhenTheBodyTurns) {
  const RobotModel rolling = testing::argos();
  RobotModel point = rolling;
  point.foot_radius = 0.0;
  RobotState state = standing(LegArray<Vector3>(6));
  for (LegId i = 0; i < 6; ++i) measure(rolling, state, i, rolling.legs[i].p_BC);
  RobotState naive = state;
  Odometry knows(rolling), ignores(point);
  knows.reset(state);
  ignores.reset(naive);

  constexpr int kSubsteps = 10;
  const Pose X_0 = state.X_OB;
  const Twist V{{0.3, 0.05, -0.04}, {0.05, -0.1, 0.3}};
  LegArray<Vector3> p_OF = state.p_OF;
  double worst = 0.0;
  for (int step = 1; step <= 150 * kSubsteps; ++step) {
    const Pose X_before = X_0 * travelled(V, (step - 1) * kDt / kSubsteps);
    const Pose X_OB = X_0 * travelled(V, step * kDt / kSubsteps);
    for (LegId i = 0; i < 6; ++i) {
      const Matrix3 R_before = X_before.R * tibia_rotation(rolling.legs[i], state.trig[i]);
      const Vector3 before = p_OF[i];
      for (int k = 0; k < 6; ++k) {
        measure(rolling, state, i, X_OB.inverse() * p_OF[i]);
        const Matrix3 R = X_OB.R * tibia_rotation(rolling.legs[i], state.trig[i]);
        const Vector3 turn = rotation_vector(R * R_before.transpose());
        p_OF[i] = before + turn.cross(rolling.foot_radius * Vector3::UnitZ());
      }
      measure(rolling, state, i, X_OB.inverse() * p_OF[i]);
    }
    if (step % kSubsteps != 0) continue;
    naive.q = state.q, naive.trig = state.trig, naive.p_BF = state.p_BF;
    knows.update(state, LegArray<double>(6, 1.0), kDt);
    ignores.update(naive, LegArray<double>(6, 1.0), kDt);
    worst = std::max(worst, distance(state.X_OB, X_OB));
  }
  EXPECT_LT(worst, 2e-5);
  EXPECT_GT(distance(naive.X_OB, X_0 * travelled(V, 150 * kDt)), 2e-3);
}

}  // namespace
}  // namespace hexagait
