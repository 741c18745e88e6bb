// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/script/leg_planner.hpp>

namespace hexagait {
namespace {

// Set point of the foot, in the frame of its curve; for a foot driven by effort, the measured
// position. Standing feet are at rest.
PointState start_of_foot(LegId leg, const Placement& placement, const StepStart& start) {
  const LegLane& lane = start.executor.legs()[leg];
  const Pose& X_OB = start.state.X_OB;
  PointState from;
  const bool driven = start.executor.targets().mode[leg] == ControlMode::effort;
  const Vector3& p_BF = driven ? start.state.p_BF[leg] : lane.p_BF;
  from.p = placement.in_body ? p_BF : X_OB * p_BF;
  if (lane.on_ground()) return from;
  const Matrix3 R_PO = placement.in_body ? Matrix3(X_OB.R.transpose()) : Matrix3::Identity();
  from.v = R_PO * lane.v_O;
  from.a = R_PO * lane.a_O;
  return from;
}

Vector3 unit(const Vector3& v) {
  const double length = v.stableNorm();
  return length > 1e-9 ? Vector3(v / length) : Vector3::UnitZ();
}

// The foot motion of a command, in the frame in which it is executed.
class FootPlanner {
 public:
  FootPlanner(LegPlan& plan, FrameId frame, const action::LegMotion& motion, const StepStart& start,
              const PlannerParams& params)
      : plan_(plan),
        placement_(start.step_frames.place(frame, start.frames, start.state)),
        from_(start_of_foot(motion.leg, placement_, start)),
        params_(params),
        stands_(start.executor.legs()[motion.leg].on_ground()),
        X_OP_(placement_.in_body ? start.state.X_OB : Pose{}) {
    plan.kind = LegPlan::Kind::foot;
    plan.in_body = placement_.in_body;
  }

  void operator()(const action::Footstep& step, double duration) {
    FootSwing swing;
    swing.target = placement_.X_PA * step.target.p;
    swing.profile = step.profile;
    swing.profile_height = step.profile_height;
    swing.normal = X_OP_.R.transpose() * plan_.normal_O;
    swing.touchdown_speed = params_.script.touchdown_speed;
    swing.tolerance = params_.script.swing_tolerance;
    swing.braking = params_.script.swing_braking;
    const double shortest = step.duration.value_or(
        swing_duration(from_.p, swing, step.average_velocity, params_.script.footstep_time));
    if (stands_) from_.v = params_.script.lift_off_speed * swing.normal;
    plan_.duration = std::max(duration, shortest);
    plan_.foot.plan_swing(from_, swing, plan_.duration);
  }

  void operator()(const action::EndEffectorTarget& target, double duration) {
    PointState to;
    to.p = placement_.X_PA * target.target.p;
    to.v = placement_.X_PA.R * target.velocity;
    to.a = placement_.X_PA.R * target.acceleration;
    const double shortest =
        std::max((to.p - from_.p).norm() / target.average_velocity, params_.script.target_time);
    plan_.duration = std::max(duration, shortest);
    plan_.foot.plan_target(from_, to, plan_.duration);
    plan_.force_O = X_OP_.R * (placement_.X_PA.R * target.force);
  }

  void operator()(const action::EndEffectorTrajectory& trajectory, std::vector<FootKnot>& knots) {
    knots.clear();
    for (const FootKnot& knot : trajectory.knots) {
      knots.push_back({knot.time, placement_.X_PA * knot.p, knot.v});
      if (knot.v) knots.back().v = placement_.X_PA.R * *knot.v;
    }
    plan_.foot.plan_trajectory(from_, knots);
    plan_.duration = plan_.foot.duration();
  }

