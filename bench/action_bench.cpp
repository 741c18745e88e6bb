// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <testing/action_words.hpp>
#include <testing/argos.hpp>
#include <testing/counted_allocations.hpp>
#include <testing/scripted_robot.hpp>

// What scripted actions cost, on 18 joints: a tick in which all legs have a motion and BaseAuto is
// under way, and a tick in which a step begins, whose BaseAuto is optimised; by joint positions, or
// with the virtual model. The perfect robot of the tests plays the action once and is recorded;
// then its ticks are timed on copies.

namespace hexagait {
namespace {

using testing::argos;
using testing::foot_target;
using testing::leg_mode;
using testing::ScriptedRobot;
using testing::step;

// Three feet swing, three are told to stand: a motion for each of six legs, and for the base.
action::Action tripods() {
  action::Action action;
  ScriptedRobot robot(argos());
  for (int k = 0; k < 4; ++k) {
    std::vector<action::LegCommand> legs;
    for (LegId i = 0; i < 6; ++i) {
      const bool swings = (i == 0 || i == 3 || i == 4) == (k % 2 == 0);
      const Vector3 p = robot.foot(i) + Vector3(0.02 * (k / 2 + 1), 0.01, 0.0);
      if (swings) legs.push_back({testing::footstep(i, p), {}});
      if (!swings) legs.push_back({leg_mode(i, true), {}});
    }
    action.steps.push_back(step(action::BaseAuto{}, legs));
  }
  return action;
}

// All six feet move over the base, which lies on its belly, so to speak.
action::Action six_feet() {
  action::Action action;
  ScriptedRobot robot(argos());
  for (int k = 0; k < 4; ++k) {
    std::vector<action::LegCommand> legs;
    for (LegId i = 0; i < 6; ++i)
      legs.push_back(
          {foot_target(i, robot.foot(i) + Vector3(0.03 * (k % 2), 0.01, 0.05 + 0.01 * k)), {}});
    action.steps.push_back(step(action::BaseAuto{}, legs));
  }
  return action;
}

constexpr int kTicks = 100;        // timed in one go
constexpr int kIterations = 2000;  // each on a fresh copy, which takes longer than what is timed

/// An action played once: what went into each tick, and the runner before those that are timed.
struct Recording {
  struct Moment {
    ActionRunner runner;
    std::size_t tick;
  };
  ScriptedRobot robot;
  std::vector<Measurement> measurements;
  std::vector<RobotState> states;
  std::vector<Moment> amid;    ///< the first of kTicks in the middle of a step
  std::vector<Moment> starts;  ///< ticks in which a step begins that has one before and one after

  explicit Recording(const action::Action& action,
                     WholeBodyController controller = WholeBodyController::kinematic)
      : robot(argos(), driven_by(controller)) {
    robot.runner.submit(action);
    int step = 0;
    bool within = false;
    while (!robot.runner.idle()) {
      const ActionRunner before = robot.runner;
      const ActionFeedback now = robot.tick().feedback;
      const bool amidst = now.phase > 0.3 && now.phase < 0.5;
      if (now.step != step && now.step > 1 && now.step < now.steps)
        starts.push_back({before, states.size()});
      if (amidst && !within) amid.push_back({before, states.size()});
      within = amidst;
      step = now.step;
      measurements.push_back(robot.measurement);
      states.push_back(robot.record().state);
    }
    if (starts.empty() || robot.record().result.outcome != Outcome::succeeded) std::abort();
  }

