// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/actions/action_for_robot.hpp>
#include <hexagait/walk/start_posture.hpp>

namespace hexagait::walk {
namespace {

// What a robot's lengths and times are measured by.
struct Measures {
  explicit Measures(const RobotModel& robot)
      : model(robot), scale(scale_of(robot)), belly(belly_depth(robot) - robot.foot_radius) {
    for (const LegModel& leg : robot.legs) middle += leg.p_BC.head<2>() / robot.num_legs();
  }
  const RobotModel& model;
  RobotScale scale;
  double belly;                      // height of the body's origin above the feet, lying [m]
  Vector2 middle = Vector2::Zero();  // of the feet [m]
};

class Mapping {
 public:
  Mapping(const RobotModel& from, const RobotModel& to)
      : from_(from),
        to_(to),
        length_(to_.scale.reach / from_.scale.reach),
        time_(to_.scale.time / from_.scale.time),
        up_(std::min(length_, to_.scale.hip_height / from_.scale.hip_height)),
        force_(to_.scale.weight / from_.scale.weight) {}

  void map(action::LegCommand& command) const {
    std::visit([this](auto& motion) { map(motion); }, command.motion);
  }
  void map(action::BaseCommand& command) const {
    std::visit([this](auto& motion) { map(motion); }, command.motion);
  }

  [[nodiscard]] double time() const { return time_; }

 private:
  [[nodiscard]] double height(double z) const {
    const double share =
        (to_.scale.hip_height - to_.belly) / (from_.scale.hip_height - from_.belly);
    return to_.belly + share * (z - from_.belly);
  }
  [[nodiscard]] Vector3 velocity(const Vector3& v) const { return length_ / time_ * v; }

  [[nodiscard]] Vector3 foot(LegId leg, FrameId frame, const Vector3& p) const {
    const bool in_base = frame == kBase;
    const Vector2 before = from_.model.legs[leg].p_BC.head<2>();
    const Vector2 origin = in_base ? Vector2(0.0, 0.0) : from_.middle;
    const Vector2 new_origin = in_base ? Vector2(0.0, 0.0) : to_.middle;
    Vector3 mapped = to_.model.legs[leg].p_BC;
    mapped.head<2>() += length_ * (p.head<2>() + origin - before) - new_origin;
    mapped.z() = in_base ? -height(-p.z()) : up_ * p.z();
    return mapped;
  }

  [[nodiscard]] Pose base(Pose X) const {
    X.p.head<2>() *= length_;
    X.p.z() = height(X.p.z());
    return X;
  }

  // Joint values that are all given are those of a foot.
  void map(LegId leg, JointKnot& knot) const {
    knot.time *= time_;
    const LegModel& from = from_.model.legs[leg];
    const LegModel& to = to_.model.legs[leg];
    if (knot.q.head(from.num_joints()).hasNaN()) return;
    const Vector3 p_BF = foot(leg, kBase, foot_position(from, own_joints(from, knot.q)));
    knot.q.head(to.num_joints()) = inverse_kinematics(to, p_BF).q.head(to.num_joints());
  }

  void map(action::Footstep& step) const {
    step.target.p = foot(step.leg, step.target.frame, step.target.p);
    step.profile_height *= up_;
    step.average_velocity *= length_ / time_;
    if (step.duration) *step.duration *= time_;
  }
  void map(action::EndEffectorTarget& target) const {
    target.target.p = foot(target.leg, target.target.frame, target.target.p);
    target.velocity = velocity(target.velocity);
    target.acceleration = velocity(target.acceleration) / time_;
    target.force *= force_;
    target.average_velocity *= length_ / time_;
  }
  void map(action::EndEffectorTrajectory& trajectory) const {
    for (FootKnot& knot : trajectory.knots) {
      knot.time *= time_;
      knot.p = foot(trajectory.leg, trajectory.frame, knot.p);
      if (knot.v) knot.v = velocity(*knot.v);
    }
  }
  void map(action::JointTarget& target) const {
    map(target.leg, target.target);
    target.average_velocity /= time_;
  }
  void map(action::JointTrajectory& trajectory) const {
    for (JointKnot& knot : trajectory.knots) map(trajectory.leg, knot);
  }
  void map(action::LegMode& mode) const { mode.duration *= time_; }
  void map(action::BaseAuto& automatic) const {
    if (automatic.height) automatic.height = height(*automatic.height);
    automatic.average_linear_velocity *= length_ / time_;
    automatic.average_angular_velocity /= time_;
    automatic.support_margin *= to_.scale.size / from_.scale.size;
  }
  void map(action::BaseTarget& target) const {
    target.X_AB = base(target.X_AB);
    target.average_linear_velocity *= length_ / time_;
    target.average_angular_velocity /= time_;
  }
  void map(action::BaseTrajectory& trajectory) const {
    for (BaseKnot& knot : trajectory.knots) knot = {time_ * knot.time, base(knot.X_AB)};
  }

  Measures from_, to_;
  double length_, time_, up_, force_;
};

// The frame of a command, if it has one.
FrameId frame_of(const action::Footstep& step) { return step.target.frame; }
FrameId frame_of(const action::EndEffectorTarget& target) { return target.target.frame; }
FrameId frame_of(const action::EndEffectorTrajectory& trajectory) { return trajectory.frame; }
FrameId frame_of(const action::BaseTarget& target) { return target.frame; }
FrameId frame_of(const action::BaseTrajectory& trajectory) { return trajectory.frame; }
template <class Motion>
FrameId frame_of(const Motion&) {
  return kFootprint;
}

template <class Command>
bool is_about_a_place(const Command& command) {
  return std::visit(
      [](const auto& motion) {
        const FrameId frame = frame_of(motion);
        return frame != kFootprint && frame != kBase;
      },
      command.motion);
}

bool is_about_a_place(const action::Step& step) {
  return (step.base && is_about_a_place(*step.base)) ||
         std::ranges::any_of(step.legs, [](const action::LegCommand& command) {
           return is_about_a_place(command);
         });
}

}  // namespace

action::Action for_robot(action::Action action, const RobotModel& written_for,
                         const RobotModel& robot) {
  if (written_for.num_legs() != robot.num_legs())
    throw InvalidInput(fmt::format("{} is for robots of {} legs, such as {}; {} has {}", action.id,
                                   written_for.num_legs(), written_for.name, robot.name,
                                   robot.num_legs()));
  if (std::ranges::any_of(action.steps,
                          [](const action::Step& step) { return is_about_a_place(step); }))
    throw InvalidInput(
        fmt::format("{} is about places of the map that are there for {}, not for {}", action.id,
                    written_for.name, robot.name));
  const Mapping mapping(written_for, robot);
  for (action::Step& step : action.steps) {
    for (action::LegCommand& command : step.legs) mapping.map(command);
    if (step.base) mapping.map(*step.base);
    step.wait.duration *= mapping.time();
  }
  return action;
}

}  // namespace hexagait::walk
