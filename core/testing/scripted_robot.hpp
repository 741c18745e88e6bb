// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <hexagait/script/action_runner.hpp>
#include <hexagait/script/preview.hpp>
#include <testing/round_params.hpp>

/// For tests of scripted actions.
namespace hexagait::testing {

/// What is not set of the parameters, in round numbers.
inline RunnerParams rounded(RunnerParams params) {
  RobotParams all, round = round_params();
  all.swing = params.executor.swing;
  all.base = params.executor.base;
  all.tolerance = params.tolerance;
  all.script = params.sequencer.planner.script;
  for (const Parameter& one : parameters())
    if (is_derived(one.in(all))) one.in(all) = one.in(round);
  params.executor.swing = all.swing;
  params.executor.base = all.base;
  params.tolerance = all.tolerance;
  params.sequencer.planner.script = all.script;
  return params;
}

/// A robot without mass that does exactly what it is told, on ground that has a height at each
/// place. A foot touches where it is at the ground or below it; one that stands feels the ground up
/// to 1 mm above it. Odometry takes the robot at its word, so odom is the world.
class ScriptedRobot {
 public:
  /// What a foot feels whatever is below it.
  enum class Touch { as_the_ground_is, nothing, something };

  explicit ScriptedRobot(const RobotModel& robot, const RunnerParams& params = {})
      : model(robot),
        runner(model, rounded(params)),
        touch(robot.num_legs(), Touch::as_the_ground_is) {
    measurement = {0.0, nominal_joints(model), LegArray<bool>(model.num_legs(), true)};
    runner.start(measurement);
  }
  ScriptedRobot(const ScriptedRobot&) = delete;
  ScriptedRobot& operator=(const ScriptedRobot&) = delete;

  /// Before the tick: what the sensors say of what the last one did.
  void sense() {
    const ActionRecord& record = runner.record();
    measurement.time += runner.params().control_dt;
    measurement.q = record.desired.targets.q;
    for (LegId i = 0; i < model.num_legs(); ++i) {
      const Vector3 p_OF = record.state.X_OB * foot_position(model.legs[i], measurement.q[i]);
      const double above = p_OF.z() - model.foot_radius - ground(p_OF.x(), p_OF.y());
      const bool touches = above <= (measurement.contact[i] ? 1e-3 : 0.0);
      measurement.contact[i] =
          touch[i] == Touch::as_the_ground_is ? touches : touch[i] == Touch::something;
    }
  }

  const ActionRecord& tick() {
    sense();
    return runner.tick(PlantStatus::fresh, measurement);
  }

  /// Until there is nothing to do, at most so many seconds; calls `look` after each tick.
  const ActionResult& finish(const std::function<void(const ActionRecord&)>& look = {},
                             double most_seconds = 60.0) {
    const double end = measurement.time + most_seconds;
    while (!runner.idle() && measurement.time < end) {
      const ActionRecord& record = tick();
      if (look) look(record);
    }
    return runner.record().result;
  }

  void run(double seconds) {
    const double end = measurement.time + seconds - 1e-9;
    while (measurement.time < end) tick();
  }

  [[nodiscard]] const ActionRecord& record() const { return runner.record(); }
  [[nodiscard]] double dt() const { return runner.params().control_dt; }
  [[nodiscard]] const LegLane& lane(LegId leg) const { return runner.executor().legs()[leg]; }

  /// Set point of a foot in odom [m].
  [[nodiscard]] Vector3 foot(LegId leg) const { return record().state.X_OB * lane(leg).p_BF; }

  const RobotModel model;
  ActionRunner runner;
  Measurement measurement;
  LegArray<Touch> touch;
  std::function<double(double, double)> ground = [](double, double) { return 0.0; };  ///< [m]
};

}  // namespace hexagait::testing
