// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/fg16/localisation.hpp>
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
  const Vector3 shift(radius * std::cos(angle), radius * std::sin(angle),
                      random_.uniform(-params_.height, params_.height));
  const double turn = random_.uniform(-params_.turn, params_.turn);
  return {rotation_z(turn) * X_MB.R, X_MB.p + shift};
}

PlantStatus MiscalibratedPlant::read(Measurement& measurement) {
  const PlantStatus status = plant_.read(measurement);
  for (LegJoints& q : measurement.q) q[0] += error_;
  return status;
}

void MiscalibratedPlant::write(const JointTargets& targets) {
  JointTargets shifted = targets;
  for (LegJoints& q : shifted.q) q[0] -= error_;
  plant_.write(shifted);
}

}  // namespace hexagait::experiments
