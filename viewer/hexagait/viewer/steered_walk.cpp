// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/gait_state/gait_state.hpp>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/viewer/steered_walk.hpp>
#include <hexagait/walk/referee.hpp>
#include <hexagait/walk/trial.hpp>
#include <limits>

namespace hexagait::viewer {
namespace {

constexpr double kSettle = 0.3;     // time to come to rest on the feet [s]
constexpr double kSmoothing = 0.4;  // time constant of speed and power as shown [s]
constexpr double kPushTime = 0.2;   // [s]
constexpr double kPushSpeed = 1.5;  // [m/s]

sim3d::WorldParams world_params_at(const recording::Simulation& simulation,
                                   const PlanarPose& start) {
  sim3d::WorldParams params = recording::world_params(simulation);
  params.start = start;
  return params;
}

bool lies(const Pose& X_WB) { return X_WB.R(2, 2) < portable::cos(walk::kFallTilt); }

}  // namespace

LegArray<LegJoints> posture_on(const sim3d::Terrain& terrain, const RobotModel& robot,
                               const WalkStart& start) {
  LegArray<LegJoints> q = walk::random_posture(robot, start.spread, start.draw);
  LegArray<Vector3> p_BF(robot.num_legs());
  LegArray<double> ground(robot.num_legs());
  double mean = 0.0;
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    p_BF[i] = foot_position(robot.legs[i], q[i]);
    const Vector2 p_W = start.X_WB * Vector2(p_BF[i].head<2>());
    ground[i] = terrain.height_at(p_W.x(), p_W.y());
    mean += ground[i] / robot.num_legs();
  }
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    p_BF[i].z() += ground[i] - mean;
    q[i] = inverse_kinematics(robot.legs[i], p_BF[i], q[i]).q;
  }
  return q;
}

SteeredWalk::SteeredWalk(const RobotModel& robot, const recording::Simulation& simulation,
                         const WalkStart& start)
    : robot_(robot),
      simulation_(simulation),
      world_(with_loads(robot_, simulation.plant.parts), simulation.terrain,
             world_params_at(simulation, start.X_WB),
             posture_on(sim3d::Terrain(simulation.terrain, simulation.seed), robot_, start)),
      broken_(world_, resolved(simulation.plant.parts, robot_), recording::body_of(world_),
              simulation.control_dt, kSettle, simulation.seed),
      plant_(broken_, robot_, simulation.plant.faults, simulation.control_dt, simulation.seed),
      walker_(robot_, recording::walker_params(simulation)),
      path_(start.X_WB) {
  settle();
}

void SteeredWalk::settle() {
  status_ = plant_.read(measurement_);
  walker_.start(measurement_);
  const auto stop = heading_control::Heading::stop();
  for (double t = 0.0; t < kSettle; t += control_dt()) {
    plant_.write(walker_.tick(status_, measurement_, stop).targets);
    status_ = plant_.read(measurement_);
  }
  walker_.start(measurement_);
  last_place_ = place();
  last_q_ = measurement_.q;
  path_ = walk::ReferencePath(last_place_);
}

void SteeredWalk::tick(const heading_control::HeadingCommand& command) {
  const footstep_gen::TickRecord& record = walker_.tick(status_, measurement_, command);
  plant_.write(record.targets);
  status_ = plant_.read(measurement_);
  ++ticks_;
  if (!(command.heading == followed_)) path_.follow(followed_ = command.heading);
  observe();
}

void SteeredWalk::observe() {
  const GroundTruth& truth = world_.truth();
  const double dt = control_dt(), share = dt / kSmoothing;
  const PlanarPose now = place(), step = between(last_place_, now);
  velocity_.v += share * (step.shift / dt - velocity_.v);
  velocity_.w += share * (wrap_angle(step.angle) / dt - velocity_.w);
  way_ += step.shift.norm();
  deviation_ = path_.deviation(now);

  double power = 0.0;
  for (LegId i = 0; i < robot_.num_legs(); ++i)
    power += world_.efforts()[i].cwiseProduct(measurement_.q[i] - last_q_[i]).cwiseAbs().sum() / dt;
  power_ += share * (power - power_);
  last_place_ = now;
  last_q_ = measurement_.q;

  if (!fell_ && (truth.base_touches_ground || lies(truth.X_WB) || !truth.finite)) {
    fell_ = true;
    walker_.emergency_stop();
  }
}

void SteeredWalk::push(double angle) {
  const Vector2 along = kPushSpeed * robot_.mass / kPushTime * unit_vector(angle + place().angle);
  world_.push({along.x(), along.y(), 0.0}, kPushTime);
}

