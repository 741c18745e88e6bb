// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <array>
#include <hexagait/balance/stance_pose.hpp>
#include <hexagait/balance/whole_body.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/argos.hpp>

// What BaseAuto's pose costs, which is asked for where a step changes, and what a whole-body
// controller costs, which runs every tick.

namespace hexagait {
namespace {

using testing::argos;

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

void efforts(benchmark::State& state, WholeBodyController controller, LegSet support, double push) {
  LegArray<LegJoints> q(6);
  LegArray<LegTrig> trig(6);
  WholeBodyInput input{q,
                       trig,
                       LegArray<Vector3>(6),
                       LegArray<double>(6, 0.0),
                       Matrix3::Identity(),
                       argos().p_BM,
                       LegArray<Vector3>(6, Vector3::UnitZ()),
                       {}};
  for (LegId i = 0; i < 6; ++i) {
    input.p_BF[i] = argos().legs[i].p_BC;
    const LegSolution joints = inverse_kinematics(argos().legs[i], input.p_BF[i]);
    trig[i] = joints.trig;
    q[i] = joints.q;
    input.load[i] = support.contains(i) ? 1.0 : 0.0;
  }
  input.error.p_B = {push, 0.0, 0.005};
  for (auto _ : state)
    benchmark::DoNotOptimize(joint_efforts(controller, argos(), input, 9.81,
                                           {.frequency = 12.5, .turn_frequency = 12.5}));
}

constexpr auto kKinematic = WholeBodyController::kinematic;
constexpr auto kVirtualModel = WholeBodyController::virtual_model;
BENCHMARK_CAPTURE(efforts, kinematic_on_six_feet, kKinematic, LegSet(0b111111), 0.0);
BENCHMARK_CAPTURE(efforts, virtual_model_on_six_feet, kVirtualModel, LegSet(0b111111), 0.01);
BENCHMARK_CAPTURE(efforts, virtual_model_on_a_tripod, kVirtualModel, LegSet(0b011001), 0.01);
BENCHMARK_CAPTURE(efforts, virtual_model_at_its_friction, kVirtualModel, LegSet(0b111111), 0.2);

}  // namespace
}  // namespace hexagait
