// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/params/detail/step_shape.hpp>
#include <hexagait/params/params_for.hpp>

namespace hexagait {
namespace {

using namespace detail;
using P = RobotParams;
using enum ScaleOf;

constexpr double kDescent = 1.5;    // of the speed of descents, on rough ground
constexpr double kTouchdown = 2.5;  // of the speed of touchdowns, on rough ground

constexpr Parameter kParameters[] = {
    {"step.stroke", "m", kStroke, reach, [](P& p) -> double& { return p.step.stroke; }},
    {"step.height", "m", kHeight, reach, [](P& p) -> double& { return p.step.height; }},
    {"step.level_height", "1", 0.5, none, [](P& p) -> double& { return p.step.level_height; }},
    {"step.haste", "1", kHaste, none, [](P& p) -> double& { return p.step.haste; }},
    {"step.descent", "1", kDescent, none, [](P& p) -> double& { return p.step.descent; }},
    {"step.touchdown", "1", kTouchdown, none, [](P& p) -> double& { return p.step.touchdown; }},
    {"step.max_height", "m", 1.0, reach, [](P& p) -> double& { return p.step.max_height; }},
    {"step.stability_margin", "m", 0.03, size,
     [](P& p) -> double& { return p.step.stability_margin; }},
    {"step.lift_margin", "m", 0.06, size, [](P& p) -> double& { return p.step.lift_margin; }},

    {"swing.unload_time", "s", 0.125, time, [](P& p) -> double& { return p.swing.unload_time; }},
    {"swing.load_time", "s", 0.0625, time, [](P& p) -> double& { return p.swing.load_time; }},
    {"swing.even_load_rate", "1/s", 6.45, rate,
     [](P& p) -> double& { return p.swing.even_load_rate; }},
    {"swing.lift_time", "s", kLiftTime, time, [](P& p) -> double& { return p.swing.lift_time; }},
    {"swing.max_rise", "m/s", 0.96, joint_rise, [](P& p) -> double& { return p.swing.max_rise; }},
    {"swing.transfer_time", "s", kTransferTime, time,
     [](P& p) -> double& { return p.swing.transfer_time; }},
    {"swing.max_speed", "m/s", 1.0, swing_speed, [](P& p) -> double& { return p.swing.max_speed; }},
    {"swing.hasty_speed", "m/s", 1.0, hasty_speed,
     [](P& p) -> double& { return p.swing.hasty_speed; }},
    {"swing.overlap_time", "s", 0.31, time, [](P& p) -> double& { return p.swing.overlap_time; }},
    {"swing.descent_speed", "m/s", kDescentSpeed, speed,
     [](P& p) -> double& { return p.swing.descent_speed; }},
    {"swing.touchdown_speed", "m/s", 0.117, speed,
     [](P& p) -> double& { return p.swing.touchdown_speed; }},
    {"swing.touchdown_margin", "m", 0.027, reach,
     [](P& p) -> double& { return p.swing.touchdown_margin; }},
    {"swing.search_speed", "m/s", 0.22, speed,
     [](P& p) -> double& { return p.swing.search_speed; }},
    {"swing.vertical_acceleration", "m/s²", 2.84, acceleration,
     [](P& p) -> double& { return p.swing.vertical_acceleration; }},
    {"swing.commit_height", "m", 0.136, reach,
     [](P& p) -> double& { return p.swing.commit_height; }},
    {"swing.retreat_back", "m", 0.136, reach, [](P& p) -> double& { return p.swing.retreat_back; }},
    {"swing.retreat_up", "m", 0.227, reach, [](P& p) -> double& { return p.swing.retreat_up; }},
    {"swing.blocked_error", "m", 0.0364, reach,
     [](P& p) -> double& { return p.swing.blocked_error; }},
    {"swing.retreat_time", "s", 0.465, time, [](P& p) -> double& { return p.swing.retreat_time; }},
    {"swing.touch_time", "s", 0.01, none, [](P& p) -> double& { return p.swing.touch_time; }},
    {"swing.confirm_time", "s", 0.02, none, [](P& p) -> double& { return p.swing.confirm_time; }},
    {"swing.lost_time", "s", 0.03, none, [](P& p) -> double& { return p.swing.lost_time; }},
    {"swing.regain_time", "s", 0.06, none, [](P& p) -> double& { return p.swing.regain_time; }},
    {"swing.slide_distance", "m", 0.0091, reach,
     [](P& p) -> double& { return p.swing.slide_distance; }},
    {"swing.slide_time", "s", 0.31, time, [](P& p) -> double& { return p.swing.slide_time; }},
    {"swing.slide_patience", "s", 3.1, time,
     [](P& p) -> double& { return p.swing.slide_patience; }},
    {"swing.search_time", "s", 4.65, time, [](P& p) -> double& { return p.swing.search_time; }},
    {"swing.follow_rate", "1/s", 3.2, rate, [](P& p) -> double& { return p.swing.follow_rate; }},
    {"swing.effort_time", "s", 0.31, time, [](P& p) -> double& { return p.swing.effort_time; }},
    {"swing.lag_speed", "m/s", 0.44, speed, [](P& p) -> double& { return p.swing.lag_speed; }},

    {"base.acceleration", "m/s²", 0.036, tipping,
     [](P& p) -> double& { return p.base.acceleration; }},
    {"base.braking_distance", "m", 0.002, size,
     [](P& p) -> double& { return p.base.braking_distance; }},
    {"base.max_speed", "m/s", 0.88, speed, [](P& p) -> double& { return p.base.max_speed; }},
    {"base.advance_rate", "1/s", 2.6, rate, [](P& p) -> double& { return p.base.advance_rate; }},
    {"base.correction_rate", "1/s", 0.65, rate,
     [](P& p) -> double& { return p.base.correction_rate; }},
    {"base.correction_speed", "m/s", 0.073, speed,
     [](P& p) -> double& { return p.base.correction_speed; }},
    {"base.correction_turn", "rad/s", 0.032, rate,
     [](P& p) -> double& { return p.base.correction_turn; }},
    {"base.posture_rate", "1/s", 0.65, rate, [](P& p) -> double& { return p.base.posture_rate; }},
    {"base.height_speed", "m/s", 0.22, speed, [](P& p) -> double& { return p.base.height_speed; }},
    {"base.tilt_speed", "rad/s", 0.097, rate, [](P& p) -> double& { return p.base.tilt_speed; }},
    {"base.outer_radius", "m", 1.0, outer, [](P& p) -> double& { return p.base.outer_radius; }},
    {"base.displacement_period", "s", 0.0, none,
     [](P& p) -> double& { return p.base.displacement_period; }},

    {"spring.frequency", "rad/s", 4.03, step_rate,
     [](P& p) -> double& { return p.spring.frequency; }},
    {"spring.turn_frequency", "rad/s", 4.03, step_rate,
     [](P& p) -> double& { return p.spring.turn_frequency; }},

    {"gait.tie_tolerance", "m", 0.0045, reach, [](P& p) -> double& { return p.tolerance.tie; }},
    {"tolerance.slide", "m", 0.0045, reach, [](P& p) -> double& { return p.tolerance.slide; }},
    {"tolerance.in_a_row", "m", 0.001, size, [](P& p) -> double& { return p.tolerance.in_a_row; }},
    {"tolerance.sliding_in_a_row", "m", 1.0, reach,
     [](P& p) -> double& { return p.tolerance.sliding_in_a_row; }},
    {"tolerance.turn_arm", "m", 0.5, size, [](P& p) -> double& { return p.tolerance.turn_arm; }},
    {"tolerance.tilt_time", "s", 15.5, time, [](P& p) -> double& { return p.tolerance.tilt_time; }},
    {"tolerance.level_time", "s", 12.0, time,
     [](P& p) -> double& { return p.tolerance.level_time; }},
    {"tolerance.servo_stiffness", "m", 8.0, size,
     [](P& p) -> double& { return p.tolerance.servo_stiffness; }},
    {"tolerance.gravity_time", "s", 1.55, time,
     [](P& p) -> double& { return p.tolerance.gravity_time; }},

    {"script.profile_height", "m", 0.364, reach,
     [](P& p) -> double& { return p.script.profile_height; }},
    {"script.footstep_speed", "m/s", 0.953, speed,
     [](P& p) -> double& { return p.script.footstep_speed; }},
    {"script.foot_speed", "m/s", 0.44, speed, [](P& p) -> double& { return p.script.foot_speed; }},
    {"script.joint_speed", "rad/s", 0.3225, rate,
     [](P& p) -> double& { return p.script.joint_speed; }},
    {"script.leg_mode_time", "s", 1.55, time,
     [](P& p) -> double& { return p.script.leg_mode_time; }},
    {"script.auto_speed", "m/s", 0.293, speed, [](P& p) -> double& { return p.script.auto_speed; }},
    {"script.auto_turn", "rad/s", 0.09, rate, [](P& p) -> double& { return p.script.auto_turn; }},
    {"script.base_speed", "m/s", 0.0733, speed,
     [](P& p) -> double& { return p.script.base_speed; }},
    {"script.base_turn", "rad/s", 0.0323, rate, [](P& p) -> double& { return p.script.base_turn; }},
    {"script.support_margin", "m", 0.133, height,
     [](P& p) -> double& { return p.script.support_margin; }},
    {"script.lift_off_speed", "m/s", 0.147, speed,
     [](P& p) -> double& { return p.script.lift_off_speed; }},
    {"script.touchdown_speed", "m/s", 0.293, speed,
     [](P& p) -> double& { return p.script.touchdown_speed; }},
    {"script.footstep_time", "s", 1.395, time,
     [](P& p) -> double& { return p.script.footstep_time; }},
    {"script.swing_tolerance", "m", 0.00455, reach,
     [](P& p) -> double& { return p.script.swing_tolerance; }},
    {"script.swing_braking", "m/s²", 7.1, acceleration,
     [](P& p) -> double& { return p.script.swing_braking; }},
    {"script.target_time", "s", 0.155, time, [](P& p) -> double& { return p.script.target_time; }},
    {"script.base_auto_time", "s", 0.31, time,
     [](P& p) -> double& { return p.script.base_auto_time; }},
    {"script.base_target_time", "s", 2.17, time,
     [](P& p) -> double& { return p.script.base_target_time; }},
    {"script.pause_time", "s", 0.62, time, [](P& p) -> double& { return p.script.pause_time; }},
    {"script.reach_time", "s", 0.62, time, [](P& p) -> double& { return p.script.reach_time; }},
    {"script.regain_limit", "s", 15.5, time, [](P& p) -> double& { return p.script.regain_limit; }},
    {"script.near_plan", "m", 0.03, size, [](P& p) -> double& { return p.script.near_plan; }},
    {"script.height_lost", "m", 0.05, size, [](P& p) -> double& { return p.script.height_lost; }},
    {"script.narrow_margin", "m", 0.01, size,
     [](P& p) -> double& { return p.script.narrow_margin; }},

    {"plant.longest_step", "s", 0.00625, step_time,
     [](P& p) -> double& { return p.plant.longest_step; }},
    {"plant.servo_kp", "N m/rad", 8.0, stiffness, [](P& p) -> double& { return p.plant.servo_kp; }},
    {"plant.servo_kd", "N m s/rad", 0.62, damping,
     [](P& p) -> double& { return p.plant.servo_kd; }},
    {"plant.servo_kv", "N m s/rad", 6.2, damping, [](P& p) -> double& { return p.plant.servo_kv; }},
    {"plant.servo_friction", "N m s/rad", 0.0062, damping,
     [](P& p) -> double& { return p.plant.servo_friction; }},
    {"plant.contact_threshold", "N", 0.06, foot_load,
     [](P& p) -> double& { return p.plant.contact_threshold; }},
    {"plant.contact_cfm", "m/(N s)", 1.55e-3, mobility,
     [](P& p) -> double& { return p.plant.contact_cfm; }},
    {"plant.contact_correcting_speed", "m/s", 0.158, free_speed,
     [](P& p) -> double& { return p.plant.contact_correcting_speed; }},
    {"plant.hinge_cfm", "m/(N s)", 1.55e-6, mobility,
     [](P& p) -> double& { return p.plant.hinge_cfm; }},
    {"plant.start_clearance", "m", 1e-4, size,
     [](P& p) -> double& { return p.plant.start_clearance; }},

    {"referee.bounce", "s", 0.155, step_time, [](P& p) -> double& { return p.referee.bounce; }},
    {"referee.settling", "s", 0.062, step_time, [](P& p) -> double& { return p.referee.settling; }},
    {"referee.brief_loss", "s", 0.062, step_time,
     [](P& p) -> double& { return p.referee.brief_loss; }},
    {"referee.near_loss", "m", 0.0225, reach, [](P& p) -> double& { return p.referee.near_loss; }},
    {"referee.fall_speed", "m/s", 0.19, free_speed,
     [](P& p) -> double& { return p.referee.fall_speed; }},
    {"referee.progress", "m", 0.227, reach, [](P& p) -> double& { return p.referee.progress; }},
    {"referee.patience", "s", 31.0, time, [](P& p) -> double& { return p.referee.patience; }},
};

}  // namespace

std::span<const Parameter> parameters() { return kParameters; }

RobotParams params_for(const RobotModel& model, double gravity) {
  const RobotScale scale = scale_of(model, gravity);
  RobotParams params;
  for (const Parameter& one : kParameters) one.in(params) = one.factor * measure(one.of, scale);
  return params;
}

RobotParams none_derived() {
  RobotParams params;
  for (const Parameter& one : kParameters) one.in(params) = 0.0;
  return params;
}

RobotParams completed(RobotParams params, const RobotModel& model, double gravity) {
  const auto open = [&params](const Parameter& one) { return is_derived(one.in(params)); };
  if (std::ranges::none_of(kParameters, open)) return params;
  RobotParams derived = params_for(model, gravity);
  for (const Parameter& one : kParameters)
    if (open(one)) one.in(params) = one.in(derived);
  return params;
}

}  // namespace hexagait
