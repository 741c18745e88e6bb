// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/curves/knots.hpp>
#include <span>
#include <vector>

namespace hexagait {

/// Where the base B is in a frame A and how it moves over it.
struct BaseState {
  Pose X_AB;
  Twist V_B;  ///< of B over A, in B: v = R_ABᵀ ṗ_AB [m/s], w [rad/s]
};

/// max(distance / v, angle / w, minimum) [s].
/// @param average_speed, average_turn_rate  v [m/s], w [rad/s]; > 0
[[nodiscard]] double base_duration(const Pose& from, const Pose& to, double average_speed,
                                   double average_turn_rate, double minimum) noexcept;

/// The motion of the base over time: cubic Hermite in R³ × SO(3), pose and twist continuous (C1),
/// also from the start state on. Positions and rotations are independent of each other.
///
/// Rotations are cubic quaternion curves with a cumulative basis (Kim, Kim & Shin 1995), written in
/// rotation matrices; in a segment of duration T from R₀ with w₀ to R₁ with w₁ (both in B), τ =
/// t/T:
///
///     R(τ) = R₀ exp(β₁ φ₁) exp(β₂ φ₂) exp(β₃ φ₃)
///     β₁ = 1 − (1−τ)³,   β₂ = 3τ² − 2τ³,   β₃ = τ³
///     φ₁ = w₀ T/3,   φ₃ = w₁ T/3,   exp(φ₂) = exp(−φ₁) R₀ᵀ R₁ exp(−φ₃),   |φ₂| <= π
///     w T = β₃' φ₃ + exp(−β₃ φ₃) (β₂' φ₂ + exp(−β₂ φ₂) β₁' φ₁)
///
/// Inner knots are passed with the parabola's velocity through the neighbours, that of rotations
/// from the rotation vectors before and after, in B: 0 where the way turns back (by 90° or more),
/// no more than 3 times the smaller of both mean velocities: along a line this is the bound within
/// which a cubic is monotone (Fritsch & Carlson 1980).
///
/// Only reserve() allocates. A value; assignment to one with as much room doesn't allocate.
class BaseCurve {
 public:
  BaseCurve() { reserve(1); }
  BaseCurve(const BaseCurve& other) { *this = other; }
  BaseCurve(BaseCurve&&) noexcept = default;
  BaseCurve& operator=(const BaseCurve& other);
  BaseCurve& operator=(BaseCurve&&) noexcept = default;
  ~BaseCurve() = default;

  /// Room for so many knots, at least one.
  void reserve(int knots);

  /// A target is a trajectory of one knot. Knots at times that don't rise, or beyond the room, are
  /// left out as usable_knots() says; without any the start state stands.
  /// @param end_V_B  at the last knot, in B
  void plan(const BaseState& start, std::span<const BaseKnot> knots,
            const Twist& end_V_B = {}) noexcept;

  [[nodiscard]] double duration() const noexcept;
  /// @param t  since the start, clamped into [0, duration()] [s]
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
