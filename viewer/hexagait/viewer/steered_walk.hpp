// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/viewer/followed_path.hpp>
#include <hexagait/viewer/frame_maker.hpp>
#include <hexagait/walk/faults.hpp>
#include <hexagait/walk/reference_path.hpp>
#include <memory>

namespace hexagait::viewer {

/// Where a walk begins, and how the feet are displaced.
struct WalkStart {
  PlanarPose X_WB;         ///< on any ground: each foot begins at the height of the ground there
  double spread = 0.0;     ///< feet are displaced by up to this [m]
  std::uint64_t draw = 0;  ///< which displacement
};

/// A robot in the simulator that is steered tick by tick: what recording::simulate() does, with a
/// command that comes from outside and without an end. The only part of the viewer that knows
/// walker, plant and world. It neither reads a clock nor grows: it may walk for days.
///
/// It belongs to the thread that made it, as its world does.
class SteeredWalk {
 public:
  /// Stands in place, settled.
  /// @param simulation  its trial's schedule and random posture are not used
  /// @throws InvalidInput  as sim3d::World and Walker
  SteeredWalk(const RobotModel& robot, const recording::Simulation& simulation,
              const WalkStart& start = {});
  SteeredWalk(const SteeredWalk&) = delete;
  SteeredWalk& operator=(const SteeredWalk&) = delete;

  /// One control period. Once the robot has fallen, or a fault has stopped it, it only lies there. While
  /// it follows a path, of the command only the speed limit counts.
  void tick(const heading_control::HeadingCommand& command);

  /// Pushes the body for 1.1 √(h/g), so that a free body of the robot's mass would get 0.85 √(g h), with
  /// the height h of the robot's body over its feet.
  /// @param angle  from the body's x [rad]
  void push(double angle);

  /// Something breaks, from the next tick on.
  /// @param fault  resolved(), and no load
  void add(walk::PartFault fault) { broken_.add(std::move(fault)); }

  /// From the next tick on, until it arrives, is interrupted, or leaves the path.
  /// @param X_WP  of the path's frame in the world
  void follow(path_following::PathTask task, const PlanarPose& X_WP);
  void leave_path() { followed_path_ = nullptr; }
  [[nodiscard]] FollowedPath* path() { return followed_path_.get(); }  ///< null: none
  /// Of which a path's look-ahead is made.
  [[nodiscard]] const StepParams& step() const { return walker_.params().step; }

  void set_gait(const gait_state::StepperParams& stepper);

  /// What is seen now. scene, holder, flags of the session and speed_factor are not set.
  [[nodiscard]] PoseFrame frame() const;

  /// True pose in the plane.
  [[nodiscard]] PlanarPose place() const;
  [[nodiscard]] bool fell() const { return fell_; }
  [[nodiscard]] double control_dt() const { return simulation_.control_dt; }
  [[nodiscard]] const RobotModel& robot() const { return robot_; }
  [[nodiscard]] const recording::Simulation& simulation() const { return simulation_; }
  [[nodiscard]] const sim3d::Terrain& terrain() const { return world_.terrain(); }
  /// A twist as a command for this robot.
  [[nodiscard]] heading_control::HeadingCommand command_of(
      const PlanarTwist& twist, const heading_control::Heading& last) const;

  /// The last targets: for tests.
  [[nodiscard]] const JointTargets& targets() const { return walker_.record().targets; }

 private:
  void settle();
  void observe();
  void judge();

  RobotModel robot_;
  recording::Simulation simulation_;
  sim3d::World world_;
  walk::PartFaultPlant broken_;
  walk::FaultyPlant plant_;
  footstep_gen::Walker walker_;
  Measurement measurement_;
  PlantStatus status_ = PlantStatus::fresh;

  double falling_speed_;  // √(g h) [m/s]
  FrameMaker frames_;
  std::unique_ptr<FollowedPath> followed_path_;
  walk::ReferencePath path_;
  double lateral_ = 0.0;  // [m]
  heading_control::Heading followed_ = heading_control::Heading::stop();
  bool fell_ = false;
};

/// Joint positions of a level body over uneven ground, each foot at the height of the ground below
/// it, as far as it reaches.
[[nodiscard]] LegArray<LegJoints> posture_on(const sim3d::Terrain& terrain, const RobotModel& robot,
                                             const WalkStart& start);

}  // namespace hexagait::viewer
