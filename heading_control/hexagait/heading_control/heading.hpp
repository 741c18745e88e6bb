// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>

namespace hexagait::heading_control {

/// Sense of rotation, seen from above: ccw turns left.
enum class Turn { ccw, cw };

/// A commanded path: a straight line, a circular arc, or a turn on the spot. The body turns about
/// the turning centre ([PC04] 4)
///
///     o = r (−sin α, cos α)
///
/// α is the crab angle, the direction in which the body's origin sets off (0 ahead, π backwards),
/// and r the signed radius: r > 0 turns left, r < 0 right. r is singular twice: ±∞ are the same
/// straight line, and 0 does not say which way to turn. So a heading is stored homogeneously,
///
///     r = ρ / k,    ρ ≥ 0,    ρ² + k² = 1    (lengths in units of 1 m)
///
/// which is never singular: k = 0 is straight, (ρ, k) = (0, 1) a spin to the left, (0, −1) a spin
/// to the right, and everything computed from (ρ, k, α) is continuous across all of them. The body
/// turns by k while its origin moves by ρ (cos α, sin α); PathArc gives it a scale.
///
/// A stopped heading keeps its path: legs are still ordered by their lag along it, and starting
/// again in the same direction does not reorder them.
class Heading {
 public:
  /// Straight on along α [rad].
  /// @throws std::invalid_argument  if α is not finite
  [[nodiscard]] static Heading straight(double alpha);

  /// Along the circle of signed radius r [m] with crab angle α [rad]; r = ±∞ is straight(α).
  /// @throws std::invalid_argument  if r is 0 (use spin()) or NaN, or α is not finite
  [[nodiscard]] static Heading arc(double r, double alpha);

  /// On the spot, about the body's origin.
  [[nodiscard]] static Heading spin(Turn turn) noexcept;

  /// The path on which the body's origin moves by v [m] while the body turns by w [rad]; only their
  /// ratios matter. If all are 0 or one is not finite: stop().
  [[nodiscard]] static Heading along(const Vector2& v, double w) noexcept;

  /// Stopped, straight ahead.
  [[nodiscard]] static Heading stop() noexcept { return Heading(1.0, 0.0, 0.0).stopped(); }

  /// The same path, stopped.
  [[nodiscard]] Heading stopped() const noexcept;

  [[nodiscard]] bool moving() const noexcept { return moving_; }

  /// r [m]: +∞ when straight, 0 when spinning (turn() says which way).
  [[nodiscard]] double radius() const noexcept;
  /// 1/r [1/m]: 0 when straight, ±∞ when spinning.
  [[nodiscard]] double curvature() const noexcept { return k_ / rho_; }
  /// α in (−π, π] [rad]; 0 when spinning, where it has no meaning.
  [[nodiscard]] double crab_angle() const noexcept { return alpha_; }
  /// Sense of the turn; ccw when straight.
  [[nodiscard]] Turn turn() const noexcept { return k_ < 0.0 ? Turn::cw : Turn::ccw; }

  /// ρ, in [0, 1].
  [[nodiscard]] double rho() const noexcept { return rho_; }
  /// k, in [−1, 1].
  [[nodiscard]] double k() const noexcept { return k_; }

  friend bool operator==(const Heading&, const Heading&) = default;

 private:
  Heading(double rho, double k, double alpha) noexcept : rho_(rho), k_(k), alpha_(alpha) {}

  double rho_, k_;
  double alpha_;
  bool moving_ = true;
};

}  // namespace hexagait::heading_control