void SteeredWalk::set_gait(const gait_state::StepperParams& stepper) {
  walker_.set_stepping(stepper);
  simulation_.gait.stepper = stepper;
}

PlanarPose SteeredWalk::place() const { return in_plane(world_.truth().X_WB); }

heading_control::HeadingCommand SteeredWalk::command_of(
    const PlanarTwist& twist, const heading_control::Heading& last) const {
  return heading_control::from_twist(twist, nominal_stance(robot_), last);
}

Vector3 SteeredWalk::centre_of_mass() const {
  Vector3 sum = robot_.base.mass * (robot_.base.X_BL0 * robot_.base.p_LM);
  double mass = robot_.base.mass;
  for (LegId i = 0; i < robot_.num_legs(); ++i) {
    const LegModel& leg = robot_.legs[i];
    for (int k = 0; k < leg.num_joints(); ++k) {
      sum += leg.links[k].mass * (link_pose(leg, k, measurement_.q[i]) * leg.links[k].p_LM);
      mass += leg.links[k].mass;
    }
  }
  return world_.truth().X_WB * Vector3(sum / mass);
}

PoseFrame SteeredWalk::frame() const {
  const footstep_gen::TickRecord& record = walker_.record();
  PoseFrame f;
  if (fell_) f.flags |= PoseFrame::fell;
  if (record.holding) f.flags |= PoseFrame::holding;
  f.fault = static_cast<std::uint8_t>(record.fault);
  f.tick = ticks_;
  f.time = ticks_ * control_dt();
  f.X_WB = world_.truth().X_WB;
  f.velocity = velocity_;
  f.com = centre_of_mass();
  f.lateral = deviation_.lateral;
  f.path = way_;
  f.power = power_;
  show_heading(f);
  show_gait(f);
  show_legs(f);
  return f;
}

void SteeredWalk::show_heading(PoseFrame& f) const {
  const heading_control::Heading& heading = walker_.record().heading;
  f.rho = heading.rho();
  f.k = heading.k();
  f.crab = heading.crab_angle();
  f.moving = heading.moving();
  const double r = f.rho / f.k;  // infinite when straight
  f.centre = place() * Vector2(r * perpendicular(unit_vector(f.crab)));
  if (!f.centre.allFinite()) f.centre.setConstant(std::numeric_limits<double>::quiet_NaN());
}

void SteeredWalk::show_gait(PoseFrame& f) const {
  using gait_state::Stepping;
  const Stepping stepping = walker_.params().stepper.stepping;
  if (stepping == Stepping::wave) f.flags |= PoseFrame::wave;
  if (stepping == Stepping::tripod) f.flags |= PoseFrame::tripod;
  const footstep_gen::TickRecord& record = walker_.record();
  f.raw = static_cast<std::uint16_t>(record.gait.raw.bits);
  f.state = static_cast<std::uint16_t>(record.gait.state.bits);
  f.ccn = static_cast<std::uint8_t>(record.gait.ccn_before_adjustment);
  f.type = static_cast<std::uint8_t>(gait_state::type_of(record.gait.state));
  f.priority = record.gait.priority;
  f.may_step = record.gait.may_step;
  f.waits = record.waits;
  f.urgent = record.gait_input.urgent;
}

void SteeredWalk::show_legs(PoseFrame& f) const {
  const footstep_gen::TickRecord& record = walker_.record();
  const Pose X_WO = f.X_WB * record.state.X_OB.inverse();  // as the robot believes to stand
  f.legs = LegArray<LegFrame>(robot_.num_legs());
  LegArray<Vector3> p_WF(robot_.num_legs());
  for (LegId i = 0; i < robot_.num_legs(); ++i) {
    LegFrame& leg = f.legs[i];
    const FootTruth& foot = world_.truth().feet[i];
    leg.p_WF = p_WF[i] = foot.p_WF;
    leg.force = foot.normal_force;
    leg.q = measurement_.q[i];
    leg.phase = static_cast<std::uint8_t>(record.legs[i].phase);
    if (i < record.gait_input.lag.size()) leg.lag = record.gait_input.lag[i];
    if (!record.legs[i].on_ground()) leg.p_WT = X_WO * record.footsteps[i].p_OT;
    f.contact.set(i, foot.in_contact);
    f.support.set(i, record.legs[i].on_ground());
    if (foot.in_contact) f.slip_speed = std::max(f.slip_speed, foot.slip_speed);
  }
  f.polygon = support_polygon(p_WF, f.contact);
  f.margin = stability_margin(f.polygon, f.com.head<2>());
}

}  // namespace hexagait::viewer