 private:
  LegPlan& plan_;
  Placement placement_;
  PointState from_;
  const PlannerParams& params_;
  bool stands_;
  Pose X_OP_;
};

// State of a leg's joints, as last commanded.
JointState start_of_joints(LegId leg, const StepStart& start) {
  const JointTargets& targets = start.executor.targets();
  JointState from;
  from.q = targets.q[leg];
  if (!start.executor.legs()[leg].on_ground()) from.qd = targets.qd[leg];
  from.effort.setZero();
  return from;
}

// Target positions; if not given, the integral of the velocities; without these, the present ones.
JointKnot completed(JointKnot knot, const JointState& from, double duration) {
  for (int k = 0; k < kMaxLegJoints; ++k) {
    if (!std::isnan(knot.q[k])) continue;
    const double mean = std::isnan(knot.qd[k]) ? 0.0 : 0.5 * (from.qd[k] + knot.qd[k]);
    knot.q[k] = from.q[k] + mean * duration;
  }
  return knot;
}

ControlMode mode_of(const JointKnot& knot) {
  if (!knot.q.array().isNaN().all()) return ControlMode::position;
  if (!knot.qd.array().isNaN().all()) return ControlMode::velocity;
  return knot.effort.array().isNaN().all() ? ControlMode::position : ControlMode::effort;
}

void plan_joint_target(LegPlan& plan, const action::JointTarget& target, const StepStart& start,
                       const PlannerParams& params, double duration) {
  const JointState from = start_of_joints(target.leg, start);
  JointKnot knot = completed(target.target, from, std::max(duration, params.script.target_time));
  knot.time = std::max(
      duration, joint_duration(from.q, knot.q, target.average_velocity, params.script.target_time));
  plan.kind = LegPlan::Kind::joints;
  plan.mode = mode_of(target.target);
  plan.duration = knot.time;
  plan.joints.plan(from, {&knot, 1});
}

void plan_joint_trajectory(LegPlan& plan, const action::JointTrajectory& trajectory,
                           const StepStart& start) {
  plan.kind = LegPlan::Kind::joints;
  plan.joints.plan(start_of_joints(trajectory.leg, start), trajectory.knots);
  plan.duration = plan.joints.duration();
}

// The fields common to all commands of a leg.
void plan_common(LegPlan& plan, const action::LegMotion& motion, const StepStart& start) {
  const action::Direction& normal = motion.surface_normal;
  const Pose X_OA = start.step_frames.in_odom(normal.frame, start.frames, start.state);
  plan.normal_O = unit(X_OA.R * normal.v);
  plan.lands = !motion.ignore_contact;
  plan.mode = ControlMode::position;
  plan.force_O.setZero();
  plan.in_body = false;
}

// Plans a motion at rates, of at least that duration.
void plan_rated(LegPlan& plan, const action::LegCommand& command, double duration,
                const StepStart& start, const PlannerParams& params) {
  if (const auto* step = std::get_if<action::Footstep>(&command.motion))
    FootPlanner(plan, step->target.frame, *step, start, params)(*step, duration);
  else if (const auto* target = std::get_if<action::EndEffectorTarget>(&command.motion))
    FootPlanner(plan, target->target.frame, *target, start, params)(*target, duration);
  else if (const auto* joints = std::get_if<action::JointTarget>(&command.motion))
    plan_joint_target(plan, *joints, start, params, duration);
}

}  // namespace

void plan_leg(LegPlan& plan, const action::LegCommand& command, const StepStart& start,
              const PlannerParams& params, std::vector<FootKnot>& knots) noexcept {
  plan_common(plan, leg_motion(command), start);
  if (const auto* trajectory = std::get_if<action::EndEffectorTrajectory>(&command.motion)) {
    FootPlanner(plan, trajectory->frame, *trajectory, start, params)(*trajectory, knots);
  } else if (const auto* joints = std::get_if<action::JointTrajectory>(&command.motion)) {
    plan_joint_trajectory(plan, *joints, start);
  } else if (const auto* mode = std::get_if<action::LegMode>(&command.motion)) {
    plan.kind = LegPlan::Kind::keep;
    plan.duration = mode->duration;
    plan.lands = mode->support_leg;
  } else {
    plan_rated(plan, command, 0.0, start, params);
  }
}

bool rate_based(const action::LegCommand& command) noexcept {
  return std::holds_alternative<action::Footstep>(command.motion) ||
         std::holds_alternative<action::EndEffectorTarget>(command.motion) ||
         std::holds_alternative<action::JointTarget>(command.motion);
}

void stretch(LegPlan& plan, const action::LegCommand& command, double duration,
             const StepStart& start, const PlannerParams& params) noexcept {
  // A foot that takes longer already would be planned as it is; a target changes nothing but the time.
  if (plan.kind == LegPlan::Kind::foot && duration <= plan.duration) return;
  const bool to_target = std::holds_alternative<action::EndEffectorTarget>(command.motion);
  if (!to_target || !(plan.foot.duration() > 0.0))
    return plan_rated(plan, command, duration, start, params);
  plan.foot.plan_target(plan.foot.at(0.0), plan.foot.at(plan.foot.duration()), duration);
  plan.duration = duration;
}

Vector3 end_in_odom(const LegPlan& plan, LegId leg, const StepStart& start) noexcept {
  const Pose& X_OB = start.state.X_OB;
  switch (plan.kind) {
    case LegPlan::Kind::foot: {
      const Vector3 end = plan.foot.at(plan.duration).p;
      return plan.in_body ? X_OB * end : end;
    }
    case LegPlan::Kind::joints:
      return X_OB * foot_position(start.model.legs[leg], plan.joints.at(plan.duration).q);
    case LegPlan::Kind::keep:
      break;
  }
  return X_OB * start.executor.legs()[leg].p_BF;
}

}  // namespace hexagait
