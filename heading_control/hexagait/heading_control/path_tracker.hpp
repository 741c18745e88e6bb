// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/planar.hpp>

namespace hexagait::heading_control {

/// Where the base should be on the commanded curve, and how far off it is.
///
/// A heading command (r, α) held for a while asks for a curve: from the pose at which it was given,
///
///     X(s) = X_anchor · exp(V s)            V: unit motion per metre of path           (tracker 1)
///
/// an arc, a straight line or a turn in place. The ideal pose is the point of the curve nearest to
/// the base in the metric |shift|² + L² angle². The next command's curve starts at the ideal end of
/// this one, so that errors are not forgiven by steering.
/// [PC04] leaves this out: its simulated feet don't slip. A value.
class PathTracker {
 public:
  /// Starts at a pose in odom, with no path: every later deviation is from there.
  void reset(const PlanarPose& X_OB);

  /// A new curve from the ideal pose of now.
  void follow(const PlanarTwist& per_metre);

  /// Advances the ideal pose to the point nearest to the base.
  /// @returns the base's deviation, as the twist from the base to the ideal pose, in the body frame
  ///          [m, rad]: what is to be corrected
  PlanarTwist update(const PlanarPose& X_OB) noexcept;

  [[nodiscard]] PlanarPose ideal() const { return ideal_; }
  /// Path length along the present curve [m].
  [[nodiscard]] double progress() const { return s_; }

 private:
  PlanarPose anchor_;
  PlanarTwist per_metre_;
  double s_ = 0.0;
  PlanarPose ideal_;
};

}  // namespace hexagait::heading_control
