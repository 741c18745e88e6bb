// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/script/action_runner.hpp>

namespace hexagait::viewer {

/// How a scripted action goes, or how the last one ended.
struct ActionProgress {
  enum class State : std::uint8_t {
    none,     ///< there was no action yet
    halting,  ///< the robot stops walking
    running,
    done,
    stopped,  ///< before its end, by who steers
    failed,
  };
  State state = State::none;
  int step = 0, steps = 0;  ///< from 1; 0: before the first one
  const char* why = "";     ///< it failed or was stopped, in words
  LegId leg = -1;           ///< that caused the failure; -1: none

  [[nodiscard]] bool goes_on() const { return state == State::halting || state == State::running; }
  bool operator==(const ActionProgress&) const = default;
};

/// A scripted action of a robot that walks: the walker brings the robot to a stand, then an ActionRunner
/// moves it. Allocates when it is made and when the runner takes the robot over, not in other ticks.
class Performance {
 public:
  /// @param robot  must outlive it
  /// @throws InvalidInput  as ActionRunner
  Performance(const RobotModel& robot, const RunnerParams& params, action::Action action);

  /// After each tick of the walker, which is told to stop. Once all feet stand and the body rests, the
  /// runner takes the robot over as it was measured. If it doesn't come to that in time, the action has failed.
  void wait_for_stand(const footstep_gen::Walker& walker, PlantStatus status,
                      const Measurement& measurement);

  /// Does the runner move the robot, or hold it after a fault?
  [[nodiscard]] bool runs() const { return runs_; }
  /// One control period of the runner.
  /// @param X_WB  of the robot: the map of the action is the world
  const ActionRecord& tick(PlantStatus status, const Measurement& measurement, const Pose& X_WB);
  [[nodiscard]] const ActionRecord& record() const { return runner_.record(); }

  /// Feet in the air are lowered to the ground, then it is over.
  void stop() noexcept { stops_ = true; }
  /// The set points of all joints are held.
  void emergency_stop(const Measurement& measurement) noexcept;

  [[nodiscard]] const ActionProgress& progress() const { return progress_; }

 private:
  void end(ActionProgress::State state, const char* why, LegId leg = -1) noexcept;
  void report() noexcept;

  ActionRunner runner_;
  action::Action action_;  ///< until it begins
  bool runs_ = false, stops_ = false;
  double waited_ = 0.0;  ///< for the robot to stand [s]
  ActionProgress progress_;
};

}  // namespace hexagait::viewer
