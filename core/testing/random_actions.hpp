// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rapidcheck.h>

#include <hexagait/action/action.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>
#include <ostream>
#include <testing/random_vector.hpp>
#include <vector>

/// Actions at random, for properties of whatever is commanded.
namespace hexagait::testing {

/// Rapidcheck shrinks these small numbers; from them a fixed random sequence makes commands.
struct CommandSpec {
  int kind = 0, leg = 0, frame = 0, flags = 0, seed = 0;
};
using StepSpec = std::vector<CommandSpec>;
using ActionSpec = std::vector<StepSpec>;

inline std::ostream& operator<<(std::ostream& os, const CommandSpec& c) {
  return os << '{' << c.kind << ',' << c.leg << ',' << c.frame << ',' << c.flags << ',' << c.seed
            << '}';
}
template <class T>
std::ostream& operator<<(std::ostream& os, const std::vector<T>& list) {
  os << '{';
  for (const T& item : list) os << item << ',';
  return os << '}';
}

/// Makes commands of specifications: values as a user may write them, now and then absurd ones.
class ActionWriter {
 public:
  explicit ActionWriter(const RobotModel& model) : model_(model) {}

  action::Action action(const ActionSpec& spec) {
    action::Action action;
    for (const StepSpec& step : spec) action.steps.push_back(this->step(step));
    if (!spec.empty() && !spec[0].empty() && spec[0][0].flags == 7)
      action.adapt_coordinates.push_back({kFootprint, kMap, pose(0.05), spec[0][0].leg % 2 == 0});
    return action;
  }

 private:
  action::Step step(const StepSpec& spec) {
    action::Step step;
    LegSet moved;
    for (const CommandSpec& command : spec) {
      random_ = {.seed = static_cast<std::uint64_t>(command.seed)};
      command_ = command;
      const LegId leg = command.leg % model_.num_legs();
      if (command.kind < 6 && !moved.contains(leg)) step.legs.push_back({leg_command(leg), {}});
      if (command.kind < 6) moved.insert(leg);
      if (command.kind >= 6 && command.kind < 10) step.base = {base_command(), {}};
      if (command.kind == 10) step.wait.duration = random_.uniform(0.0, 0.2);
      if (command.kind == 11) step.custom.push_back({0, "sound", random_.uniform(0.0, 0.2), "x"});
    }
    return step;
  }

  Vector3 vector(double size) { return random_vector(random_, size); }
  Pose pose(double size) { return {rotation(vector(size)), vector(size)}; }
  FrameId frame() const { return static_cast<FrameId>(command_.frame); }

  // A place of the foot near its nominal one, whatever the frame; rarely far from everything.
  Vector3 place(LegId leg, FrameId frame) {
    const bool in_body = frame == kBase || frame == kFirstRegistered;
    Vector3 p = model_.legs[leg].p_BC + vector(command_.flags == 6 ? 1.0 : 0.06);
    if (!in_body) p.z() = model_.foot_radius + random_.uniform(-0.03, 0.05);
    return p;
  }

  action::LegMotion motion(LegId leg) {
    action::LegMotion motion;
    motion.leg = leg;
    motion.ignore_contact = command_.flags % 4 == 1;
    motion.ignore_for_pose_adaptation = command_.flags % 4 == 2;
    if (command_.flags == 3) motion.surface_normal = {frame(), Vector3::UnitZ() + vector(0.5)};
    return motion;
  }

  decltype(action::LegCommand::motion) leg_command(LegId leg) {
    switch (command_.kind) {
      case 0: {
        action::Footstep step{motion(leg), {frame(), place(leg, frame())}};
        step.profile_height = random_.uniform(0.0, 0.12);
        step.profile = static_cast<SwingProfile>(command_.seed % 4);
        return step;
      }
      case 1: {
        action::EndEffectorTarget target{motion(leg), {frame(), place(leg, frame())}};
        if (command_.seed % 2 == 0) target.velocity = vector(0.2);
        if (command_.seed % 3 == 0) target.force = vector(30.0);
        return target;
      }
      case 2:
        return foot_trajectory(leg);
      case 3:
        return action::JointTarget{motion(leg), joint_knot(leg), 1.0};
      case 4:
        return joint_trajectory(leg);
      default:
        return action::LegMode{motion(leg), command_.flags % 2 == 0, random_.uniform(0.0, 0.3)};
    }
  }

