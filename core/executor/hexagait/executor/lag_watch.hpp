// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait {

/// How far feet are from where their drives would have them: what is beyond the lag of the drives is
/// an obstacle.
///
/// Every drive follows its target late: by the time constant of its controller, and by delays. So a
/// foot is expected on the way from where a drive with the lag τ would have it,
///
///     τ ṗ_τ = p* − p_τ                                                                   (lag 1)
///
/// to its set point p*, and the error is its distance from that line. τ is estimated from feet that
/// move: each lags behind its set point by τ v, so
///
///     τ̂ ← mean of (p* − p) · v / v²  over some tenths of a second of motion, at most kLongest  (lag 2)
///
/// of all legs together. One foot that is blocked moves this mean little; its set point goes on, and
/// the line with it, so it is found at most τ̂ + error/v later than by a drive without lag.
///
/// τ̂ starts at kLongest: until drives have shown that they are prompt, they are taken for slow. The least lag
///
///     τ̌ ← mean of the same samples, over a few seconds of motion while it rises           (lag 3)
///
/// starts at 0, for what must not take prompt drives for slow: neither the start of a walk nor a foot that is
/// blocked for a moment raises it much.
class LagWatch {
 public:
  /// @param moving  slower set points say nothing about the lag [m/s]
  explicit LagWatch(int legs = 0, double moving = 0.0);

  /// Takes foot and set point, of the same instant, in the body frame [m].
  /// @param swings  the foot is in the air
  void watch(LegId leg, const Vector3& p, const Vector3& set_point, bool swings,
             double dt) noexcept;

  /// The same without a measurement.
  void go_on(LegId leg, const Vector3& set_point, double dt) noexcept;

  /// Starts with a foot at its set point.
  void restart(LegId leg, const Vector3& set_point) noexcept;

  /// Of a foot in the air; 0 for one that stands [m].
  [[nodiscard]] double error(LegId leg) const { return error_[leg]; }
  [[nodiscard]] double lag() const { return lag_; }          ///< τ̂ [s]
  [[nodiscard]] double least_lag() const { return least_; }  ///< τ̌ [s]

 private:
  LegArray<Vector3> before_;   ///< set points of the last tick [m]
  LegArray<Vector3> lagging_;  ///< p_τ [m]
  LegArray<double> error_;     ///< [m]
  double moving_;              ///< [m/s]
  double lag_;
  double least_ = 0.0;
};

}  // namespace hexagait
