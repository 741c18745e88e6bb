// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/viewer/walking/simulated_walk.hpp>
#include <limits>
#include <testing/source_path.hpp>

namespace hexagait::viewer::testing {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

inline const RobotModel& argos() {
  static const RobotModel robot = load_urdf(hexagait::testing::source_path("robots/argos.urdf"));
  return robot;
}

inline recording::Simulation on(const char* terrain, std::uint64_t seed = 1) {
  recording::Simulation simulation;
  simulation.terrain = sim3d::parse_terrain(terrain);
  simulation.seed = seed;
  return simulation;
}

/// @param seconds  [s]
inline void run(SimulatedWalk& walk, const heading_control::Heading& heading, double seconds) {
  for (long k = std::lround(seconds / walk.control_dt()); k > 0; --k)
    walk.tick({heading, kInfinite});
}

}  // namespace hexagait::viewer::testing
