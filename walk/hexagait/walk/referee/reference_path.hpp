// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/heading_control/heading.hpp>
#include <hexagait/math/planar.hpp>

namespace hexagait::walk {

/// The commanded curve in the world, for the referee: uses the true pose and shares no code with
/// the controller's path tracker.
///
/// The first curve starts at the true pose of the base. Each later one starts at the ideal pose at
/// that time: the point of the previous curve nearest to the base's true origin. The ideal heading
/// at a point is the tangent minus the crab angle. In a turn in place the ideal position is where
/// the turn began, and the ideal heading is the base's own.
class ReferencePath {
 public:
  struct Deviation {
    double lateral = 0.0;   ///< distance of the base's origin from the curve, > 0 to its left [m]
    double heading = 0.0;   ///< true minus ideal heading [rad]; 0 in a turn in place
    double progress = 0.0;  ///< along this curve since its start [m]; 0 in a turn in place
    double turned = 0.0;    ///< angle turned since its start [rad]
  };

  explicit ReferencePath(const PlanarPose& X_WB) : ideal_(X_WB), start_(X_WB), last_(X_WB) {}

  /// Starts a new curve; the base is at the pose last passed to deviation().
  void follow(const heading_control::Heading& heading);

  /// Where the base is relative to the curve.
  Deviation deviation(const PlanarPose& X_WB);

  /// The ideal pose at the last deviation().
  [[nodiscard]] const PlanarPose& ideal() const { return ideal_; }

 private:
  PlanarPose ideal_, start_, last_;
  double curvature_ = 0.0;  ///< of the base's path, signed [1/m]; infinite for a turn in place
  double crab_ = 0.0;
  bool moving_ = false;
  double angle_ = 0.0;  ///< unwrapped angle along an arc [rad]
};

}  // namespace hexagait::walk
