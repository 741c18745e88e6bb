// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/fg16/localisation.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <numbers>

namespace hexagait::experiments {

JumpingLocalisation::JumpingLocalisation(const Params& params)
    : params_(params), random_{.seed = params.seed, .stream = RandomStream::noise} {}

Pose JumpingLocalisation::X_OM(const ActionRecord& record, const GroundTruth& truth) {
  if (truth.time >= next_fix_) {
    X_OM_ = record.state.X_OB * erroneous(truth.X_WB).inverse();
    next_fix_ = truth.time + params_.period;
  }
  return X_OM_;
}

Pose JumpingLocalisation::erroneous(const Pose& X_MB) {
  const double radius = params_.shift * std::sqrt(random_.u01());
  const double angle = random_.uniform(-std::numbers::pi, std::numbers::pi);
  const Vector2 sideways = radius * unit_vector(angle);
  const Vector3 shift(sideways.x(), sideways.y(), random_.uniform(-params_.height, params_.height));
  const double turn = random_.uniform(-params_.turn, params_.turn);
  return {rotation_z(turn) * X_MB.R, X_MB.p + shift};
}

MiscalibratedPlant::MiscalibratedPlant(Plant& plant, const RobotModel& robot, double yaw_error)
    : plant_(plant), error_(robot.num_legs(), LegJoints::Zero()) {
  constexpr double kVertical = 1e-6;  // axis from the vertical [rad]
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const auto& axes = robot.legs[i].axis_B0;
    int yaw = 0;
    while (yaw < axes.size() && axes[yaw].head<2>().norm() > kVertical) ++yaw;
    if (yaw == axes.size())
      throw InvalidInput(
          fmt::format("leg {} of {} has no vertical joint axis: its yaw can't be miscalibrated",
                      robot.legs[i].name, robot.name));
    error_[i][yaw] = std::copysign(yaw_error, axes[yaw].z());
  }
}

PlantStatus MiscalibratedPlant::read(Measurement& measurement) {
  const PlantStatus status = plant_.read(measurement);
  for (LegId i = 0; i < error_.size(); ++i) measurement.q[i] += error_[i];
  return status;
}

void MiscalibratedPlant::write(const JointTargets& targets) {
  JointTargets shifted = targets;
  for (LegId i = 0; i < error_.size(); ++i) shifted.q[i] -= error_[i];
  plant_.write(shifted);
}

}  // namespace hexagait::experiments