  action::EndEffectorTrajectory foot_trajectory(LegId leg) {
    action::EndEffectorTrajectory trajectory{motion(leg), frame(), {}};
    double time = command_.seed % 2 * random_.uniform(0.0, 0.3);
    for (int k = 0; k <= command_.seed % 4; ++k) {
      trajectory.knots.push_back({time, place(leg, frame()), {}});
      if (command_.flags >= 4) trajectory.knots.back().v = vector(0.3);
      time += random_.uniform(0.002, 0.3);
    }
    return trajectory;
  }

  LegJoints joints(LegId leg, double size) {
    LegJoints q = LegJoints::Zero();
    for (int k = 0; k < model_.legs[leg].num_joints(); ++k) q[k] = random_.uniform(-size, size);
    return q;
  }

  // Positions, velocities or efforts, or any of them for some of the joints.
  JointKnot joint_knot(LegId leg) {
    JointKnot knot;
    const LegJoints q = inverse_kinematics(model_.legs[leg], model_.legs[leg].p_BC).q;
    const int given = command_.seed % 8;
    if (given == 0 || given & 1) knot.q = q + joints(leg, 0.3);
    if (given & 2) knot.qd = joints(leg, 0.5);
    if (given & 4) knot.effort = joints(leg, 20.0);
    if (given == 7) knot.q[command_.seed % 3] = knot.qd[2] = JointKnot::kNone;
    return knot;
  }

  action::JointTrajectory joint_trajectory(LegId leg) {
    action::JointTrajectory trajectory{motion(leg), {}};
    double time = 0.0;
    for (int k = 0; k <= command_.flags % 4; ++k) {
      trajectory.knots.push_back(joint_knot(leg));
      trajectory.knots.back().time = time += random_.uniform(0.002, 0.3);
    }
    return trajectory;
  }

  // A pose of the base near where it stands.
  Pose base_pose() {
    Pose X = pose(0.05);
    const bool in_body = frame() == kBase || frame() == kFirstRegistered;
    if (!in_body) X.p.z() += model_.foot_radius - model_.legs[0].p_BC.z();
    return X;
  }

  decltype(action::BaseCommand::motion) base_command() {
    const bool ignores = command_.flags % 2 == 1;
    if (command_.kind == 6) {
      action::BaseAuto automatic;
      automatic.ignore_timing_of_leg_motion = ignores;
      if (command_.flags > 4) automatic.height = random_.uniform(0.2, 0.6);
      automatic.support_margin = random_.uniform(0.0, 0.08);
      return automatic;
    }
    if (command_.kind < 9) return action::BaseTarget{frame(), base_pose(), ignores, 0.1, 0.2};
    action::BaseTrajectory trajectory{frame(), {}};
    double time = 0.0;
    for (int k = 0; k <= command_.flags % 4; ++k) {
      trajectory.knots.push_back({time, base_pose()});
      time += random_.uniform(0.1, 0.4);
    }
    return trajectory;
  }

  const RobotModel& model_;
  RandomSequence random_;
  CommandSpec command_;
};

inline rc::Gen<CommandSpec> command_specs() {
  using rc::gen::inRange;
  return rc::gen::construct<CommandSpec>(inRange(0, 12), inRange(0, 6), inRange(0, 6),
                                         inRange(0, 8), inRange(0, 1000));
}

/// Some of something: size grows with the number of the trial otherwise.
template <class T>
rc::Gen<std::vector<T>> few(int least, int most, rc::Gen<T> gen) {
  return rc::gen::mapcat(rc::gen::inRange(least, most + 1), [gen](int n) {
    return rc::gen::container<std::vector<T>>(static_cast<std::size_t>(n), gen);
  });
}

inline rc::Gen<ActionSpec> action_specs() {
  return few<StepSpec>(1, 3, few<CommandSpec>(0, 4, command_specs()));
}

}  // namespace hexagait::testing
