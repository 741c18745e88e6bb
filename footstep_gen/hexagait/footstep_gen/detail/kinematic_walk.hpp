// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <hexagait/footstep_gen/walker.hpp>
#include <testing/control_period.hpp>
#include <testing/kinematic_plant.hpp>
#include <vector>

// For tests of the walker.

namespace hexagait::footstep_gen {

/// Rule 1 in its own words: who stands beside whom, for n legs in two rows.
inline bool are_neighbours(LegId a, LegId b, int n) {
  const bool same_side = a % 2 == b % 2, same_pair = a / 2 == b / 2;
  const bool end_pair = a / 2 == 0 || a / 2 == n / 2 - 1;
  return same_side ? std::abs(a - b) == 2 : same_pair && end_pair;
}

struct Lift {
  double time;
  LegId leg;
};

/// A walker in the kinematic world, and who lifted when. A value.
struct KinematicWalk {
  Walker walker;
  testing::KinematicPlant plant;
  std::vector<Lift> lifts;
  LegArray<double> longest_wait;  ///< between two lifts of a leg [s]
  LegArray<double> last_lift;

  explicit KinematicWalk(const RobotModel& model, double spread = 0.8, std::uint32_t trial = 0,
                         const WalkerParams& params = {})
      : walker(model, params),
        plant(model, spread, {.seed = 11, .stream = RandomStream::posture, .trial = trial}),
        longest_wait(model.num_legs(), 0.0),
        last_lift(model.num_legs(), 0.0) {
    walker.start(plant.measurement);
  }

  const TickRecord& tick(const heading_control::Heading& heading) {
    const LegArray<LegLane> before = walker.record().legs;
    const TickRecord& record = walker.tick(PlantStatus::fresh, plant.measurement, heading);
    check_rule_1(before, record);
    plant.follow(record, hexagait::testing::kDt);
    for (LegId i = 0; i < before.size(); ++i) {
      if (record.lifts.contains(i)) {
        lifts.push_back({record.state.time, i});
        last_lift[i] = record.state.time;
      }
      longest_wait[i] = std::max(longest_wait[i], record.state.time - last_lift[i]);
    }
    return record;
  }

  void walk(const heading_control::Heading& heading, double seconds) {
    for (int k = 0; k < std::lround(seconds / hexagait::testing::kDt); ++k) tick(heading);
  }

  /// No leg lifts beside one that doesn't stand, nor together with a neighbour; and at no time are
  /// two neighbours off the ground.
  void check_rule_1(const LegArray<LegLane>& before, const TickRecord& record) const {
    ASSERT_EQ(record.fault, Fault::none);
    ASSERT_TRUE(record.rule1_violations.empty());
    const auto stands = [&](const LegLane& lane) {
      return lane.phase == LegPhase::support &&
             lane.without_contact <= walker.params().executor.swing.lost_time;
    };
    for (LegId a = 0; a < before.size(); ++a) {
      for (LegId b = 0; b < before.size(); ++b) {
        if (!are_neighbours(a, b, before.size())) continue;
        ASSERT_TRUE(stands(record.legs[a]) || stands(record.legs[b])) << a << " and " << b;
        if (!record.lifts.contains(a)) continue;
        ASSERT_TRUE(stands(before[b])) << a << " lifts beside " << b;
        ASSERT_FALSE(record.lifts.contains(b)) << a << " lifts with " << b;
      }
    }
  }

  double odometry_error() const { return (walker.record().state.X_OB.p - plant.X_OB.p).norm(); }
  Vector2 place() const { return plant.X_OB.p.head<2>(); }
};

}  // namespace hexagait::footstep_gen
