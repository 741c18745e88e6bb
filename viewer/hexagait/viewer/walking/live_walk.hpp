// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/pipe/pipe_plant.hpp>
#include <hexagait/viewer/steering/wheel.hpp>
#include <hexagait/viewer/walking/steered_walk.hpp>

namespace hexagait::viewer {

/// A steered walk of a live robot, whose plant is in another process. The robot's states are its clock. What
/// is shown is what the controller believes: the place is that of odometry, the ground is drawn flat, forces
/// and slip are not known.
///
/// While a fault holds the robot its packets say so (TargetPacket::stopped), and so does the last one.
class LiveWalk final : public SteeredWalk {
 public:
  /// Within which the first state must come [s].
  static constexpr double kPatience = 5.0;

  /// Waits for the first state, and takes the robot over as it stands.
  /// @param simulation  of which only parameters, sensors, gait and control period are used
  /// @param plant       must outlive it
  /// @throws InvalidInput  if no state came, or none that is valid
  LiveWalk(const RobotModel& robot, const recording::Simulation& simulation, PipePlant& plant,
           double patience = kPatience);
  ~LiveWalk() override;  ///< leaves the robot stopped

  /// The longest time without a state, of those that have ended since this was last asked [s]; 0: none
  /// was late.
  [[nodiscard]] double take_gap() { return std::exchange(gap_, 0.0); }

  [[nodiscard]] const sim3d::Terrain& terrain() const override { return ground_; }

 private:
  PlantStatus read(Measurement& measurement) override;
  void write(const JointTargets& targets) override;
  [[nodiscard]] const GroundTruth& truth() const override { return seen_; }
  void begin_odometry() override;
  void observe() override;
  void see();

  PipePlant& plant_;
  sim3d::Terrain ground_;
  PlanarPose X_WO_;   ///< of odometry, which begins anew after a stop
  GroundTruth seen_;  ///< as the controller believes
  LegArray<LegJoints> no_efforts_;
  Clock::time_point last_state_ = Clock::now();
  bool late_ = false;
  double gap_ = 0.0;
};

}  // namespace hexagait::viewer
