// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/params/robot_params.hpp>
#include <limits>

namespace hexagait::testing {

inline void round_steps(RobotParams& p) {
  p.step.stroke = 0.20;
  p.step.height = 0.10;
  p.step.level_height = 0.5;
  p.step.haste = 1.4;
  p.step.descent = 1.5;
  p.step.touchdown = 2.5;
  p.step.max_height = 0.22;
  p.step.stability_margin = 0.03;
  p.step.lift_margin = 0.06;

  p.swing.unload_time = 0.04;
  p.swing.load_time = 0.02;
  p.swing.even_load_rate = 20.0;
  p.swing.lift_time = 0.20;
  p.swing.max_rise = std::numeric_limits<double>::infinity();
  p.swing.transfer_time = 0.38;
  p.swing.max_speed = 2.0;
  p.swing.hasty_speed = 2.75;
  p.swing.overlap_time = 0.10;
  p.swing.descent_speed = 0.30;
  p.swing.touchdown_speed = 0.08;
  p.swing.touchdown_margin = 0.006;
  p.swing.search_speed = 0.15;
  p.swing.vertical_acceleration = 6.0;
  p.swing.commit_height = 0.03;
  p.swing.retreat_back = 0.03;
  p.swing.retreat_up = 0.05;
  p.swing.blocked_error = 0.008;
  p.swing.retreat_time = 0.15;
  p.swing.touch_time = 0.01;
  p.swing.confirm_time = 0.02;
  p.swing.lost_time = 0.03;
  p.swing.regain_time = 0.06;
  p.swing.slide_distance = 0.002;
  p.swing.slide_time = 0.1;
  p.swing.slide_patience = 1.0;
  p.swing.search_time = 1.5;
  p.swing.follow_rate = 10.0;
  p.swing.effort_time = 0.1;
  p.swing.lag_speed = 0.3;
}

inline void round_body(RobotParams& p) {
  p.base.acceleration = 1.2;
  p.base.braking_distance = 0.002;
  p.base.max_speed = 0.60;
  p.base.advance_rate = 8.0;
  p.base.correction_rate = 2.0;
  p.base.correction_speed = 0.05;
  p.base.correction_turn = 0.10;
  p.base.posture_rate = 2.0;
  p.base.height_speed = 0.15;
  p.base.tilt_speed = 0.3;
  p.base.outer_radius = 0.8;
  p.base.displacement_period = 0.0;

  p.spring.frequency = 12.5;
  p.spring.turn_frequency = 12.5;

  p.tolerance.tie = 0.001;
  p.tolerance.slide = 0.001;
  p.tolerance.in_a_row = 0.001;
  p.tolerance.sliding_in_a_row = 0.22;
  p.tolerance.turn_arm = 0.5;
  p.tolerance.level_time = 4.0;
  p.tolerance.servo_stiffness = 8.0;
  p.tolerance.gravity_time = 0.5;
  p.tolerance.tilt_time = 5.0;
}

inline void round_script(RobotParams& p) {
  p.script.profile_height = 0.08;
  p.script.footstep_speed = 0.65;
  p.script.foot_speed = 0.3;
  p.script.joint_speed = 1.0;
  p.script.leg_mode_time = 0.5;
  p.script.auto_speed = 0.2;
  p.script.auto_turn = 0.28;
  p.script.base_speed = 0.05;
  p.script.base_turn = 0.1;
  p.script.support_margin = 0.04;
  p.script.lift_off_speed = 0.1;
  p.script.touchdown_speed = 0.2;
  p.script.footstep_time = 0.45;
  p.script.swing_tolerance = 1e-3;
  p.script.swing_braking = 15.0;
  p.script.target_time = 0.05;
  p.script.base_auto_time = 0.1;
  p.script.base_target_time = 0.7;
  p.script.pause_time = 0.2;
  p.script.reach_time = 0.2;
  p.script.regain_limit = 5.0;
  p.script.near_plan = 0.03;
  p.script.height_lost = 0.05;
  p.script.narrow_margin = 0.01;
}

inline void round_plant_and_referee(RobotParams& p) {
  p.plant.longest_step = 0.002;
  p.plant.servo_kp = 4000.0;
  p.plant.servo_kd = 100.0;
  p.plant.servo_kv = 1000.0;
  p.plant.servo_friction = 1.0;
  p.plant.contact_threshold = 5.0;
  p.plant.contact_cfm = 1e-5;
  p.plant.contact_correcting_speed = 0.5;
  p.plant.hinge_cfm = 1e-8;
  p.plant.start_clearance = 1e-4;

  p.referee.bounce = 0.05;
  p.referee.settling = 0.02;
  p.referee.brief_loss = 0.02;
  p.referee.near_loss = 0.005;
  p.referee.fall_speed = 0.6;
  p.referee.progress = 0.05;
  p.referee.patience = 10.0;
}

/// Parameters for tests that compute with them: round numbers, fit for a robot of 1 m and 50 kg.
inline RobotParams round_params() {
  RobotParams p;
  round_steps(p);
  round_body(p);
  round_script(p);
  round_plant_and_referee(p);
  return p;
}

/// The same of an executor.
inline ExecutorParams round_executor() {
  ExecutorParams params;
  params.swing = round_params().swing;
  params.swing.max_rise = kDerived;
  params.base = round_params().base;
  return params;
}

/// The same of a simulated world.
template <class WorldParams>
WorldParams round_world() {
  WorldParams params;
  static_cast<PlantParams&>(params) = round_params().plant;
  params.physics_dt = params.control_dt = 0.002;
  return params;
}

}  // namespace hexagait::testing
