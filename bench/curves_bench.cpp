// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <hexagait/curves/base_curve.hpp>
#include <hexagait/curves/foot_curve.hpp>
#include <hexagait/curves/joint_curve.hpp>

// What the motion curves cost: to make them, at a change of steps, and to evaluate them, in every
// tick.

namespace hexagait {
namespace {

template <class Curve>
void evaluate(benchmark::State& state, const Curve& curve) {
  double t = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(curve.at(t));
    t += 0.0025;
    if (t > curve.duration()) t = 0.0;
  }
}

FootSwing swing_of(benchmark::State& state) {
  return {.target = {0.3, 0.05, 0.02}, .profile = static_cast<SwingProfile>(state.range(0))};
}
const PointState kLiftOff{{0, 0, 0}, {0, 0, 0.1}, {0, 0, 0}};

void foot_swing_plan(benchmark::State& state) {
  const FootSwing swing = swing_of(state);
  FootCurve curve;
  for (auto _ : state) {
    curve.plan_swing(kLiftOff, swing, swing_duration(kLiftOff.p, swing, 0.65, 0.45));
    benchmark::DoNotOptimize(curve);
  }
}
void foot_swing_at(benchmark::State& state) {
  FootCurve curve;
  curve.plan_swing(kLiftOff, swing_of(state), 0.6);
  evaluate(state, curve);
}
BENCHMARK(foot_swing_plan)->DenseRange(0, 3);
BENCHMARK(foot_swing_at)->DenseRange(0, 3);

std::vector<FootKnot> foot_knots(benchmark::State& state) {
  std::vector<FootKnot> knots;
  for (int k = 1; k <= state.range(0); ++k)
    knots.push_back({0.1 * k, {0.1 * k, 0.02 * (k % 3), 0.0}, {}});
  return knots;
}
void foot_trajectory_plan(benchmark::State& state) {
  const auto knots = foot_knots(state);
  FootCurve curve;
  curve.reserve(static_cast<int>(knots.size()));
  for (auto _ : state) {
    curve.plan_trajectory({}, knots);
    benchmark::DoNotOptimize(curve);
  }
}
void foot_trajectory_at(benchmark::State& state) {
  const auto knots = foot_knots(state);
  FootCurve curve;
  curve.reserve(static_cast<int>(knots.size()));
  curve.plan_trajectory({}, knots);
  evaluate(state, curve);
}
BENCHMARK(foot_trajectory_plan)->Arg(1)->Arg(10)->Arg(1000);
BENCHMARK(foot_trajectory_at)->Arg(1)->Arg(10)->Arg(1000);

std::vector<JointKnot> joint_knots(benchmark::State& state) {
  std::vector<JointKnot> knots(static_cast<std::size_t>(state.range(0)));
  for (std::size_t k = 0; k < knots.size(); ++k) {
    knots[k].time = 0.1 * static_cast<double>(k + 1);
    knots[k].q = leg_joints({0.1, 0.2, 0.3}) * static_cast<double>(k % 4);
  }
  return knots;
}
void joint_plan(benchmark::State& state) {
  const auto knots = joint_knots(state);
  JointCurve curve;
  curve.reserve(static_cast<int>(knots.size()));
  for (auto _ : state) {
    curve.plan({}, knots);
    benchmark::DoNotOptimize(curve);
  }
}
void joint_at(benchmark::State& state) {
  const auto knots = joint_knots(state);
  JointCurve curve;
  curve.reserve(static_cast<int>(knots.size()));
  curve.plan({}, knots);
  evaluate(state, curve);
}
BENCHMARK(joint_plan)->Arg(1)->Arg(10)->Arg(1000);
BENCHMARK(joint_at)->Arg(1)->Arg(10)->Arg(1000);

std::vector<BaseKnot> base_knots(benchmark::State& state) {
  std::vector<BaseKnot> knots;
  for (int k = 1; k <= state.range(0); ++k)
    knots.push_back({0.5 * k, {rotation({0.02 * k, 0.1 * (k % 2), 0.05 * k}), {0.1 * k, 0, 0.4}}});
  return knots;
}
void base_plan(benchmark::State& state) {
  const auto knots = base_knots(state);
  BaseCurve curve;
  curve.reserve(static_cast<int>(knots.size()));
  for (auto _ : state) {
    curve.plan({}, knots);
    benchmark::DoNotOptimize(curve);
  }
}
void base_at(benchmark::State& state) {
  const auto knots = base_knots(state);
  BaseCurve curve;
  curve.reserve(static_cast<int>(knots.size()));
  curve.plan({{}, {{0.1, 0, 0}, {0, 0, 0.1}}}, knots);
  evaluate(state, curve);
}
BENCHMARK(base_plan)->Arg(1)->Arg(10)->Arg(1000);
BENCHMARK(base_at)->Arg(1)->Arg(10)->Arg(1000);

}  // namespace
}  // namespace hexagait
