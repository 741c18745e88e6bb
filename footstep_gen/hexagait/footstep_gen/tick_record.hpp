// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/footstep_gen/deadlock.hpp>
#include <hexagait/footstep_gen/leg_watch.hpp>
#include <hexagait/footstep_gen/lift_gate.hpp>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/heading_control/heading.hpp>
#include <hexagait/heading_control/path_arc.hpp>
#include <hexagait/plant/plant_watch.hpp>
#include <hexagait/plant/robot_state.hpp>

namespace hexagait::footstep_gen {

using hexagait::Fault;
using hexagait::to_string;

/// Everything that one tick computes, by stage and in the order of the stages: the format of logs
/// and traces, and the answer to "why does leg 3 not step?".
struct TickRecord {
  // plant, odometry
  Measurement measurement;    ///< of the plant
  Fault fault = Fault::none;  ///< unless none, the stages below were skipped
  bool holding = false;       ///< the measurement is late: the robot holds still
  RobotState state;           ///< joints, feet, odometry
  bool very_rough = false;    ///< the ground of late: the free gait is a wave, (step 8)
  LegSet lost;                ///< legs that it does without
  LegFindings findings;       ///< what it has found out about its legs and their sensors
  bool refuses = false;       ///< it does not walk, since too few legs are left

  // heading_control
  heading_control::Heading heading = heading_control::Heading::stop();  ///< the command
  heading_control::PathArc arc;  ///< the path of the command for this robot
  PlanarTwist deviation;         ///< displacement back to the commanded curve [m, rad]

  Escape escape;  ///< from a deadlock

  // gait_state
  gait_state::GaitInput gait_input;
  gait_state::GaitDecision gait;
  int rear_edge = 0;        ///< ring edge between the rear legs of this heading
  LegSet lifts;             ///< legs commanded to lift in this tick
  LegSet waits;             ///< legs that may step but wait: (gait 5), or for their tripod's turn
  LegSet rule1_violations;  ///< legs that lift while a neighbour lifts or is not in support

  // footstep_gen
  LiftGateDecision gate;                ///< of robots that crawl; sway in the body frame
  double path_to_come = 0.0;            ///< advance until all airborne feet have landed [m of path]
  LegArray<FootstepCommand> footsteps;  ///< last command of each leg
  BaseAutoCommand base_auto;

  // executor
  BaseGoal base_goal;
  BaseLane base;
  LegArray<LegLane> legs;
  JointTargets targets;
};

}  // namespace hexagait::footstep_gen
