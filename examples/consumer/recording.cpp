// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/urdf/urdf.hpp>

// Walks half a second in the simulator.
int main(int, char** argv) {
  hexagait::recording::Simulation simulation;
  simulation.trial.seconds = 0.5;
  simulation.trial.schedule = hexagait::walk::random_schedule(1, 1.0, 1.0, 0.3);
  const auto robot = hexagait::load_urdf(std::string(argv[1]) + "/argos.urdf");
  const auto summary = hexagait::recording::simulate(robot, simulation);
  std::printf("recording: %s after %.1f s\n", summary.fell ? "fell" : "walks", summary.seconds);
  return summary.fell ? 1 : 0;
}
