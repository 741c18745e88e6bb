// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/action.hpp>
#include <vector>

/// Every number of an action made in C++, for tests that put absurd ones in its place.
namespace hexagait::testing {

class NumbersOf {
 public:
  explicit NumbersOf(action::Action& action) {
    for (action::Adaptation& adaptation : action.adapt_coordinates) add(adaptation.X_S);
    for (action::Step& step : action.steps) {
      for (action::LegCommand& command : step.legs)
        std::visit([this](auto& motion) { add_motion(motion); }, command.motion);
      if (step.base) std::visit([this](auto& motion) { add_motion(motion); }, step.base->motion);
      for (action::CustomCommand& custom : step.custom) add(custom.duration);
      add(step.wait.duration);
    }
  }

  void add(Pose& X) {
    add(X.p);
    add(X.R);
  }

  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  [[nodiscard]] double& operator[](std::size_t index) const { return *numbers_[index]; }

 private:
  void add(double& number) { numbers_.push_back(&number); }
  template <class Derived>
  void add(Eigen::PlainObjectBase<Derived>& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) add(values.data()[i]);
  }
  void add(JointKnot& knot) {
    add(knot.time);
    for (LegJoints* values : {&knot.q, &knot.qd, &knot.qdd, &knot.effort}) add(*values);
  }

  void add_motion(action::Footstep& step) {
    add(step.surface_normal.v);
    add(step.target.p);
    add(step.profile_height);
    add(step.average_velocity);
    if (step.duration) add(*step.duration);
  }
  void add_motion(action::EndEffectorTarget& target) {
    add(target.surface_normal.v);
    for (Vector3* v : {&target.target.p, &target.velocity, &target.acceleration, &target.force})
      add(*v);
    add(target.average_velocity);
  }
  void add_motion(action::EndEffectorTrajectory& trajectory) {
    for (FootKnot& knot : trajectory.knots) {
      add(knot.time);
      add(knot.p);
      if (knot.v) add(*knot.v);
    }
  }
  void add_motion(action::JointTarget& target) {
    add(target.target);
    add(target.average_velocity);
  }
  void add_motion(action::JointTrajectory& trajectory) {
    for (JointKnot& knot : trajectory.knots) add(knot);
  }
  void add_motion(action::LegMode& mode) { add(mode.duration); }
  void add_motion(action::BaseAuto& automatic) {
    if (automatic.height) add(*automatic.height);
    add(automatic.average_linear_velocity);
    add(automatic.average_angular_velocity);
    add(automatic.support_margin);
  }
  void add_motion(action::BaseTarget& target) {
    add(target.X_AB);
    add(target.average_linear_velocity);
    add(target.average_angular_velocity);
  }
  void add_motion(action::BaseTrajectory& trajectory) {
    for (BaseKnot& knot : trajectory.knots) {
      add(knot.time);
      add(knot.X_AB);
    }
  }

  std::vector<double*> numbers_;
};

}  // namespace hexagait::testing
