// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/viewer/walking/steered_walk.hpp>
#include <hexagait/walk/faults/faults.hpp>

namespace hexagait::viewer {

/// Where a walk begins, and how the feet are displaced.
struct WalkStart {
  PlanarPose X_WB;         ///< on any ground: each foot begins at the height of the ground there
  double spread = 0.0;     ///< feet are displaced by up to this [m]
  std::uint64_t draw = 0;  ///< which displacement
};

/// A steered walk of a robot in the simulator: what recording::simulate() does. The only part of the viewer
/// that knows the world. Once the robot has fallen it only lies there. A body that an action sets down on the
/// ground has not fallen, nor until the walker has raised it again.
///
/// It belongs to the thread that made it, as its world does.
class SimulatedWalk : public SteeredWalk {
 public:
  /// Stands in place, settled.
  /// @param simulation  its trial's schedule and random posture are not used
  /// @throws InvalidInput  as sim3d::World and Walker
  SimulatedWalk(const RobotModel& robot, const recording::Simulation& simulation,
                const WalkStart& start = {});

  /// Pushes the body for 1.1 √(h/g), so that a free body of the robot's mass would get 0.85 √(g h), with
  /// the height h of the robot's body over its feet.
  /// @param angle  from the body's x [rad]
  void push(double angle);

  /// Something breaks, from the next tick on.
  /// @param fault  resolved(), and no load
  void add(walk::PartFault fault) { broken_.add(std::move(fault)); }

  [[nodiscard]] bool fell() const override { return fell_; }
  [[nodiscard]] const sim3d::Terrain& terrain() const override { return world_.terrain(); }

 private:
  PlantStatus read(Measurement& m) override { return plant_.read(m); }
  void write(const JointTargets& targets) override { plant_.write(targets); }
  [[nodiscard]] const GroundTruth& truth() const override { return world_.truth(); }
  void observe() override;
  void settle();

  sim3d::World world_;
  walk::PartFaultPlant broken_;
  walk::FaultyPlant plant_;
  double falling_speed_;  // √(g h) [m/s]
  bool fell_ = false, sits_ = false;
};

/// Joint positions of a level body over uneven ground, each foot at the height of the ground below
/// it, as far as it reaches.
[[nodiscard]] LegArray<LegJoints> posture_on(const sim3d::Terrain& terrain, const RobotModel& robot,
                                             const WalkStart& start);

}  // namespace hexagait::viewer
