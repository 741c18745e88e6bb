// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/action.hpp>
#include <initializer_list>

/// Short words for the actions of tests.
namespace hexagait::testing {

inline action::Step step(std::vector<action::LegCommand> legs) {
  action::Step step;
  step.legs = std::move(legs);
  return step;
}
inline action::Step step(decltype(action::BaseCommand::motion) base,
                         std::vector<action::LegCommand> legs = {}) {
  action::Step step;
  step.legs = std::move(legs);
  step.base = {std::move(base), {}};
  return step;
}
inline action::Step wait(double seconds) {
  action::Step step;
  step.wait.duration = seconds;
  return step;
}
inline action::Action steps(std::vector<action::Step> steps) {
  action::Action action;
  action.steps = std::move(steps);
  return action;
}

inline action::Footstep footstep(LegId leg, const Vector3& p, FrameId frame = kOdom) {
  action::Footstep step;
  step.leg = leg;
  step.target = {frame, p};
  return step;
}
inline action::EndEffectorTarget foot_target(LegId leg, const Vector3& p, FrameId frame = kOdom) {
  action::EndEffectorTarget target;
  target.leg = leg;
  target.ignore_contact = true;
  target.target = {frame, p};
  return target;
}
inline action::LegMode leg_mode(LegId leg, bool support, double duration = 0.1) {
  action::LegMode mode;
  mode.leg = leg;
  mode.support_leg = support;
  mode.ignore_contact = !support;
  mode.duration = duration;
  return mode;
}
inline action::BaseTarget base_target(const Pose& X, FrameId frame = kOdom) {
  action::BaseTarget target;
  target.frame = frame;
  target.X_AB = X;
  return target;
}
inline action::BaseAuto base_auto(double height) {
  action::BaseAuto automatic;
  automatic.height = height;
  return automatic;
}

}  // namespace hexagait::testing
