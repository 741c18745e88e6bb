// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <hexagait/balance/load_sharing.hpp>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/posture/arc_optimum.hpp>
#include <hexagait/posture/plane_fit.hpp>
#include <testing/argos.hpp>
#include <testing/kinematic_plant.hpp>

// The stages of a tick by themselves, on the state of a walk three seconds old: a tripod in the
// air.

namespace hexagait::footstep_gen {
namespace {

using heading_control::Heading;

struct Snapshot {
  RobotModel robot = hexagait::testing::argos();
  Heading heading = Heading::arc(0.8, 0.3);
  Walker walker{robot};
  Executor executor{robot, {}};

  Snapshot() {
    testing::KinematicPlant plant(robot, 0.7, {.seed = 17});
    walker.start(plant.measurement);
    for (int k = 0; k < 1500 || walker.record().gait_input.airborne.size() < 3; ++k)
      plant.follow(walker.tick(PlantStatus::fresh, plant.measurement, heading), 0.002);
    executor.reset(record().state);
  }
  const TickRecord& record() const { return walker.record(); }
};

const Snapshot& snapshot() {
  static const Snapshot snapshot;
  return snapshot;
}

void inverse_kinematics_of_a_leg(benchmark::State& state) {
  const RobotModel& robot = snapshot().robot;
  Vector3 p_BF = robot.legs[0].p_BC;
  for (auto _ : state) {
    benchmark::DoNotOptimize(p_BF);
    benchmark::DoNotOptimize(inverse_kinematics(robot.legs[0], p_BF));
  }
}
BENCHMARK(inverse_kinematics_of_a_leg);

void forward_kinematics_of_a_leg(benchmark::State& state) {
  const RobotModel& robot = snapshot().robot;
  LegJoints q = snapshot().record().state.q[0];
  for (auto _ : state) {
    benchmark::DoNotOptimize(q);
    benchmark::DoNotOptimize(foot_position(robot.legs[0], leg_trig(robot.legs[0], q)));
  }
}
BENCHMARK(forward_kinematics_of_a_leg);

void odometry_update(benchmark::State& state) {
  RobotState robot_state = snapshot().record().state;
  Odometry odometry(snapshot().robot);
  odometry.reset(robot_state);
  const LegArray<double> footing(6, 1.0);
  for (auto _ : state) {
    odometry.update(robot_state, footing, 0.002);
    benchmark::DoNotOptimize(robot_state);
  }
}
BENCHMARK(odometry_update);

void path_arc_of_a_heading(benchmark::State& state) {
  const Stance stance = nominal_stance(snapshot().robot);
  for (auto _ : state)
    benchmark::DoNotOptimize(heading_control::path_arc(snapshot().heading, stance));
}
BENCHMARK(path_arc_of_a_heading);

void path_tracker_update(benchmark::State& state) {
  heading_control::PathTracker tracker(0.5);
  tracker.reset({});
  tracker.follow(snapshot().record().arc.per_metre);
  double s = 0.0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        tracker.update(exponential(snapshot().record().arc.per_metre, s += 1e-3)));
}
BENCHMARK(path_tracker_update);

void gait_latch_update(benchmark::State& state) {
  gait_state::GaitLatch latch;
  gait_state::GaitInput input = snapshot().record().gait_input;
  for (auto _ : state) {
    benchmark::DoNotOptimize(input);
    benchmark::DoNotOptimize(latch.update(input));
  }
}
BENCHMARK(gait_latch_update);

void posture_arc_optimum(benchmark::State& state) {
  const PoseAdaptationInput in =
      snapshot().executor.pose_adaptation_input(snapshot().record().state);
  for (auto _ : state)
    benchmark::DoNotOptimize(posture::arc_optimum(in.p_BF, in.p_BC, LegSet(0b011001),
                                                  snapshot().record().arc.per_metre));
}
BENCHMARK(posture_arc_optimum);

void posture_plane_fit(benchmark::State& state) {
  const PoseAdaptationInput in =
      snapshot().executor.pose_adaptation_input(snapshot().record().state);
  for (auto _ : state)
    benchmark::DoNotOptimize(posture::plane_fit(in.footprint_BF, in.p_BC, LegSet::all(6)));
}
BENCHMARK(posture_plane_fit);

void base_command(benchmark::State& state) {
  const Snapshot& s = snapshot();
  for (auto _ : state)
    benchmark::DoNotOptimize(base_auto(s.robot, s.record().arc, s.executor, s.record().state.X_OB,
                                       {}, s.walker.params().step));
}
BENCHMARK(base_command);

void load_sharing(benchmark::State& state) {
  const LegArray<double> share(6, 1.0);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        shared_load(snapshot().record().state.p_BF, snapshot().robot.p_BM, share, 490.0));
}
BENCHMARK(load_sharing);

void executor_advance(benchmark::State& state) {
  Executor executor = snapshot().executor;
  executor.command(snapshot().record().base_auto);
  for (auto _ : state) benchmark::DoNotOptimize(&executor.advance(snapshot().record().state, 1e-6));
}
BENCHMARK(executor_advance);

}  // namespace
}  // namespace hexagait::footstep_gen
