// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/plant/plant.hpp>
#include <hexagait/script/action_runner.hpp>
#include <hexagait/sim/ground_truth.hpp>
#include <hexagait/sim/random.hpp>

namespace hexagait::experiments {

/// A localisation such as ICP on laser scans: drift-free, at a low rate, and jumping ([FG16]
/// III-C).
///
/// At each fix the pose of the base in the map is the true one, but for an error that is drawn
/// anew: a shift, uniform in a disc and in an interval of height, and a turn about the vertical.
/// Roll and pitch are known from gravity. Between fixes map stands still in odom:
///
///     X_OM = X_OB · X_MB⁻¹,  both at the time of the fix
///
/// A value; deterministic by its seed.
class JumpingLocalisation {
 public:
  struct Params {
    double period = 0.7;    ///< from fix to fix [s]
    double shift = 0.015;   ///< radius of the disc [m]
    double height = 0.005;  ///< [m]
    double turn = 0.007;    ///< [rad]
    std::uint64_t seed = 1;
  };

  explicit JumpingLocalisation(const Params& params);

  /// Map in odom; before every tick.
  [[nodiscard]] Pose X_OM(const ActionRecord& record, const GroundTruth& truth);

 private:
  [[nodiscard]] Pose erroneous(const Pose& X_MB);

  Params params_;
  RandomSequence random_;
  double next_fix_ = 0.0;  ///< [s]
  Pose X_OM_;
};

/// A robot whose yaw joints are mounted off their zeros, all by the same angle, and which does not
/// know: what it reads is true + error, what it is told is carried out − error. By leg odometry it
/// walks straight on; truly it walks off to the side by the error times the distance. A drift as
/// real robots have it, from within.
///
/// The yaw joint of a leg is the first one whose axis is vertical with all joints at zero; the
/// error is about z upwards, also where the axis points down.
class MiscalibratedPlant : public Plant {
 public:
  /// @param yaw_error  [rad]
  /// @throws InvalidInput  if a leg has no yaw joint
  MiscalibratedPlant(Plant& plant, const RobotModel& robot, double yaw_error);

  PlantStatus read(Measurement& measurement) override;
  void write(const JointTargets& targets) override;

 private:
  Plant& plant_;
  LegArray<LegJoints> error_;  ///< [rad]
};

}  // namespace hexagait::experiments
