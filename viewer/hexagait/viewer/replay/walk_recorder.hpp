// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/recording/simulation.hpp>
#include <hexagait/script/action_runner.hpp>
#include <hexagait/viewer/display/frame_maker.hpp>
#include <hexagait/viewer/display/scene.hpp>
#include <hexagait/viewer/replay/replay_file.hpp>
#include <optional>

namespace hexagait::viewer {

/// Writes a robot on its ground as a replay: the scene, 50 frames per simulated second, and the
/// ground around wherever it gets to.
class SceneRecorder {
 public:
  static constexpr double kSampling = 0.02;  ///< [s]

  /// @param out  and robot must outlive it
  SceneRecorder(std::ostream& out, const RobotModel& robot, std::uint64_t seed, double control_dt);

  /// Is a frame due at this time since the beginning [s]?
  [[nodiscard]] bool is_due(double time) const { return time >= due_ - 1e-9; }
  void write(PoseFrame frame, const sim3d::Terrain& terrain);
  void finish() { writer_.finish(); }

 private:
  const RobotModel* robot_;
  std::uint64_t seed_;
  double control_dt_;
  ReplayWriter writer_;
  LegArray<int> joints_;
  std::optional<GroundPatch> patch_;
  double due_ = 0.0;  // of the next frame [s]
};

/// Writes a walk, or a scripted action, as a replay while it is simulated.
class WalkRecorder {
 public:
  /// @param out         and robot must outlive it
  /// @param simulation  of which seed, control period, gait and schedule count
  WalkRecorder(std::ostream& out, const RobotModel& robot, const recording::Simulation& simulation);

  /// After every tick of a walk: a recording::WorldObserver.
  void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
               const walk::Referee& referee, const sim3d::World& world);
  /// After every tick of an action.
  void observe(const ActionRecord& record, const GroundTruth& truth, const sim3d::World& world);
  void finish() { scene_.finish(); }

 private:
  /// A control period when it is over; its joints are measured in the next one.
  struct Tick {
    GroundTruth truth;
    LegArray<LegJoints> efforts;
    double lateral = 0.0;
    bool fell = false;
  };
  void take(const footstep_gen::TickRecord& record, const sim3d::World& world);
  [[nodiscard]] gait_state::Stepping stepping(double time) const;

  gait_state::Stepping stepping_;
  walk::Schedule schedule_;
  SceneRecorder scene_;
  FrameMaker frames_;
  std::optional<Tick> last_;
  bool began_ = false;
};

}  // namespace hexagait::viewer
