// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/sim2d/genghis_controller.hpp>

namespace hexagait::sim2d {
namespace {

constexpr double kArrived = 1e-3;      // this near is there [m]
constexpr double kExpectedStep = 1.0;  // duration of a step until one has been seen [s]
constexpr int kFrontEdge = 0;          // of the ring, between the two front legs

// As fast as allowed, and braking in time, towards something that is `distance` away.
double speed_towards(double distance, double speed, double acceleration) {
  const double braking = std::sqrt(2.0 * acceleration * std::abs(distance));
  return std::copysign(std::min(speed, braking), distance);
}

double slewed(double value, double goal, double most) {
  return value + std::clamp(goal - value, -most, most);
}

// The line through the footprints relative to the workspace centres.
struct Line {
  double height = 0.0, slope = 0.0;
};

}  // namespace

GenghisController::GenghisController(const GenghisModel& model, const GenghisParams& params)
    : model_(model),
      params_(params),
      sense_of_motion_(params.backward ? -1.0 : 1.0),
      memory_(kGenghisLegs, kExpectedStep) {}

void GenghisController::start(const GenghisMeasurement& measurement) {
  *this = GenghisController(model_, params_);
  record_.measurement = measurement;
  record_.feet = LegArray<Vector2>(kGenghisLegs, Vector2::Zero());
  record_.legs = LegArray<GenghisLeg>(kGenghisLegs);
  record_.gait_input = {LegArray<double>(kGenghisLegs, 0.0), LegSet(), LegSet()};
  record_.targets = {measurement.q, LegArray<GenghisJoints>(kGenghisLegs)};
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    GenghisLeg& leg = record_.legs[i];
    leg.p = leg.print = record_.feet[i] = foot_position(model_, i, measurement.q[i]);
  }
}

const GenghisRecord& GenghisController::tick(const GenghisMeasurement& measurement) noexcept {
  sense(measurement);  // joints and loads: where the feet are, and who stands
  decide();            // gait state: who steps
  adapt();             // how the body moves as a reaction to the legs
  step();              // legs in the air, and their reflexes
  command();           // joint targets
  return record_;
}

void GenghisController::sense(const GenghisMeasurement& measurement) noexcept {
  record_.measurement = measurement;
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    record_.feet[i] = foot_position(model_, i, measurement.q[i]);
    GenghisLeg& leg = record_.legs[i];
    leg.touched_down = leg.lost = leg.blocked = leg.searched = false;
    const double load = measurement.load[i];
    if (leg.phase == LegPhase::descend && load > params_.touchdown_load) {
      leg.touched_down = true;
      leg.phase = LegPhase::support;
      leg.print = leg.p;
      leg.shortened = leg.clock = 0.0;
    } else if (leg.phase == LegPhase::support) {
      leg.print = leg.p;
      leg.clock = load < params_.lost_load ? leg.clock + params_.control_dt : 0.0;
      if (leg.clock <= params_.lost_time) continue;
      leg.lost = true;
      leg.phase = LegPhase::descend;
      leg.clock = 0.0;
    }
  }
}

void GenghisController::decide() noexcept {
  const LegSet standing = support();
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    record_.gait_input.lag[i] = -ahead(i);
    record_.gait_input.airborne.set(i, !standing.contains(i));
    record_.gait_input.urgent.set(i, -ahead(i) > params_.urgent_share * reach_behind(i));
  }
  record_.decision = gait_state::decide(
      memory_, record_.gait_input,
      {.time = record_.measurement.time, .rear_edge = params_.backward ? kFrontEdge : -1},
      {.tie_tolerance = params_.tie_tolerance, .adjustment = params_.gait.adjustment},
      params_.gait.stepper);
  for (LegId i = 0; i < kGenghisLegs; ++i)
    if (record_.decision.lifts.contains(i)) lift(i);
}

// [PC04] 4 along a straight line: support legs move back until the lags of all legs, those in the
// air included, sum to zero.
void GenghisController::adapt() noexcept {
  const LegSet standing = support();
  const double n = std::max(1, standing.size());
  double sum = 0.0, sum_to_come = 0.0, moved = 0.0, room = model_.workspace_radius;
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    const bool stands = standing.contains(i);
    sum += ahead(i);
    moved += moves_with_ground(i) ? 1.0 : 0.0;
    sum_to_come += stands ? ahead(i) : params_.half_stroke;
    if (stands) room = std::min(room, params_.usable_share * reach_behind(i) + ahead(i));
  }
  record_.advance_goal = standing.empty() ? 0.0 : std::min(sum / moved, std::max(0.0, room));
  record_.to_come = std::max(0.0, sum_to_come / n);

  const double goal = sense_of_motion_ * speed_towards(record_.advance_goal, params_.body_speed,
                                                       0.8 * params_.body_acceleration);
  const double most = params_.body_acceleration * params_.control_dt;
  record_.v_body.x() = slewed(record_.v_body.x(), goal, most);
  adapt_height_and_pitch();
}

