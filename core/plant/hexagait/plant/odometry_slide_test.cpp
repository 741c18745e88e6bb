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

using testing::kDt;

// Six point feet; joints play no part.
struct SixFeet {
  RobotModel model = testing::point_footed(6);
  RobotState state = testing::standing(LegArray<Vector3>(6));
  Odometry odometry{model, testing::round_params().tolerance};
  LegArray<double> footing{6, 1.0};

  SixFeet() {
    for (LegId i = 0; i < 6; ++i) state.p_BF[i] = {0.5 - 0.2 * i, i % 2 == 0 ? 0.4 : -0.4, -0.3};
    odometry.reset(state);
  }
  void move(LegId leg, const Vector3& way, int ticks) {
    for (int k = 0; k < ticks; ++k) {
      state.p_BF[leg] += way / ticks;
      odometry.update(state, footing, kDt);
    }
  }
};

// 10 mm, all but what the pose gives way until the foot is found to slide; the others stand.
TEST(OdometrySlide, IsTheWayOfAFootThatSlides) {
  SixFeet feet;
  const Vector3 way(0.006, 0.0, -0.008);
  feet.move(2, way, 100);
  EXPECT_LT((feet.state.slide_O[2] - way).norm(), 0.001);
  for (const LegId i : {0, 1, 3, 4, 5}) EXPECT_LT(feet.state.slide_O[i].norm(), 0.001) << i;
}

// The body moves on over its feet.
TEST(OdometrySlide, IsNoneOfAFootThatStands) {
  SixFeet feet;
  for (int k = 0; k < 200; ++k) {
    for (Vector3& p_BF : feet.state.p_BF) p_BF.x() -= 0.0005;
    feet.odometry.update(feet.state, feet.footing, kDt);
  }
  EXPECT_NEAR(feet.state.X_OB.p.x(), 0.1, 1e-9);
  for (const Vector3& slide_O : feet.state.slide_O) EXPECT_LT(slide_O.norm(), 1e-9);
}

// In the air a foot goes where it likes, and lands where it likes.
TEST(OdometrySlide, IsNoneOfAFootInTheAir) {
  SixFeet feet;
  feet.footing[2] = 0.0;
  feet.move(2, {0.2, 0.0, 0.0}, 50);
  feet.footing[2] = 1.0;
  feet.move(2, Vector3::Zero(), 10);
  EXPECT_LT(feet.state.slide_O[2].norm(), 1e-9);
}

// The body moves on by 10 cm: centres of feet of 2 cm that roll by a millimetre have not slid.
TEST(OdometrySlide, IsNotTheRollingOfAFoot) {
  const RobotModel model = testing::argos();
  RobotState state;
  state.q = LegArray<LegJoints>(6);
  state.trig = LegArray<LegTrig>(6);
  state.p_BF = LegArray<Vector3>(6);
  const auto stand = [&](const Vector3& shift, const LegArray<Vector3>& rolled) {
    for (LegId i = 0; i < 6; ++i) {
      const Vector3 p_BF = model.legs[i].p_BC + shift + rolled[i];
      state.q[i] = inverse_kinematics(model.legs[i], p_BF).q;
      state.trig[i] = leg_trig(model.legs[i], state.q[i]);
      state.p_BF[i] = p_BF;
    }
  };
  LegArray<Vector3> rolled(6, Vector3::Zero());
  stand(Vector3::Zero(), rolled);
  Odometry odometry(model);
  odometry.reset(state);
  for (int k = 1; k <= 100; ++k) {
    const LegArray<LegJoints> q = state.q;
    const LegArray<LegTrig> trig = state.trig;
    stand({-0.001 * k, 0.0, 0.0}, rolled);
    for (LegId i = 0; i < 6; ++i)
      rolled[i] += tibia_turn(model.legs[i], trig[i], state.q[i] - q[i])
                       .cross(model.foot_radius * Vector3::UnitZ());
    stand({-0.001 * k, 0.0, 0.0}, rolled);
    odometry.update(state, LegArray<double>(6, 1.0), kDt);
  }
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_GT(rolled[i].norm(), 0.0005) << i;
    EXPECT_LT(state.slide_O[i].norm(), 0.2 * rolled[i].norm()) << i;
  }
}

}  // namespace
}  // namespace hexagait
