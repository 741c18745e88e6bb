// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/params/robot_params.hpp>
#include <hexagait/plant/plant.hpp>
#include <hexagait/plant/robot_state.hpp>

namespace hexagait {

/// Where up is, felt in the joints: a robot without an inertial sensor whose odometry has lost its tilt
/// still stands under its weight. The executor feeds forward the efforts with which the feet would carry
/// the weight m g û along what odometry takes for up, û. If up is u, the servos of stiffness K give way
/// by e = q* − q until the feet carry m g u. They also hold the links of their legs, by the efforts w_i of
/// (weight 1). So the sum of their forces says (statics of each leg)
///
///     u − û = s − λ r,   s = Σ_i J_i⁻ᵀ (w_i − K e_i)/m g,   r = −(K/m g) Σ_i J_i⁻ᵀ q̇*_i     (odometry 6)
///
/// across û. Forces of the feet against each other cancel in the sum. The servos are late by λ, which shows
/// in how s varies with r; it is the least-squares slope of the two, each less its mean over the last τ.
/// Up is corrected slowly,
///
///     dû/dt = c (s − λ r) / τ_n,   τ_n = τ (1 + (σ²/σ₀² + ρ²/ρ₀²)²),   ε² = ε₀² + (1.4 λ² |r|/τ)²   (odometry 7)
///
/// with c = max(0, 1 − ε/|mean of s − λ r over τ|): odometry is trusted within ε₀ = 0.04 rad, 0.015 once a leg is
/// lost, and further with drives that are late, by what motion changes within their lag. σ² is the variance
/// of s − λ r, ρ² the mean of (|û + s − λ r| − 1)², since up is a unit vector however far off û is: dry friction, and
/// servos that take no effort, make that large, and then the joints say nothing. Nothing is corrected while the
/// robot tips over less than three feet, nor before λ is known well enough for the speed of the joints.
///
/// K/(m g) need not be known well: it scales the rate of the correction, and ε; if it is half or twice as large, up is
/// off by 0.02 rad more (argos), for the weight of the legs. A value.
class GravitySense {
 public:
  /// Of a robot whose legs have three joints or more: those of two can't tell what carries them sideways.
  /// @param state    joints and attitude that are measured and estimated in this tick
  /// @param targets  what the servos were sent in the last tick
  /// @param lost     legs that are not there; where they change everything is learnt anew
  /// @param stand    how many legs stand and feel the ground
  /// @param dt       control period [s]
  /// @returns the correction of û in this tick, body frame, across û; 0 if the joints say nothing
  Vector3 update(const RobotModel& model, const RobotState& state, const JointTargets& targets,
                 LegSet lost, int stand, double dt, const ToleranceParams& tolerance) noexcept;

  /// λ, as estimated; 0 before anything has moved [s].
  [[nodiscard]] double lag() const noexcept;

 private:
  LegArray<Vector3> own_;                                        ///< Jᵢ⁻ᵀ wᵢ/(m g)
  LegId next_ = 0;                                               ///< the last one that was computed
  Vector3 mean_s_ = Vector3::Zero(), mean_r_ = Vector3::Zero();  ///< over the last τ
  Vector3 mean_ = Vector3::Zero();  ///< of s − λ r, over the last τ
  double rs_ = 0.0, rr_ = 0.0;      ///< covariance of r and s, variance of r
  double speed2_ = 0.0;             ///< mean of |r|² over the last τ
  double noise2_ = 0.0;             ///< σ²
  double amiss2_ = 0.0;             ///< ρ²
  LegSet lost_;                     ///< legs that were not there in the last tick
};

}  // namespace hexagait