// Parallel to the ground: towards the line through the footprints, those of legs in the air too.
void GenghisController::adapt_height_and_pitch() noexcept {
  double mean_x = 0.0, mean_z = 0.0, xx = 0.0, xz = 0.0;
  for (const GenghisLeg& leg : record_.legs) mean_x += leg.print.x() / kGenghisLegs;
  for (const GenghisLeg& leg : record_.legs)
    mean_z += (leg.print.y() + model_.stance_height) / kGenghisLegs;
  for (const GenghisLeg& leg : record_.legs) {
    const double x = leg.print.x() - mean_x;
    xx += x * x;
    xz += x * (leg.print.y() + model_.stance_height - mean_z);
  }
  const Line line{mean_z, xx > 0.0 ? xz / xx : 0.0};

  const auto limited = [&](double error, double speed) {
    return std::clamp(params_.posture_rate * error, -speed, speed);
  };
  double pitch_rate = limited(line.slope, params_.pitch_speed);
  const double pitch = record_.measurement.pitch;
  if (std::abs(pitch) > params_.max_pitch && pitch * pitch_rate > 0.0) pitch_rate = 0.0;
  const double vertical = limited(line.height, params_.vertical_speed);

  // As much of it as every support leg can follow.
  for (const auto& [z, turn] : {std::pair(1.0, 1.0), {1.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}}) {
    record_.v_body.y() = z * vertical;
    record_.pitch_rate = turn * pitch_rate;
    if (within_reach()) break;
  }
}

void GenghisController::step() noexcept {
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    GenghisLeg& leg = record_.legs[i];
    const double dt = params_.control_dt;
    leg.print += ground_velocity(leg.print) * dt;
    if (leg.phase == LegPhase::support) {
      leg.v = ground_velocity(leg.p);
    } else {
      const Vector2 wanted = swing_velocity(i);
      const double most = params_.swing_acceleration * dt;
      leg.v = {slewed(leg.v.x(), wanted.x(), most), slewed(leg.v.y(), wanted.y(), most)};
    }
    leg.p += leg.v * dt;
    leg.p.y() = std::clamp(leg.p.y(), lowest(model_, i, leg.p.x()), highest(model_, i, leg.p.x()));
  }
}

void GenghisController::command() noexcept {
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    const GenghisJoints before = record_.targets.q[i];
    const GenghisJoints q = joints_for(model_, i, record_.legs[i].p);
    record_.targets.q[i] = q;
    record_.targets.q_dot[i] = {(q.swing - before.swing) / params_.control_dt,
                                (q.lift - before.lift) / params_.control_dt};
  }
}

LegSet GenghisController::support() const noexcept {
  LegSet legs;
  for (LegId i = 0; i < kGenghisLegs; ++i) legs.set(i, record_.legs[i].phase == LegPhase::support);
  return legs;
}

// How far a foot is ahead of its workspace centre, along the command: −δ of [PC04] 3.3.
double GenghisController::ahead(LegId leg) const noexcept {
  return sense_of_motion_ * (record_.legs[leg].p.x() - centre(model_, leg).x());
}

// Feet that stand, and those that rise or descend straight over their spot. A descending foot does
// so until it would come down behind its AEP.
bool GenghisController::moves_with_ground(LegId leg) const noexcept {
  const GenghisLeg& l = record_.legs[leg];
  if (l.phase == LegPhase::descend) return ahead(leg) > params_.half_stroke - l.shortened;
  return l.phase == LegPhase::support || l.phase == LegPhase::raise;
}

// How far behind its centre a foot may be: by its workspace, and at this height by its leg.
double GenghisController::reach_behind(LegId leg) const noexcept {
  const double z = record_.legs[leg].p.y(), l = model_.leg_length;
  const double hip_to_foot = z < 0.0 ? std::sqrt(std::max(0.0, l * l - z * z)) : l;
  const double hip_ahead = sense_of_motion_ * (hip(model_, leg) - centre(model_, leg)).x();
  return std::min(model_.workspace_radius, hip_to_foot - hip_ahead);
}

