// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/heading_control/heading.hpp>
#include <hexagait/math/planar.hpp>

namespace hexagait::walk {

/// The curve that was commanded, drawn on the true ground: the referee's, so it shares no code with
/// the controller's tracker and knows the true pose.
///
/// Anchored once, at the true pose of the first command; each later arc starts at the ideal end of
/// the one before, which is the point of its curve nearest to the base's true origin. The ideal
/// heading at a point is the curve's tangent less the crab angle; during a turn in place it is the
/// base's own, and the ideal place is where the turn began.
class ReferencePath {
 public:
  struct Deviation {
    double lateral =
        0.0;  ///< distance of the base's origin from the curve [m], positive to its left
    double heading = 0.0;   ///< true less ideal heading [rad]; 0 in a turn in place
    double progress = 0.0;  ///< along this curve since its start [m]; of a turn in place, 0
    double turned = 0.0;    ///< angle turned since its start [rad]
  };

  explicit ReferencePath(const PlanarPose& X_WB) : ideal_(X_WB), start_(X_WB), last_(X_WB) {}

  /// A new command, given while the base is at the pose last passed to deviation().
  void follow(const heading_control::Heading& heading);

  /// Where the base is, seen from the curve.
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
