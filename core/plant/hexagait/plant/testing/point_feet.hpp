// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/plant/robot_state.hpp>

namespace hexagait::testing {

inline constexpr double kHeight = 0.3;  // of the body over the feet [m]

/// Six feet 0.3 m below the body, where a hexapod has them.
inline LegArray<Vector3> six_feet() {
  LegArray<Vector3> p_BF(6);
  for (LegId i = 0; i < 6; ++i) {
    const int row = i / 2;
    p_BF[i] = {0.5 - 0.5 * row, i % 2 == 0 ? 0.4 : -0.4, -kHeight};
  }
  return p_BF;
}

/// A robot with point feet. Its joints play no part in odometry.
inline RobotModel point_footed(int legs) {
  RobotModel model;
  model.legs = LegArray<LegModel>(legs);
  return model;
}

inline RobotState standing(const LegArray<Vector3>& p_BF) {
  RobotState state;
  const int n = p_BF.size();
  state.q = LegArray<LegJoints>(n, LegJoints::Zero());
  state.trig = LegArray<LegTrig>(n);
  state.p_BF = p_BF;
  return state;
}

/// The displacement by the twist V within t. The closed form for V constant: by halving.
inline Pose travelled(const Twist& V, double t) {
  constexpr int kHalvings = 12;
  const double h = t / (1 << kHalvings);
  Pose X{rotation(V.w * h), h * V.v + 0.5 * h * h * V.w.cross(V.v)};
  for (int k = 0; k < kHalvings; ++k) X = X * X;
  return X;
}

inline double distance(const Pose& a, const Pose& b) {
  return (a.p - b.p).norm() + rotation_vector(a.R.transpose() * b.R).norm();
}

}  // namespace hexagait::testing
