// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/heading_control/heading.hpp>
#include <hexagait/heading_control/path_arc.hpp>
#include <hexagait/plant/plant_watch.hpp>
#include <hexagait/plant/robot_state.hpp>

namespace hexagait::footstep_gen {

using hexagait::Fault;
using hexagait::to_string;

/// Everything that one tick computed, by the stage that computed it and in the order of the stages.
/// Log, replay, viewer and "why does leg 3 not step?" are all this struct.
struct TickRecord {
  // plant → sense
  Measurement measurement;    ///< as the plant gave it
  Fault fault = Fault::none;  ///< not none: the stages below were skipped
  bool holding = false;       ///< the measurement is late: all stands still
  RobotState state;           ///< joints, feet, odometry

  // heading_control
  heading_control::Heading heading = heading_control::Heading::stop();  ///< the command
  heading_control::PathArc arc;  ///< the command, bound to this robot's workspaces
  PlanarTwist deviation;         ///< from the base back to the commanded curve [m, rad]

  // gait_state
  gait_state::GaitInput gait_input;
  gait_state::GaitDecision gait;
  int rear_edge = 0;  ///< ring edge between the rear legs, for this heading
  LegSet lifts;       ///< legs commanded to lift in this tick
  LegSet waits;       ///< legs that may step and are held back: (gait 5), or the tripod's turn
  LegSet rule1_violations;  ///< legs that lift with a neighbour that lifts or is not in support

  // footstep_gen
  double path_to_come = 0.0;     ///< advance still to come when all airborne feet stand [m of path]
  LegArray<Footstep> footsteps;  ///< the last one of each leg
  BaseAuto base_auto;

  // core
  BaseGoal base_goal;
  BaseLane base;
  LegArray<LegLane> legs;
  JointTargets targets;
};

}  // namespace hexagait::footstep_gen
