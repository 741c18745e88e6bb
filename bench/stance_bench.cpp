// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <array>
#include <hexagait/core/random.hpp>
#include <hexagait/core/stance_pose.hpp>

// What BaseAuto's pose costs, which is asked for where a step changes.

namespace hexagait {
namespace {

const RobotModel& argos() {
  static const RobotModel model = load_urdf(HEXAGAIT_SOURCE_DIR "/robots/argos.urdf");
  return model;
}

/// Six feet up to `scatter` [m] from their places, a tripod, or all, in support.
StanceProblem problem_of(RandomSequence& random, double scatter, LegSet support) {
  StanceProblem problem{LegArray<Vector3>(6), LegSet::all(6), support, 0.3, 0.04, {}};
  for (LegId i = 0; i < 6; ++i) {
    const Vector3 offset(random.uniform(-scatter, scatter), random.uniform(-scatter, scatter),
                         random.uniform(-0.3 * scatter, 0.3 * scatter));
    problem.p_OF[i] = argos().legs[i].p_BC + offset;
  }
  return problem;
}

void optimise(benchmark::State& state, double scatter, LegSet support) {
  RandomSequence random{.seed = 1};
  std::array<StanceProblem, 64> problems;
  for (StanceProblem& problem : problems) problem = problem_of(random, scatter, support);
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(optimise_stance(argos(), problems[k++ % 64]));
}

BENCHMARK_CAPTURE(optimise, step_of_5_cm_on_six_feet, 0.05, LegSet(0b111111));
BENCHMARK_CAPTURE(optimise, step_of_5_cm_on_a_tripod, 0.05, LegSet(0b011001));
BENCHMARK_CAPTURE(optimise, step_of_15_cm_on_six_feet, 0.15, LegSet(0b111111));
BENCHMARK_CAPTURE(optimise, step_of_15_cm_on_a_tripod, 0.15, LegSet(0b011001));

}  // namespace
}  // namespace hexagait
