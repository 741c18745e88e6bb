// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/curves/knots.hpp>
#include <span>
#include <vector>

namespace hexagait {

/// Pose and twist of the base B relative to a frame A.
struct BaseState {
  Pose X_AB;
  Twist V_B;  ///< in the axes of B: v = R_ABᵀ ṗ_AB [m/s], w [rad/s]
};

/// max(distance / v, angle / w, minimum) [s].
/// @param average_speed, average_turn_rate  v [m/s], w [rad/s]; > 0
[[nodiscard]] double base_duration(const Pose& from, const Pose& to, double average_speed,
                                   double average_turn_rate, double minimum) noexcept;

/// The motion of the base over time: cubic Hermite in R³ × SO(3); pose and twist are continuous
/// (C1), including at the start state. Positions and rotations are independent of each other.
///
/// Rotations are cubic quaternion curves with a cumulative basis (Kim, Kim & Shin 1995), written
/// with rotation matrices. In a segment of duration T from R₀ with w₀ to R₁ with w₁ (both in B),
/// with τ = t/T:
///
///     R(τ) = R₀ exp(β₁ φ₁) exp(β₂ φ₂) exp(β₃ φ₃)
///     β₁ = 1 − (1−τ)³,   β₂ = 3τ² − 2τ³,   β₃ = τ³
///     φ₁ = w₀ T/3,   φ₃ = w₁ T/3,   exp(φ₂) = exp(−φ₁) R₀ᵀ R₁ exp(−φ₃),   |φ₂| ≤ π
///     w T = β₃' φ₃ + exp(−β₃ φ₃) (β₂' φ₂ + exp(−β₂ φ₂) β₁' φ₁)
///
/// Velocities at inner knots are parabola_rates(), for rotations of the rotation vectors in B. They
/// are 0 where the path turns by 90° or more, and at most 3 times the smaller of the mean
/// velocities before and after; on a straight line a cubic is monotone within that bound (Fritsch &
/// Carlson 1980).
///
/// Only reserve() allocates. A value: assignment to a curve of sufficient capacity does not
/// allocate.
class BaseCurve {
 public:
  BaseCurve() { reserve(1); }
  BaseCurve(const BaseCurve& other) { *this = other; }
  BaseCurve(BaseCurve&&) noexcept = default;
  BaseCurve& operator=(const BaseCurve& other);
  BaseCurve& operator=(BaseCurve&&) noexcept = default;
  ~BaseCurve() = default;

  /// Allocates space for this many knots, at least one.
  void reserve(int knots);

  /// Plans a motion through all usable_knots(); without any, the base stays at its start. A target
  /// is a trajectory of one knot.
  /// @param end_V_B  twist at the last knot, axes of B
  void plan(const BaseState& start, std::span<const BaseKnot> knots,
            const Twist& end_V_B = {}) noexcept;

  /// Is the motion finite at any time?
  [[nodiscard]] bool in_range() const noexcept;
  [[nodiscard]] double duration() const noexcept;
  /// @param t  since the start [s], clamped into [0, duration()]
  [[nodiscard]] BaseState at(double t) const noexcept;

 private:
  struct Node {
    double time = 0.0;
    BaseState state;
    Vector3 phi_2 = Vector3::Zero();  // of the segment that begins here [rad]
  };
  std::vector<Node> nodes_;
};

}  // namespace hexagait
