// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/model/kinematics.hpp>
#include <testing/control_period.hpp>
#include <testing/round_params.hpp>

/// For tests of the executor alone.
namespace hexagait::testing {

/// A robot on the plane z = 0 that does exactly what the executor wants.
struct Scene {
  const RobotModel& model;
  Executor executor;
  RobotState state;

  explicit Scene(const RobotModel&&) = delete;
  explicit Scene(const RobotModel& robot) : model(robot), executor(robot, round_executor()) {
    const int n = robot.num_legs();
    state.q = LegArray<LegJoints>(n);
    state.p_BF = state.p_OF = state.print_O = LegArray<Vector3>(n);
    state.trig = LegArray<LegTrig>(n);
    state.contact = LegArray<bool>(n, true);
    for (LegId i = 0; i < n; ++i)
      state.q[i] = inverse_kinematics(robot.legs[i], robot.legs[i].p_BC).q;
    state.X_OB.p.z() = robot.foot_radius - robot.legs[0].p_BC.z();
    sense();
    executor.reset(state);
  }

  void sense() {
    for (LegId i = 0; i < model.num_legs(); ++i) {
      state.trig[i] = leg_trig(model.legs[i], state.q[i]);
      state.p_BF[i] = foot_position(model.legs[i], state.trig[i]);
      state.p_OF[i] = state.X_OB * state.p_BF[i];
      const bool stands = executor.legs()[i].on_ground();
      state.contact[i] = state.p_OF[i].z() <= model.foot_radius + (stands ? 1e-3 : 0.0);
      if (stands) state.print_O[i] = state.p_OF[i];
    }
  }

  void tick(double dt = kDt) {
    state.q = executor.advance(state, dt).q;
    const Twist V = executor.base().twist();
    const Matrix3& R = state.X_OB.R;
    state.X_OB = {R * rotation(V.w * dt),
                  state.X_OB.p + R * (dt * V.v + 0.5 * dt * dt * V.w.cross(V.v))};
    sense();
  }
};

}  // namespace hexagait::testing
