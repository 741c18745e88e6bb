// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/footstep_gen/rear_edge.hpp>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/gait_state/ring.hpp>

namespace hexagait::footstep_gen {

namespace {

// Without contact sensors: a foot touches down where the ground was expected.
bool planned_contact(const LegLane& lane, const Pose& X_OB) {
  switch (lane.phase) {
    case LegPhase::support:
    case LegPhase::unload:
      return true;
    case LegPhase::descend:
      return (X_OB * lane.p_BF).z() <= lane.step.p_OT.z();
    default:
      return false;
  }
}

bool valid(const Measurement& measurement, int num_legs) {
  bool finite = std::isfinite(measurement.time);
  for (const LegJoints& q : measurement.q) finite = finite && q.allFinite();
  return finite && measurement.q.size() == num_legs && measurement.contact.size() == num_legs;
}

}  // namespace

const char* to_string(Fault fault) noexcept {
  switch (fault) {
    case Fault::none:
      return "none";
    case Fault::bad_measurement:
      return "bad measurement";
    case Fault::plant_late:
      return "plant late";
    case Fault::plant_closed:
      return "plant closed";
    case Fault::emergency_stop:
      return "emergency stop";
  }
  return "?";
}

Walker::Walker(const RobotModel& model, const WalkerParams& params)
    : model_(&model),
      params_(params),
      workspaces_(heading_control::workspaces(model)),
      odometry_(model),
      stepper_(model.num_legs(), nominal_step_time(params.executor.swing, params.step)),
      executor_(model, params.executor) {}

const TickRecord& Walker::tick(PlantStatus status, const Measurement& measurement,
                               const heading_control::Heading& heading) noexcept {
  record_.lifts = record_.waits = record_.rule1_violations = LegSet();
  if (!healthy(status, measurement)) return record_;
  sense();         // what the joints and contacts say: feet, odometry
  steer(heading);  // (r, α) → arc, and how far off the commanded curve we are
  decide();        // gait state: who may step; stepper: who does
  command();       // Footstep and BaseAuto
  execute();       // Free Gait core: set points, joint targets
  ++ticks_;
  return record_;
}

void Walker::start(const Measurement& measurement) {
  if (!valid(measurement, model_->num_legs()))
    throw InvalidInput(
        "Walker::start: the measurement must have a finite position for every joint of " +
        model_->name);
  *this = Walker(*model_, params_);
  RobotState& state = record_.state;
  record_.measurement = measurement;
  state.time = measurement.time;
  state.q = measurement.q;
  state.contact = LegArray<bool>(model_->num_legs(), true);
  state.trig = LegArray<LegTrig>(model_->num_legs());
  state.p_BF = LegArray<Vector3>(model_->num_legs());
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    state.trig[i] = leg_trig(model_->legs[i], state.q[i]);
    state.p_BF[i] = foot_position(model_->legs[i], state.trig[i]);
  }
  odometry_.reset(state);
  executor_.reset(state);
  record_.targets = executor_.targets();
  record_.legs = executor_.legs();
  record_.footsteps = LegArray<Footstep>(model_->num_legs());
  tracker_.reset({0.0, Vector2::Zero()});
  record_.heading = heading_control::Heading::stop();
  record_.arc = path_arc(record_.heading, workspaces_);
  record_.rear_edge = rear_edge(record_.arc, gait_state::hindmost_edge(model_->num_legs()));
}

// Bad input ends here: nothing behind it ever sees a number that is not finite.
bool Walker::healthy(PlantStatus status, const Measurement& measurement) noexcept {
  if (record_.fault != Fault::none) return false;
  if (status == PlantStatus::closed) return stop(Fault::plant_closed), false;
  if (status == PlantStatus::late) {
    silence_ += params_.control_dt;
    record_.holding = true;
    executor_.hold();
    record_.targets = executor_.targets();
    if (silence_ > params_.late_limit) stop(Fault::plant_late);
    return false;
  }
  if (!valid(measurement, model_->num_legs())) return stop(Fault::bad_measurement), false;
  silence_ = 0.0;
  record_.holding = false;
  record_.measurement = measurement;
  return true;
}