  static RunnerParams driven_by(WholeBodyController controller) {
    RunnerParams params;
    params.executor.controller = controller;
    return params;
  }
};

const Recording& tripod_recording() {
  static const Recording recording(tripods());
  return recording;
}
const Recording& virtual_tripod_recording() {
  static const Recording recording(tripods(), WholeBodyController::virtual_model);
  return recording;
}
const Recording& six_feet_recording() {
  static const Recording recording(six_feet());
  return recording;
}

// Times `ticks` ticks from each moment on, on a fresh copy. Among the counters: the median of what
// a tick takes [ns], the time that a tenth of them stay below (on a machine with other work the
// better measure), and how often memory was allocated.
template <class Subject, class Tick>
void play(benchmark::State& state, const std::vector<Recording::Moment>& moments, int ticks,
          const Subject& subject_of, const Tick& tick) {
  using Clock = std::chrono::steady_clock;
  auto subject = subject_of(moments.front().runner);
  std::vector<double> times;
  times.reserve(10'000'000);
  long allocated = 0;
  std::size_t m = 0;
  for (auto _ : state) {
    const Recording::Moment& moment = moments[m++ % moments.size()];
    subject = subject_of(moment.runner);
    const long before = testing::allocations;
    const auto begin = Clock::now();
    for (std::size_t k = 0; k < static_cast<std::size_t>(ticks); ++k)
      tick(subject, moment.tick + k);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count() / ticks;
    allocated += testing::allocations - before;
    state.SetIterationTime(seconds);
    if (times.size() < times.capacity()) times.push_back(seconds);
  }
  std::sort(times.begin(), times.end());
  state.counters["median_ns"] = 1e9 * times[times.size() / 2];
  state.counters["tenth_ns"] = 1e9 * times[times.size() / 10];
  state.counters["allocations"] = static_cast<double>(allocated);
}

// What commands cost: sequencer and executor.
struct Core {
  Sequencer sequencer;
  Executor executor;
};
void play_core(benchmark::State& state, const Recording& recording,
               const std::vector<Recording::Moment>& moments, int ticks) {
  const Frames frames;
  const auto core_of = [](const ActionRunner& runner) {
    return Core{runner.sequencer(), runner.executor()};
  };
  play(state, moments, ticks, core_of, [&](Core& core, std::size_t k) {
    core.sequencer.update(core.executor, recording.states[k], frames, 0.002);
    benchmark::DoNotOptimize(&core.executor.advance(recording.states[k], 0.002));
  });
}

// All of it: watch, odometry and record too.
void play_runner(benchmark::State& state, const Recording& recording,
                 const std::vector<Recording::Moment>& moments, int ticks) {
  const auto runner_of = [](const ActionRunner& runner) -> const ActionRunner& { return runner; };
  play(state, moments, ticks, runner_of, [&](ActionRunner& runner, std::size_t k) {
    benchmark::DoNotOptimize(&runner.tick(PlantStatus::fresh, recording.measurements[k]));
  });
}

void action_tick_tripod(benchmark::State& state) {
  play_core(state, tripod_recording(), tripod_recording().amid, kTicks);
}
void action_tick_virtual_tripod(benchmark::State& state) {
  play_core(state, virtual_tripod_recording(), virtual_tripod_recording().amid, kTicks);
}
void action_tick_six_feet(benchmark::State& state) {
  play_core(state, six_feet_recording(), six_feet_recording().amid, kTicks);
}
void runner_tick_tripod(benchmark::State& state) {
  play_runner(state, tripod_recording(), tripod_recording().amid, kTicks);
}
void runner_tick_six_feet(benchmark::State& state) {
  play_runner(state, six_feet_recording(), six_feet_recording().amid, kTicks);
}
void action_step_tripod(benchmark::State& state) {
  play_core(state, tripod_recording(), tripod_recording().starts, 1);
}
void action_step_six_feet(benchmark::State& state) {
  play_core(state, six_feet_recording(), six_feet_recording().starts, 1);
}

BENCHMARK(action_tick_tripod)->UseManualTime()->Iterations(kIterations);
BENCHMARK(action_tick_virtual_tripod)->UseManualTime()->Iterations(kIterations);
BENCHMARK(action_tick_six_feet)->UseManualTime()->Iterations(kIterations);
BENCHMARK(runner_tick_tripod)->UseManualTime()->Iterations(kIterations);
BENCHMARK(runner_tick_six_feet)->UseManualTime()->Iterations(kIterations);
BENCHMARK(action_step_tripod)->UseManualTime()->Iterations(kIterations);
BENCHMARK(action_step_six_feet)->UseManualTime()->Iterations(kIterations);

}  // namespace
}  // namespace hexagait
