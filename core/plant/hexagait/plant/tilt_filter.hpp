// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/plant/plant.hpp>

namespace hexagait {

/// Where up is, from an inertial measurement unit: its gyroscope follows fast turns, its accelerometer
/// says what is up on average. With u the estimated up in the body frame, a the measured acceleration, ω the
/// measured rate, b its bias, g what the accelerometer measures at rest, and τ the time constant:
///
///     u̇ = u × (ω − b + e/τ),   ḃ = −e/(4 τ²),   e = (a/g) × u                          (tilt 1)
///
/// Linear complementary filter on the rotations that leave yaw open: Mahony, Hamel and Pflimlin,
/// "Nonlinear complementary filters on the special orthogonal group", 2008, eq. (32), critically damped.
/// The error is linear in a, impacts included: what brings the body up to speed and down again cancels,
/// and leaving out the short hard part of it would leave the long soft one.
class TiltFilter {
 public:
  /// @param time  τ [s]: longer than a step takes, so that the body's own accelerations cancel
  explicit TiltFilter(double time) : time_(time) {}

  /// At rest: up is where the acceleration points, and what the gyroscope feels is its bias.
  void reset(const InertialMeasurement& imu) noexcept;

  /// @param dt  time since the last update, or reset() [s]
  void update(const InertialMeasurement& imu, double dt) noexcept;

  /// Unit vector upwards, body frame.
  [[nodiscard]] const Vector3& up_B() const { return up_B_; }
  /// Bias of the gyroscope [rad/s].
  [[nodiscard]] const Vector3& rate_bias() const { return bias_; }

 private:
  double time_;
  double gravity_ = 0.0;  ///< magnitude of the acceleration at rest, as measured [m/s²]
  Vector3 up_B_ = Vector3::UnitZ();
  Vector3 bias_ = Vector3::Zero();
};

}  // namespace hexagait
