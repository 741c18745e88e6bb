// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/plant/robot_state.hpp>
#include <limits>

namespace hexagait::walk {

/// How the robot starts an action.
enum class StartKind : std::uint8_t {
  standing,  ///< in the nominal stance
  sitting,   ///< belly and feet on level ground, the feet where they are in the nominal stance
  lying,     ///< belly on level ground, the legs at random above it
};

struct StartPosture {
  LegArray<LegJoints> q;  ///< [rad]
  RestsOn rests_on = RestsOn::feet;
  double height =
      -std::numeric_limits<double>::infinity();  ///< of the base above the ground, at least [m]
};

/// A posture to start from. The legs of a lying robot are random: each joint uniform within its
/// limits, redrawn until the whole leg is above the ground.
/// @throws InvalidInput  if a leg is in the way of lying on the belly
[[nodiscard]] StartPosture start_posture(const RobotModel& model, StartKind kind,
                                         std::uint64_t seed = 1);

/// Distance of the base's lowest point below its origin [m].
[[nodiscard]] double belly_depth(const RobotModel& model);

}  // namespace hexagait::walk
