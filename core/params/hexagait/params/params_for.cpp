// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <hexagait/params/params_for.hpp>

namespace hexagait {
namespace {

constexpr double kStroke = 0.91, kHeight = 0.45;  // of ℓ
constexpr double kSidewaysSpeed = 2.93;           // over the ground, of ℓ/T
constexpr double kBodySpeed = 0.33;               // which the body has then, of ℓ/T
constexpr double kTransferTime = 1.18;            // of T
constexpr double kDescentSpeed = 0.44;            // of ℓ/T
constexpr double kLiftTime = 0.62;                // of T
constexpr double kRisePeak = 1.875;               // minimum jerk: peak over mean speed
constexpr double kDisc = 0.55;                    // radius of the swing's volume, of the stroke
constexpr double kDip = 0.3;                      // its depth below the ground, of the height
constexpr double kSpeedShare = 0.9;               // of the joints' greatest speeds
constexpr double kHaste = 1.4;                    // of swings on level ground
constexpr double kDescent = 1.5;                  // of the speed of descents, on rough ground
constexpr double kTouchdown = 2.5;                // of the speed of touchdowns, on rough ground

struct FootSpeed {
  double sideways = std::numeric_limits<double>::infinity();  // [m/s]
  double upwards = std::numeric_limits<double>::infinity();   // [m/s]
};

// Speeds of the foot, in any direction of the plane and upwards, that no joint is too slow for.
FootSpeed foot_speed(const LegModel& leg, const LegTrig& trig) {
  const LegJacobian J = foot_jacobian(leg, trig);
  const Matrix3 JJt = J * J.transpose();
  if (!(std::abs(JJt.determinant()) > 0.0)) return {0.0, 0.0};
  const Eigen::Matrix<double, kMaxLegJoints, 3> inverse = J.transpose() * JJt.inverse();
  FootSpeed speed;
  for (int k = 0; k < leg.num_joints(); ++k) {
    const double limit = leg.limits[k].velocity;
    const double across = inverse.row(k).head<2>().norm(), up = std::abs(inverse(k, 2));
    if (across > 0.0) speed.sideways = std::min(speed.sideways, limit / across);
    if (up > 0.0) speed.upwards = std::min(speed.upwards, limit / up);
  }
  return speed;
}

// Of a leg of two joints: fore and aft, and upwards. What is across follows, and is no choice.
FootSpeed foot_speed_of_two(const LegModel& leg, const LegTrig& trig) {
  const Eigen::Matrix2d J = (leg.X_BH.R.transpose() * foot_jacobian(leg, trig)).block<2, 2>(1, 0);
  if (!(std::abs(J.determinant()) > 0.0)) return {0.0, 0.0};
  const Eigen::Matrix2d inverse = J.inverse();
  FootSpeed speed;
  for (int k = 0; k < 2; ++k) {
    const double limit = leg.limits[k].velocity;
    speed.sideways = std::min(speed.sideways, limit / std::abs(inverse(k, 0)));
    speed.upwards = std::min(speed.upwards, limit / std::abs(inverse(k, 1)));
  }
  return speed;
}

FootSpeed speed_at(const LegModel& leg, const LegSolution& solution) {
  return leg.has_two_joints() ? foot_speed_of_two(leg, solution.trig)
                              : foot_speed(leg, solution.trig);
}

bool carries(const LegModel& leg, const LegSolution& solution, double load, double gravity) {
  const LegJoints effort = standing_effort(leg, solution, load, gravity);
  for (int k = 0; k < leg.num_joints(); ++k)
    if (std::abs(effort[k]) > leg.limits[k].effort) return false;
  return true;
}

// The speeds throughout the volume of a swing of reach ℓ; 0 if a part of it is out of reach, or the leg can't
// carry its load [N] all along its stroke.
FootSpeed speed_in_volume(const LegModel& leg, double reach, double load, double gravity) {
  constexpr int kDirections = 8;
  const double height = kHeight * reach, radius = kDisc * kStroke * reach;
  FootSpeed least;
  for (const double z : {-kDip * height, 0.0, height}) {
    for (int k = 0; k <= kDirections; ++k) {
      Vector3 offset(0.0, 0.0, z);
      if (k > 0) offset.head<2>() = radius * unit_vector(2.0 * std::numbers::pi * k / kDirections);
      const LegSolution solution = inverse_kinematics(leg, leg.p_BC + offset);
      if (!solution.reachable) return {0.0, 0.0};
      if (z == 0.0 && !carries(leg, solution, load, gravity)) return {0.0, 0.0};
      const FootSpeed speed = speed_at(leg, solution);
      least.sideways = std::min(least.sideways, speed.sideways);
      least.upwards = std::min(least.upwards, speed.upwards);
    }
  }
  return least;
}

FootSpeed speed_in_volumes(const RobotModel& model, double reach, double gravity) {
  FootSpeed least;
  const double load = standing_load(model, gravity);
  for (const LegModel& leg : model.legs) {
    const FootSpeed speed = speed_in_volume(leg, reach, load, gravity);
    least = {std::min(least.sideways, speed.sideways), std::min(least.upwards, speed.upwards)};
  }
  return least;
}

// Sideways over the workspaces' centres, from the ground to the apex.
double crossing_speed(const RobotModel& model, double height) {
  double least = std::numeric_limits<double>::infinity();
  for (const LegModel& leg : model.legs) {
    for (const double z : {0.0, height}) {
      const LegSolution solution = inverse_kinematics(leg, leg.p_BC + Vector3(0.0, 0.0, z));
      least = std::min(least, solution.reachable ? speed_at(leg, solution).sideways : 0.0);
    }
  }
  return least;
}

double size_of(const RobotModel& model) {
  Vector2 least = model.legs[0].p_BC.head<2>(), most = least;
  for (const LegModel& leg : model.legs) {
    least = least.cwiseMin(leg.p_BC.head<2>());
    most = most.cwiseMax(leg.p_BC.head<2>());
  }
  return 0.5 * (most - least).sum();
}

// ℓ of λ = 1: within the workspaces, small against the stance, and clear of the neighbours' discs.
double longest_reach(const RobotModel& model, double size) {
  double reach = 0.22 * size;
  for (LegId i = 0; i < model.num_legs(); ++i) {
    reach = std::min(reach, model.legs[i].workspace_radius);
    for (LegId j = 0; j < i; ++j)
      reach = std::min(reach, 0.45 * (model.legs[i].p_BC - model.legs[j].p_BC).head<2>().norm());
  }
  return reach;
}

// s: the least factor of √(L/g) with which the joints move the feet at these speeds [ℓ/T].
double stretch(const RobotScale& scale, double across, double up) {
  if (!(scale.sideways > 0.0)) return 1.0;
  const double unit = scale.reach / scale.free_time;
  return std::max({1.0, across * unit / (kSpeedShare * scale.sideways),
                   up * unit / (kSpeedShare * scale.upwards)});
}

using P = RobotParams;
using enum ScaleOf;

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
    {"base.braking_distance", "m", 0.005, size,
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

RobotScale scale_of(const RobotModel& model, double gravity) {
  RobotScale scale;
  scale.legs = model.num_legs();
  scale.gravity = gravity;
  scale.weight = model.mass * gravity;
  scale.size = size_of(model);
  scale.free_time = std::sqrt(scale.size / gravity);

  // In steps of 5 %; a leg without any volume around its foot has a tenth.
  constexpr int kSteps = 20, kLeast = 2;
  const double longest = longest_reach(model, scale.size);
  FootSpeed speed;
  for (int k = kSteps; k >= kLeast; --k) {
    scale.room = static_cast<double>(k) / kSteps;
    scale.reach = scale.room * longest;
    speed = speed_in_volumes(model, scale.reach, gravity);
    if (speed.sideways > 0.0) break;
  }
  scale.sideways = speed.sideways;
  scale.upwards = speed.upwards;
  scale.crossing = crossing_speed(model, kHeight * scale.reach);

  const double across = kRisePeak * kStroke / kTransferTime - kBodySpeed;
  scale.time = stretch(scale, across, kDescentSpeed) * scale.free_time;

  for (const LegModel& leg : model.legs) {
    scale.outer = std::max(scale.outer, leg.p_BC.head<2>().norm());
    scale.hip_height -= leg.p_BC.z() / model.num_legs();
  }
  return scale;
}

double pace_of(const RobotScale& scale) {
  const double across = kSidewaysSpeed - kBodySpeed, up = kRisePeak * kHeight / kLiftTime;
  return scale.reach / (stretch(scale, across, up) * scale.free_time);
}

double measure(ScaleOf of, const RobotScale& s) {
  switch (of) {
    case none:
      return 1.0;
    case size:
      return s.size;
    case height:
      return s.hip_height;
    case reach:
      return s.reach;
    case time:
      return s.time;
    case speed:
      return s.reach / s.time;
    case acceleration:
      return s.reach / (s.time * s.time);
    case rate:
      return 1.0 / s.time;
    case tipping:
      return s.gravity * s.size / s.hip_height;
    case outer:
      return s.outer + 0.5 * s.reach;
    case step_time:
      return s.free_time;
    case step_rate:
      return 1.0 / s.free_time;
    case foot_load:
      return s.weight / s.legs;
    case stiffness:
      return s.weight * s.size;
    case damping:
      return s.weight * s.size * s.free_time;
    case mobility:
      return s.size / s.free_time / s.weight;
    case free_speed:
      return s.size / s.free_time;
    case joint_rise:
      return s.upwards;
    case swing_speed:
      return std::min(kSidewaysSpeed * (s.reach / s.time),
                      kSpeedShare * s.sideways + kBodySpeed * (s.reach / s.time));
    case hasty_speed:
      return std::min(kHaste * kSidewaysSpeed * (s.reach / s.time),
                      kSpeedShare * s.crossing + kHaste * kBodySpeed * (s.reach / s.time));
  }
  return 1.0;
}

const char* symbol(ScaleOf of) {
  switch (of) {
    case none:
      return "";
    case size:
      return "L";
    case height:
      return "h";
    case reach:
      return "ℓ";
    case time:
      return "T";
    case speed:
      return "ℓ/T";
    case acceleration:
      return "ℓ/T²";
    case rate:
      return "1/T";
    case tipping:
      return "g L/h";
    case outer:
      return "(c + ℓ/2)";
    case step_time:
      return "√(L/g)";
    case step_rate:
      return "√(g/L)";
    case foot_load:
      return "m g/n";
    case stiffness:
      return "m g L";
    case damping:
      return "m g L √(L/g)";
    case mobility:
      return "√(g L)/(m g)";
    case free_speed:
      return "√(g L)";
    case joint_rise:
      return "v↑";
    case swing_speed:
      return "min(2.93 ℓ/T, 0.9 v→ + 0.33 ℓ/T)";
    case hasty_speed:
      return "min(4.10 ℓ/T, 0.9 v⇒ + 0.46 ℓ/T)";
  }
  return "";
}

std::span<const Parameter> parameters() { return kParameters; }

double standing_load(const RobotModel& model, double gravity) {
  return model.mass * gravity / std::max(2, model.num_legs() / 2 - 1);
}

LegJoints standing_effort(const LegModel& leg, const LegSolution& solution, double load,
                          double gravity) {
  return leg_weight(leg, solution.q, {0.0, 0.0, gravity}).effort -
         foot_jacobian(leg, solution.trig).transpose() * Vector3(0.0, 0.0, load);
}

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