// Of a point that is fixed to the ground, while the body moves as it does.
Vector2 GenghisController::ground_velocity(const Vector2& p) const noexcept {
  const double w = record_.pitch_rate;
  return -record_.v_body - w * Vector2(-p.y(), p.x());
}

// Can every support leg follow the body to the next tick? Getting nearer to its reach is allowed.
bool GenghisController::within_reach() const noexcept {
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    if (record_.legs[i].phase != LegPhase::support) continue;
    const Vector2& p = record_.legs[i].p;
    const Vector2 next = p + ground_velocity(p) * params_.control_dt;
    const double below = lowest(model_, i, next.x()) - next.y();
    const double above = next.y() - highest(model_, i, next.x());
    if ((below > 0.0 && next.y() < p.y()) || (above > 0.0 && next.y() > p.y())) return false;
  }
  return true;
}

void GenghisController::lift(LegId i) noexcept {
  GenghisLeg& leg = record_.legs[i];
  double highest_print = leg.print.y();
  for (const GenghisLeg& other : record_.legs)
    highest_print = std::max(highest_print, other.print.y());
  leg.phase = LegPhase::raise;
  leg.height = params_.clearance + params_.roughness_gain * (highest_print - leg.print.y());
  leg.clock = 0.0;
}

Vector2 GenghisController::swing_velocity(LegId i) noexcept {
  GenghisLeg& leg = record_.legs[i];
  const Vector2 ground = ground_velocity(leg.p);
  const double floor = lowest(model_, i, leg.p.x());
  const double top = std::min(leg.print.y() + leg.height, highest(model_, i, leg.p.x()));
  const double up = speed_towards(top - leg.p.y(), params_.raise_speed, params_.swing_acceleration);
  switch (leg.phase) {
    case LegPhase::raise:
      if (top - leg.p.y() < kArrived) leg.phase = LegPhase::advance;
      return ground + Vector2(0.0, up);
    case LegPhase::advance:
      return Vector2(0.0, ground.y() + up) + advance_velocity(i);
    case LegPhase::retreat: {
      const double back = leg.back_to - leg.p.x();
      if (std::abs(back) < kArrived && top - leg.p.y() < kArrived) leg.phase = LegPhase::advance;
      return {speed_towards(back, params_.advance_speed, 0.5 * params_.swing_acceleration),
              ground.y() + up};
    }
    default:
      if (leg.p.y() < floor + kArrived) search(leg, floor);
      return {moves_with_ground(i) ? ground.x() : 0.0, ground.y() - params_.descent_speed};
  }
}

// Forward to the AEP, and the reflex of an advance that has run into something.
Vector2 GenghisController::advance_velocity(LegId i) noexcept {
  GenghisLeg& leg = record_.legs[i];
  const double x = centre(model_, i).x() +
                   sense_of_motion_ * (params_.half_stroke + record_.to_come - leg.shortened);
  const double distance = x - leg.p.x();
  const double behind = leg.p.x() - record_.feet[i].x();
  if (sense_of_motion_ * behind > params_.blocked_error) {
    leg.blocked = true;
    leg.phase = LegPhase::retreat;
    leg.back_to = record_.feet[i].x() - sense_of_motion_ * params_.retreat;
    leg.print.y() = std::max(leg.print.y(), record_.feet[i].y());  // so high is the ground ahead
    leg.height = params_.raise_more;
  } else if (std::abs(distance) < kArrived) {
    leg.phase = LegPhase::descend;
  }
  return {speed_towards(distance, params_.advance_speed, 0.5 * params_.swing_acceleration), 0.0};
}

// No ground within reach. It is presumed to be lower, and the body comes down as a reaction; if
// that does not help in time, a foothold nearer to the body is tried.
void GenghisController::search(GenghisLeg& leg, double floor) const noexcept {
  leg.print.y() = floor - params_.presumed_drop;
  leg.clock += params_.control_dt;
  if (leg.clock < params_.patience) return;
  leg.searched = true;
  leg.phase = LegPhase::raise;
  leg.print.y() = floor;
  leg.height = params_.clearance;
  leg.clock = 0.0;
  leg.shortened += params_.search_step;
  if (leg.shortened > 2.0 * params_.half_stroke) leg.shortened = 0.0;
}

}  // namespace hexagait::sim2d
