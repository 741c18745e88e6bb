// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/executor/executor.hpp>
#include <hexagait/heading_control/twist.hpp>
#include <initializer_list>
#include <testing/kinematic_plant.hpp>
#include <testing/round_params.hpp>

/// For tests: a robot that stands, of which single legs lift.
namespace hexagait::footstep_gen::testing {

inline StepParams round_step() { return hexagait::testing::round_params().step; }

/// Of six feet from their workspace centres [m].
using Offsets = std::array<Vector3, 6>;

inline Offsets shift_of_all(const Vector3& offset) {
  return {offset, offset, offset, offset, offset, offset};
}

/// A six-legged robot whose feet stand at their workspace centres plus what the test says.
struct StandingRobot {
  RobotModel robot = robot_of(6);
  RobotState state;
  Executor executor{robot, hexagait::testing::round_executor()};

  // Not inlined: GCC 12 would warn that unused elements are copied uninitialised.
  [[gnu::noinline]] explicit StandingRobot(const Offsets& offset = shift_of_all(Vector3::Zero())) {
    state.q = LegArray<LegJoints>(6);
    state.p_BF = state.p_OF = state.print_O = LegArray<Vector3>(6);
    state.trig = LegArray<LegTrig>(6);
    state.contact = LegArray<bool>(6, true);
    state.X_OB = {rotation_z(0.6), {2.0, -1.0, 0.32}};
    for (LegId i = 0; i < 6; ++i) {
      state.p_BF[i] = robot.legs[i].p_BC + offset[static_cast<std::size_t>(i)];
    }
    place();
  }

  // The feet where p_BF says.
  void place() {
    for (LegId i = 0; i < 6; ++i) {
      state.q[i] = inverse_kinematics(robot.legs[i], state.p_BF[i]).q;
      state.trig[i] = leg_trig(robot.legs[i], state.q[i]);
      state.print_O[i] = state.p_OF[i] = state.X_OB * state.p_BF[i];
    }
    executor.reset(state);
  }

  heading_control::PathArc arc(const heading_control::Heading& heading) const {
    return heading_control::path_arc(heading, nominal_stance(robot));
  }
  void lift(std::initializer_list<LegId> legs) {
    for (const LegId i : legs) executor.command(FootstepCommand{i, state.p_OF[i]}, state);
  }
};

/// The same offset for all feet.
inline StandingRobot shifted(const Vector3& offset) { return StandingRobot(shift_of_all(offset)); }

}  // namespace hexagait::footstep_gen::testing
