// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/planar.hpp>

namespace hexagait::heading_control {

/// The ideal pose of the base on the commanded curve, and the deviation from it.
///
/// A heading (r, α) that is held defines a curve from the pose at which it was given,
///
///     X(s) = X_anchor · exp(V s)            V: twist per metre of path                 (tracker 1)
///
/// an arc, a straight line or a turn on the spot. The ideal pose is the point of the curve nearest
/// to the base in the metric |shift|² + L² angle². The curve of the next command starts at the
/// ideal pose of this one, so that steering does not hide errors. [PC04] has no such correction:
/// its simulated feet do not slip. A value.
class PathTracker {
 public:
  /// @param turn_arm  L: about the distance from the base to its feet, so that an angle counts as
  ///                  much as the motion of the feet that it causes [m]
  explicit PathTracker(double turn_arm = 0.0) : turn_arm_(turn_arm) {}

  /// Starts at a pose in odom, without a path: the ideal pose stays there.
  void reset(const PlanarPose& X_OB);

  /// Starts a new curve at the present ideal pose.
  void follow(const PlanarTwist& per_metre);

  /// Advances the ideal pose to the point nearest to the base.
  /// @returns the correction: the displacement from the base to the ideal pose, as a twist in the
  ///          body frame [m, rad]
  PlanarTwist update(const PlanarPose& X_OB) noexcept;

  [[nodiscard]] PlanarPose ideal() const { return ideal_; }
  /// Path length of the ideal pose along the present curve [m].
  [[nodiscard]] double progress() const { return s_; }

 private:
  [[nodiscard]] double product(const PlanarTwist& a, const PlanarTwist& b) const noexcept;

  double turn_arm_;
  PlanarPose anchor_;
  PlanarTwist per_metre_;
  double s_ = 0.0;
  PlanarPose ideal_;
};

/// A correction for a robot that can't move sideways, as with legs of two joints: it turns towards
/// its path instead, by the angle under which it sees the path's point that is `arm` ahead of it.
/// What it is off along its path stays. In a turn on the spot it can only correct its heading.
/// @param correction  of PathTracker::update()
/// @param per_metre   twist of the commanded path
/// @param arm         [m], greater than 0
[[nodiscard]] PlanarTwist by_turning(const PlanarTwist& correction, const PlanarTwist& per_metre,
                                     double arm) noexcept;

}  // namespace hexagait::heading_control
