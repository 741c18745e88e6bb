// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/walk/referee/referee.hpp>
#include <testing/control_period.hpp>
#include <testing/round_params.hpp>

namespace hexagait::walk {

/// A walk made by hand: six legs in support, feet on a rectangle, the body at rest above it. The
/// tests change what they are about and tick.
struct HandMadeWalk {
  RobotModel model;
  GroundTruth truth;
  footstep_gen::TickRecord record;
  Referee referee;

  explicit HandMadeWalk(const PlanarPose& start = {})
      : model(six_legs()),
        truth(standing(start)),
        referee(model, truth, testing::kDt, testing::round_params().referee) {
    record.heading = heading_control::Heading::straight(0.0);
    record.legs = LegArray<LegLane>(6);
    record.measurement.q = LegArray<LegJoints>(6, LegJoints::Zero());
  }

  static double side(LegId leg) { return leg % 2 == 0 ? 0.5 : -0.5; }

  static RobotModel six_legs() {
    RobotModel model;
    model.legs = LegArray<LegModel>(6);
    for (LegId i = 0; i < 6; ++i) model.legs[i].p_BC = {0.4 * (1 - i / 2), side(i), -0.3};
    return model;
  }

  static GroundTruth standing(const PlanarPose& start) {
    GroundTruth truth;
    truth.X_WB = {rotation_z(start.angle), {start.shift.x(), start.shift.y(), 0.3}};
    truth.feet = LegArray<FootTruth>(6);
    for (LegId i = 0; i < 6; ++i) {
      truth.feet[i].p_WF = {0.4 * (1 - i / 2), side(i), 0.02};
      truth.feet[i].in_contact = true;
    }
    return truth;
  }

  void tick(int times = 1) {
    for (int k = 0; k < times; ++k) {
      truth.time += testing::kDt;
      referee.observe(record, truth);
      record.lifts = LegSet();
      for (LegLane& lane : record.legs) lane.touched_down = false;
    }
  }

  void lift(LegId leg) {
    record.lifts.insert(leg);
    record.legs[leg].phase = LegPhase::lift;
    truth.feet[leg].in_contact = false;
  }
  void land(LegId leg) {
    record.legs[leg].phase = LegPhase::support;
    record.legs[leg].touched_down = true;
    truth.feet[leg].in_contact = true;
  }
};

}  // namespace hexagait::walk
