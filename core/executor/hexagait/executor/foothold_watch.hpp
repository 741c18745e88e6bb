// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/leg_lane.hpp>

namespace hexagait {

/// Which footholds give way. A foot that has touched down on an edge stands at first; then it rolls or
/// slides off, slowly, and falls once the legs beside it have lifted. Odometry sees it slide by s
/// (RobotState::slide_O); s̄ follows it with the time constant T = slide_time, and the foothold gives
/// way as long as the foot is ahead of it by more than slide_distance:
///
///     T ds̄/dt = s − s̄,   |s − s̄| > slide_distance                                  (foothold 1)
///
/// So a foot that slides steadily at speed v is found if T v > slide_distance, and one that has moved
/// once and stands again is forgotten. A foothold gives way for slide_patience in all: after that the
/// robot walks on, as on ice or loose ground, where all feet slide.
class FootholdWatch {
 public:
  explicit FootholdWatch(int legs = 0)
      : ahead_O_(legs, Vector3::Zero()), before_O_(legs, Vector3::Zero()), waited_(legs, 0.0) {}

  /// @param slide_O  what each foot has slid, in odom [m]; no legs: none is known to slide
  /// @param stand    legs whose foothold counts; of the others, it begins anew
  /// @param dt       control period [s]
  void watch(const LegArray<Vector3>& slide_O, LegSet stand, double dt,
             const SwingParams& params) noexcept;

  [[nodiscard]] LegSet giving_way() const { return giving_way_; }
  /// Legs whose foothold gives way although it was waited for: they are to leave it.
  [[nodiscard]] LegSet bad() const { return bad_; }

 private:
  LegArray<Vector3> ahead_O_;   ///< s − s̄ [m]
  LegArray<Vector3> before_O_;  ///< s, a tick ago [m]
  LegArray<double> waited_;     ///< how long each foothold has given way in all [s]
  LegSet giving_way_, bad_;
};

}  // namespace hexagait
