// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/gait_state/gait_state.hpp>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/viewer/display/frame_maker.hpp>
#include <limits>

namespace hexagait::viewer {
namespace {

constexpr double kSmoothing = 0.4;  // time constant of speed and power as shown [s]

}  // namespace

std::uint8_t gait_flags(gait_state::Stepping stepping) {
  if (stepping == gait_state::Stepping::wave) return PoseFrame::wave;
  if (stepping == gait_state::Stepping::tripod) return PoseFrame::tripod;
  return 0;
}

footstep_gen::TickRecord as_walk(const ActionRecord& action) {
  footstep_gen::TickRecord record;
  record.measurement = action.measurement;
  record.fault = action.fault;
  record.holding = action.holding;
  record.state = action.state;
  record.legs = action.legs;
  record.footsteps = LegArray<FootstepCommand>(action.legs.size());
  for (FootstepCommand& step : record.footsteps)  // legs follow plans, and have no foothold
    step.p_OT.setConstant(std::numeric_limits<double>::quiet_NaN());
  return record;
}

void FrameMaker::start(const GroundTruth& truth, const LegArray<LegJoints>& q) {
  truth_ = truth;
  q_ = q;
  velocity_ = {};
  power_ = way_ = 0.0;
  ticks_ = 0;
}

void FrameMaker::observe(const GroundTruth& truth, const LegArray<LegJoints>& q,
                         const LegArray<LegJoints>& efforts) {
  const double share = dt_ / kSmoothing;
  const PlanarPose step = between(in_plane(truth_.X_WB), in_plane(truth.X_WB));
  velocity_.v += share * (step.shift / dt_ - velocity_.v);
  velocity_.w += share * (wrap_angle(step.angle) / dt_ - velocity_.w);
  way_ += step.shift.norm();

  double power = 0.0;
  for (LegId i = 0; i < robot_->num_legs(); ++i)
    power += efforts[i].cwiseProduct(q[i] - q_[i]).cwiseAbs().sum() / dt_;
  power_ += share * (power - power_);
  truth_ = truth;
  q_ = q;
  ++ticks_;
}

Vector3 FrameMaker::centre_of_mass() const {
  Vector3 sum = robot_->base.mass * (robot_->base.X_BL0 * robot_->base.p_LM);
  double mass = robot_->base.mass;
  for (LegId i = 0; i < robot_->num_legs(); ++i) {
    const LegModel& leg = robot_->legs[i];
    for (int k = 0; k < leg.num_joints(); ++k) {
      sum += leg.links[k].mass * (link_pose(leg, k, q_[i]) * leg.links[k].p_LM);
      mass += leg.links[k].mass;
    }
  }
  return truth_.X_WB * Vector3(sum / mass);
}

PoseFrame FrameMaker::frame(const footstep_gen::TickRecord& record) const {
  PoseFrame f;
  if (record.holding) f.flags |= PoseFrame::holding;
  if (record.refuses) f.flags |= PoseFrame::refuses;
  f.fault = static_cast<std::uint8_t>(record.fault);
  f.tick = ticks_;
  f.time = time();
  f.X_WB = truth_.X_WB;
  f.velocity = velocity_;
  f.com = centre_of_mass();
  f.path = way_;
  f.power = power_;
  show_heading(record, f);
  show_gait(record, f);
  show_legs(record, f);
  return f;
}

void FrameMaker::show_heading(const footstep_gen::TickRecord& record, PoseFrame& f) const {
  const heading_control::Heading& heading = record.heading;
  f.rho = heading.rho();
  f.k = heading.k();
  f.crab = heading.crab_angle();
  f.moving = heading.moving();
  const double r = f.rho / f.k;  // infinite when straight
  f.centre = in_plane(truth_.X_WB) * Vector2(r * perpendicular(unit_vector(f.crab)));
  if (!f.centre.allFinite()) f.centre.setConstant(std::numeric_limits<double>::quiet_NaN());
}

void FrameMaker::show_gait(const footstep_gen::TickRecord& record, PoseFrame& f) const {
  f.raw = static_cast<std::uint16_t>(record.gait.raw.bits);
  f.state = static_cast<std::uint16_t>(record.gait.state.bits);
  f.ccn = static_cast<std::uint8_t>(record.gait.ccn_before_adjustment);
  f.type = static_cast<std::uint8_t>(gait_state::type_of(record.gait.state));
  f.priority = record.gait.priority;
  f.may_step = record.gait.may_step;
  f.waits = record.waits;
  f.urgent = record.gait_input.urgent;
}

void FrameMaker::show_legs(const footstep_gen::TickRecord& record, PoseFrame& f) const {
  const Pose X_WO = f.X_WB * record.state.X_OB.inverse();  // as the robot believes to stand
  f.legs = LegArray<LegFrame>(robot_->num_legs());
  LegArray<Vector3> p_WF(robot_->num_legs());
  for (LegId i = 0; i < robot_->num_legs(); ++i) {
    LegFrame& leg = f.legs[i];
    const FootTruth& foot = truth_.feet[i];
    leg.p_WF = p_WF[i] = foot.p_WF;
    leg.force = foot.normal_force;
    leg.q = q_[i];
    leg.phase = record.lost.contains(i) ? kLost : static_cast<std::uint8_t>(record.legs[i].phase);
    if (i < record.gait_input.lag.size()) leg.lag = record.gait_input.lag[i];
    if (!record.legs[i].on_ground() && leg.phase != kLost)
      leg.p_WT = X_WO * record.footsteps[i].p_OT;
    f.contact.set(i, foot.in_contact);
    f.support.set(i, record.legs[i].on_ground());
    if (foot.in_contact) f.slip_speed = std::max(f.slip_speed, foot.slip_speed);
  }
  f.polygon = support_polygon(p_WF, f.contact);
  f.margin = stability_margin(f.polygon, f.com.head<2>());
}

}  // namespace hexagait::viewer
