// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/plant/tilt_filter.hpp>

namespace hexagait {

void TiltFilter::reset(const InertialMeasurement& imu) noexcept {
  gravity_ = imu.acceleration.norm();
  up_B_ = gravity_ > 0.0 ? Vector3(imu.acceleration / gravity_) : Vector3(Vector3::UnitZ());
  bias_ = imu.rate;
}

void TiltFilter::update(const InertialMeasurement& imu, double dt) noexcept {
  Vector3 error = Vector3::Zero();
  if (gravity_ > 0.0) error = (imu.acceleration / gravity_).cross(up_B_);
  // The share of the error that is corrected is less than all of it at any control period.
  const Vector3 turn = dt * (imu.rate - bias_) + dt / (time_ + dt) * error;
  up_B_ = (rotation(turn).transpose() * up_B_).normalized();
  bias_ -= dt / (4.0 * time_ * time_) * error;
}

}  // namespace hexagait
