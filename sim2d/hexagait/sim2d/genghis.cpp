// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim2d/genghis.hpp>
#include <hexagait/text/violations.hpp>
#include <limits>

namespace hexagait::sim2d {
namespace {

constexpr double kSettling = 0.3;  // the robot stands for so long before it walks [s]
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Feet at their workspace centres, displaced at random along the ground.
LegArray<GenghisJoints> posture(const GenghisModel& model, double spread, std::uint64_t seed) {
  RandomSequence random{.seed = seed, .stream = RandomStream::posture};
  LegArray<GenghisJoints> q(kGenghisLegs);
  for (LegId i = 0; i < kGenghisLegs; ++i)
    q[i] = joints_for(model, i, centre(model, i) + Vector2(random.uniform(-spread, spread), 0.0));
  return q;
}

Vector3 beside(const Vector2& p, LegId leg, double y) { return {p.x(), sign_of(leg) * y, p.y()}; }

hexagait::LegPhase in_space(LegPhase phase) {
  switch (phase) {
    case LegPhase::support:
      return hexagait::LegPhase::support;
    case LegPhase::raise:
      return hexagait::LegPhase::lift;
    case LegPhase::advance:
      return hexagait::LegPhase::transfer;
    case LegPhase::retreat:
      return hexagait::LegPhase::retreat;
    case LegPhase::descend:
      break;
  }
  return hexagait::LegPhase::descend;
}

}  // namespace

void check(const GenghisTrial& trial, const GenghisModel& model) {
  Violations violations("Genghis");
  const auto require = [&](bool right, const char* name, double value, const char* words) {
    if (!right) violations.add(name, in_words(value) + "; it must be " + words);
  };
  require(trial.seconds > 0.0 && trial.seconds <= 86400.0, "seconds", trial.seconds,
          "more than 0 and at most 86400");
  require(trial.distance > 0.0, "distance", trial.distance, "more than 0");
  require(0.0 <= trial.random_posture && trial.random_posture <= model.workspace_radius,
          "random_posture", trial.random_posture, "from 0 to 0.05 m, the radius of the workspaces");
  violations.throw_if_any();
}

GenghisWorld settled_world(const GenghisTrial& trial, const GenghisModel& model) {
  GenghisWorldParams params;
  params.physics_dt = trial.physics_dt;
  params.control_dt = trial.control_dt;
  params.seed = trial.seed;
  const auto q = posture(model, trial.random_posture, trial.seed);
  GenghisWorld world(model, trial.terrain, params, q);
  const GenghisTargets standing{q, LegArray<GenghisJoints>(kGenghisLegs)};
  for (double t = 0.0; t < kSettling; t += trial.control_dt) world.write(standing);
  return world;
}

GenghisController controller(const GenghisTrial& trial, const GenghisModel& model) {
  GenghisParams params = trial.controller;
  params.gait = trial.gait;
  params.backward = trial.backward;
  params.control_dt = trial.control_dt;
  return GenghisController(model, params);
}

RobotModel robot_in_space(const GenghisModel& model) {
  constexpr std::array<const char*, kGenghisLegs> kNames = {"LF", "RF", "LM", "RM", "LR", "RR"};
  RobotModel robot;
  robot.name = "genghis2d";
  robot.mass = model.mass();
  robot.foot_radius = model.foot_radius;
  robot.base.mass = model.body_mass;
  robot.base.shapes = {
      {.kind = Shape::Kind::box,
       .size = {model.body_length, 2.0 * model.hip_y, model.body_height},
       .X_LS = {Matrix3::Identity(), {0.0, 0.0, 0.5 * model.body_height - model.belly}}}};
  robot.legs = LegArray<LegModel>(kGenghisLegs);
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    LegModel& leg = robot.legs[i];
    leg.name = kNames[static_cast<std::size_t>(i)];
    leg.kind = LegKind::serial;
    leg.X_BH.p = beside(hip(model, i), i, model.hip_y);
    leg.p_BC = beside(centre(model, i), i, model.foot_y);
    leg.workspace_radius = model.workspace_radius;
    leg.joint_names = {leg.name + "_swing", leg.name + "_lift"};
    leg.limits = {{.lower = -model.max_swing, .upper = model.max_swing},
                  {.lower = 0.0, .upper = model.max_lift}};
    leg.links = JointArray<LinkModel>(0);
    leg.p_BJ0 = std::initializer_list<Vector3>{};
    leg.axis_B0 = std::initializer_list<Vector3>{};
  }
  return robot;
}

void record_in_space(const GenghisModel& model, const GenghisParams& params,
                     const GenghisRecord& genghis, footstep_gen::TickRecord& record) {
  const GenghisMeasurement& sensed = genghis.measurement;
  for (auto* legs : {&record.measurement.q, &record.state.q, &record.targets.q, &record.targets.qd,
                     &record.targets.effort})
    *legs = LegArray<LegJoints>(kGenghisLegs, LegJoints::Zero());
  for (auto* contact : {&record.measurement.contact, &record.state.contact})
    *contact = LegArray<bool>(kGenghisLegs);
  record.state.p_BF = LegArray<Vector3>(kGenghisLegs, Vector3::Zero());
  record.legs = LegArray<LegLane>(kGenghisLegs);
  record.measurement.time = record.state.time = sensed.time;
  record.state.X_OB.p.setConstant(kNone);
  record.heading = heading_control::Heading::straight(params.backward ? std::numbers::pi : 0.0);
  record.gait_input = genghis.gait_input;
  record.gait = genghis.decision.gait;
  record.lifts = genghis.decision.lifts;
  record.waits = genghis.decision.waits;
  record.rule1_violations = genghis.decision.rule1_violations;
  record.path_to_come = genghis.to_come;
  record.base_goal.advance = genghis.advance_goal;
  record.base.planar.v = {genghis.v_body.x(), 0.0};
  const auto joints = [](const GenghisJoints& q) { return leg_joints({q.swing, q.lift}); };
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    const GenghisLeg& leg = genghis.legs[i];
    record.measurement.q[i] = record.state.q[i] = joints(sensed.q[i]);
    record.measurement.contact[i] = record.state.contact[i] = sensed.load[i] > params.lost_load;
    record.state.p_BF[i] = beside(genghis.feet[i], i, model.foot_y);
    record.targets.q[i] = joints(genghis.targets.q[i]);
    record.targets.qd[i] = joints(genghis.targets.q_dot[i]);
    LegLane& lane = record.legs[i];
    lane.phase = in_space(leg.phase);
    lane.p_BF = beside(leg.p, i, model.foot_y);
    lane.touched_down = leg.touched_down;
    lane.lifted = genghis.decision.lifts.contains(i);
  }
}

}  // namespace hexagait::sim2d