void Walker::sense() noexcept {
  RobotState& state = record_.state;
  const Measurement& measured = record_.measurement;
  state.time = measured.time;
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    const LegLane& lane = executor_.legs()[i];
    state.q[i] = params_.sensors.joint_feedback ? measured.q[i] : executor_.targets().q[i];
    state.trig[i] = leg_trig(model_->legs[i], state.q[i]);
    state.p_BF[i] = foot_position(model_->legs[i], state.trig[i]);
    state.contact[i] =
        params_.sensors.foot_contacts ? measured.contact[i] : planned_contact(lane, state.X_OB);
  }
  odometry_.update(state, executor_.footing(), params_.control_dt);
}

void Walker::steer(const heading_control::Heading& heading) noexcept {
  if (!(heading == record_.heading)) {
    record_.heading = heading;
    record_.arc = path_arc(heading, workspaces_);
    record_.rear_edge = rear_edge(record_.arc, record_.rear_edge);
    tracker_.follow(record_.arc.per_metre);
  }
  const Pose& X_OB = record_.state.X_OB;
  record_.deviation = tracker_.update({std::atan2(X_OB.R(1, 0), X_OB.R(0, 0)), X_OB.p.head<2>()});
}

void Walker::decide() noexcept {
  record_.gait_input = gait_input(*model_, record_.arc, executor_, params_.step);
  record_.gait = latch_.update(record_.gait_input, params_.gait);

  // Who is told to stand may not step, but steps under way still end.
  const LegSet may_step = record_.heading.moving() ? record_.gait.may_step : LegSet();
  record_.lifts = stepper_.update({.time = time(),
                                   .airborne = record_.gait_input.airborne,
                                   .may_step = may_step,
                                   .rear_edge = record_.rear_edge},
                                  params_.stepper);
  record_.waits = LegSet(may_step.bits() & ~record_.lifts.bits());
}

void Walker::command() noexcept {
  const bool walks = record_.heading.moving();
  const double half_step = walks ? 0.5 * params_.step.stroke : 0.0;
  record_.path_to_come = path_to_come(record_.arc, executor_, half_step);

  for (LegId i = 0; i < model_->num_legs(); ++i) {
    const bool in_air = executor_.legs()[i].phase != LegPhase::support;
    const bool lifts = record_.lifts.contains(i);
    if (!in_air && !lifts) continue;
    record_.footsteps[i] = footstep(*model_, record_.arc, record_.state, i, half_step,
                                    share_to_come(i) * record_.path_to_come, params_.step);
    executor_.command(record_.footsteps[i], record_.state);
    if (lifts && neighbour_off_ground(i)) record_.rule1_violations.insert(i);
  }
  record_.base_auto = base_auto(*model_, record_.arc, executor_, record_.deviation, params_.step);
  executor_.command(record_.base_auto);
}

// The legs of a wave land one after the other. When this one does, the base will have made as much
// of its way as this leg's time left is of that of the leg that lands last.
double Walker::share_to_come(LegId leg) const noexcept {
  if (params_.stepper.stepping != gait_state::Stepping::wave) return 1.0;
  const double last_lift = *std::max_element(stepper_.lifted_at.begin(), stepper_.lifted_at.end());
  const double last_left = last_lift + stepper_.longest_step() - time();
  const double left = last_left - (last_lift - stepper_.lifted_at[leg]);
  return left > 0.0 ? left / last_left : 0.0;
}

bool Walker::neighbour_off_ground(LegId leg) const noexcept {
  const gait_state::Neighbours n = gait_state::neighbours_of(leg, model_->num_legs());
  const LegSet support = executor_.support();
  return !support.contains(n.before) || !support.contains(n.after);
}

void Walker::execute() noexcept {
  record_.targets = executor_.advance(record_.state, params_.control_dt);
  record_.base_goal = executor_.base_goal();
  record_.base = executor_.base();
  record_.legs = executor_.legs();
}

void Walker::stop(Fault fault) noexcept {
  record_.fault = fault;
  executor_.hold();
  record_.targets = executor_.targets();
}

}  // namespace hexagait::footstep_gen
