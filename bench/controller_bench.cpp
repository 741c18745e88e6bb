// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <hexagait/footstep_gen/walker.hpp>
#include <testing/argos.hpp>
#include <testing/kinematic_plant.hpp>
#include <vector>

// The whole controller, walking. Its answers move the kinematic plant, so measurements are recorded
// beforehand and played back to a walker that began in the same state: it does what it did then,
// bit for bit, and only its tick is timed.

namespace hexagait::footstep_gen {
namespace {

using heading_control::Heading;

constexpr int kTicks = 5000;  // 10 s: seven double steps

struct Recording {
  RobotModel robot;
  std::vector<Measurement> measurements;
  Walker start;

  explicit Recording(const RobotModel& model, const Heading& heading) : robot(model), start(robot) {
    testing::KinematicPlant plant(robot, 0.7, {.seed = 16});
    start.start(plant.measurement);
    Walker walker = start;
    for (int k = 0; k < kTicks; ++k) {
      measurements.push_back(plant.measurement);
      const TickRecord& record = walker.tick(PlantStatus::fresh, plant.measurement, heading);
      plant.follow(record, walker.params().control_dt);
    }
  }
};

void play(benchmark::State& state, const RobotModel& robot, const Heading& heading) {
  const Recording recording(robot, heading);
  Walker walker = recording.start;
  std::size_t k = 0;
  for (auto _ : state) {
    if (k == recording.measurements.size()) {
      state.PauseTiming();
      walker = recording.start;
      k = 0;
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(
        &walker.tick(PlantStatus::fresh, recording.measurements[k++], heading));
  }
  state.counters["joints"] = 3.0 * robot.num_legs();
}

using hexagait::testing::argos;

void controller_tick_straight(benchmark::State& state) {
  play(state, argos(), Heading::straight(0.0));
}
void controller_tick_arc(benchmark::State& state) { play(state, argos(), Heading::arc(0.8, 0.3)); }
void controller_tick_standing(benchmark::State& state) { play(state, argos(), Heading::stop()); }
void controller_tick_of_legs(benchmark::State& state) {
  play(state, testing::robot_of(static_cast<int>(state.range(0))), Heading::arc(0.8, 0.3));
}
BENCHMARK(controller_tick_straight);
BENCHMARK(controller_tick_arc);
BENCHMARK(controller_tick_standing);
BENCHMARK(controller_tick_of_legs)->Arg(4)->Arg(8)->Arg(12);

// A heading that changes at every tick: a joystick that never rests.
void controller_tick_steered(benchmark::State& state) {
  const Recording recording(argos(), Heading::straight(0.0));
  Walker walker = recording.start;
  const Heading headings[] = {Heading::arc(0.8, 0.3), Heading::arc(0.81, 0.3)};
  std::size_t k = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        &walker.tick(PlantStatus::fresh, recording.measurements[0], headings[k++ % 2]));
}
BENCHMARK(controller_tick_steered);

// To know what the playback itself costs: a walker in a fault returns at once.
void controller_tick_overhead(benchmark::State& state) {
  const Recording recording(argos(), Heading::stop());
  Walker walker = recording.start;
  walker.emergency_stop();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        &walker.tick(PlantStatus::fresh, recording.measurements[0], Heading::stop()));
}
BENCHMARK(controller_tick_overhead);

}  // namespace
}  // namespace hexagait::footstep_gen
