// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <hexagait/executor/leg_lane.hpp>
#include <limits>
#include <testing/control_period.hpp>
#include <testing/round_params.hpp>

/// One lane, and a world for its foot.
namespace hexagait::testing {

inline const Pose kBody{rotation_z(0.7), {1.0, -2.0, 0.3}};  // at rest in odom

/// A lane under a body at rest. The foot goes where it is told, but not below the floor; whether it touches something
/// there is up to the test: at first the ground z = 0.
struct Swing {
  SwingParams params = testing::round_params().swing;
  LegLane lane;
  std::function<bool(const Vector3&)> touches = [](const Vector3& p_OF) { return p_OF.z() <= 0.0; };
  bool reachable = true;
  double floor = -std::numeric_limits<double>::infinity();  ///< the foot gets no lower [m]
  bool blocked = false;  ///< the leg is held by something that its foot does not feel

  explicit Swing(const Vector3& start_O = {1.3, -1.6, 0.0}) {
    lane.p_BF = kBody.inverse() * start_O;
    lane.time = 1.0;  // it stands there for a while already
  }
  Vector3 foot() const { return kBody * lane.p_BF; }
  void command(const Vector3& target_O) { hexagait::command(lane, {0, target_O, 0.1}, kBody); }
  void tick() {
    const LegSensed sensed{.contact = touches(foot()),
                           .tracking_error = blocked ? 2.0 * params.blocked_error : 0.0,
                           .reachable = reachable,
                           .off = {0.0, 0.0, std::max(0.0, floor - foot().z())}};
    sense(lane, sensed.contact, kDt, params);
    advance(lane, sensed, kBody, kDt, params);
  }

  /// Until it stands again, at most three seconds; calls `watch` after each tick.
  template <class Watch>
  void land(Watch watch) {
    for (int k = 0; k < 1500; ++k) {
      tick();
      watch();
      if (lane.phase == LegPhase::support) return;
    }
    ADD_FAILURE() << "still " << to_string(lane.phase);
  }
  void land() {
    land([] {});
  }
  void until(LegPhase phase) {
    for (int k = 0; k < 1500 && lane.phase != phase; ++k) tick();
    ASSERT_EQ(lane.phase, phase);
  }
};

inline constexpr double kStride = 0.35;  // [m]
inline const Vector3 kStart(1.3, -1.6, 0.0);
inline const Vector3 kTarget = kStart + Vector3(0.28, 0.21, 0.0);

/// Way from the start towards the target [m].
inline double ahead(const Vector3& p_OF) {
  return (p_OF - kStart).dot((kTarget - kStart) / kStride);
}

inline double planar_distance(const Vector3& a, const Vector3& b) {
  return (a - b).head<2>().norm();
}

}  // namespace hexagait::testing
