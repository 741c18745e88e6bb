// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/viewer/display/frame_maker.hpp>
#include <hexagait/viewer/tasks/followed_path.hpp>
#include <hexagait/viewer/tasks/performance.hpp>
#include <hexagait/walk/referee/reference_path.hpp>
#include <memory>

namespace hexagait::viewer {

/// A walk that is steered tick by tick: the loop of walker and plant, with a command that comes from
/// outside and without an end. What it walks is a simulated robot (SimulatedWalk), or a live one (LiveWalk).
/// In between it may perform scripted actions: then an ActionRunner is in the walker's place.
/// It does not grow: it may walk for days. It belongs to the thread that made it.
class SteeredWalk {
 public:
  virtual ~SteeredWalk() = default;
  SteeredWalk(const SteeredWalk&) = delete;
  SteeredWalk& operator=(const SteeredWalk&) = delete;

  /// One control period: targets for the present measurement, then the next measurement. Of a live robot
  /// this waits for it. Once a fault has stopped the robot its joints are held. While it follows a path, of
  /// the command only the speed limit counts; while it performs an action, nothing.
  void tick(const heading_control::HeadingCommand& command);

  /// From the next tick on the set points of all joints are held, until go_on().
  void emergency_stop();

  /// After an emergency stop or another fault: takes the robot over where it stands.
  /// @throws InvalidInput  if it can't be: the robot has fallen, or tells nothing valid
  void go_on();

  /// Why it does not walk; it may have fallen besides.
  [[nodiscard]] Fault fault() const {
    return acts() ? performance_->record().fault : walker_.record().fault;
  }
  [[nodiscard]] virtual bool fell() const { return false; }

  /// From the next tick on, until it arrives, is interrupted, or leaves the path.
  /// @param X_WP  of the path's frame in the world
  void follow(path_following::PathTask task, const PlanarPose& X_WP);
  void leave_path() { followed_path_ = nullptr; }
  [[nodiscard]] FollowedPath* path() { return followed_path_.get(); }  ///< null: none
  /// Of which a path's look-ahead is made.
  [[nodiscard]] const StepParams& step() const { return walker_.params().step; }

  /// From the next tick on: the robot stops, performs the action, and walks again as it is told.
  /// @param action  checked for this robot
  /// @throws InvalidInput  if it can't: it performs one already, is stopped by a fault, or has lost a leg
  void perform(action::Action action);
  /// The action that goes on, if there is one, ends with feet on the ground.
  void stop_action() noexcept;
  [[nodiscard]] bool performs() const { return progress_.goes_on(); }
  /// Of the last action.
  [[nodiscard]] const ActionProgress& progress() const { return progress_; }

  /// With which it performs.
  [[nodiscard]] const RunnerParams& runner_params() const { return runner_params_; }

  void set_gait(const gait_state::StepperParams& stepper) { walker_.set_stepping(stepper); }

  /// What is seen now. scene, holder, flags of the session and speed_factor are not set.
  [[nodiscard]] PoseFrame frame() const;

  /// Pose in the plane.
  [[nodiscard]] PlanarPose place() const { return in_plane(truth().X_WB); }
  [[nodiscard]] double control_dt() const { return walker_.params().control_dt; }
  [[nodiscard]] const RobotModel& robot() const { return robot_; }
  /// The ground that is drawn.
  [[nodiscard]] virtual const sim3d::Terrain& terrain() const = 0;
  /// A twist as a command for this robot.
  [[nodiscard]] heading_control::HeadingCommand command_of(
      const PlanarTwist& twist, const heading_control::Heading& last) const;

  /// The last targets: for tests.
  [[nodiscard]] const JointTargets& targets() const {
    return acts() ? performance_->record().desired.targets : walker_.record().targets;
  }

 protected:
  /// @throws InvalidInput  as Walker
  SteeredWalk(const RobotModel& robot, const recording::Simulation& simulation);

  /// Takes the robot over where it was last measured. @throws InvalidInput  as Walker::start()
  void take_over();

  /// The loop's ends: as of a Plant.
  virtual PlantStatus read(Measurement& measurement) = 0;
  virtual void write(const JointTargets& targets) = 0;
  /// Robot and feet in the world: of the simulator, or as the controller believes.
  [[nodiscard]] virtual const GroundTruth& truth() const = 0;
  /// A controller has taken the robot over: its odometry begins anew.
  virtual void begin_odometry() {}
  /// After each exchange: what is seen of it, by frames().observe().
  virtual void observe() = 0;

  [[nodiscard]] FrameMaker& frames() { return frames_; }
  /// As the controller that moves the robot believes.
  [[nodiscard]] const RobotState& state() const {
    return acts() ? performance_->record().state : walker_.record().state;
  }
  [[nodiscard]] const Measurement& measurement() const { return measurement_; }
  [[nodiscard]] PlantStatus status() const { return status_; }

  /// Targets out, the next measurement in.
  void exchange(const heading_control::HeadingCommand& command);
  /// The next measurement, without targets.
  void listen() { status_ = read(measurement_); }

 private:
  void judge();
  void tick_action();
  void end_action();
  /// Does the runner of an action move the robot, or hold it, in the walker's place?
  [[nodiscard]] bool acts() const { return performance_ != nullptr && performance_->runs(); }

  RobotModel robot_;
  footstep_gen::Walker walker_;
  Measurement measurement_;
  PlantStatus status_ = PlantStatus::late;
  RunnerParams runner_params_;
  std::unique_ptr<Performance> performance_;  // null: it walks
  ActionProgress progress_;

  FrameMaker frames_;
  std::unique_ptr<FollowedPath> followed_path_;
  walk::ReferencePath path_;
  double lateral_ = 0.0;  // [m]
  heading_control::Heading followed_ = heading_control::Heading::stop();
};

}  // namespace hexagait::viewer
