// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/action/step_frames.hpp>
#include <hexagait/math/trigonometry.hpp>

namespace hexagait {
namespace {

Pose upright(const Pose& X) { return {rotation_z(portable::atan2(X.R(1, 0), X.R(0, 0))), X.p}; }

}  // namespace

void StepFrames::start(const action::Action& action, const Frames& frames,
                       const RobotState& state) noexcept {
  adapted_ = {};
  for (const action::Adaptation& adaptation : action.adapt_coordinates) {
    const Pose X_OS = pose_in_odom(adaptation.source, frames, state);
    const Pose X_TS = pose_in_odom(adaptation.target, frames, state).inverse() * X_OS;
    adapted_[adaptation.source] = {true, adaptation.target,
                                   (adaptation.yaw_only ? upright(X_TS) : X_TS) * adaptation.X_S};
  }
}

Placement StepFrames::place(FrameId frame, const Frames& frames,
                            const RobotState& state) const noexcept {
  Pose X_TA;
  if (adapted_[frame].adapted) {
    X_TA = adapted_[frame].X_TA;
    frame = adapted_[frame].target;
  } else if (frame == kOdom)
    return {false, {}};  // as nearly all are
  if (frame == kBase) return {true, X_TA};
  if (frame >= kFirstRegistered && frames.registered[frame].parent == kBase)
    return {true, frames.registered[frame].X_PA * X_TA};
  return {false, pose_in_odom(frame, frames, state) * X_TA};
}

Pose StepFrames::in_odom(FrameId frame, const Frames& frames,
                         const RobotState& state) const noexcept {
  const Placement placement = place(frame, frames, state);
  return placement.in_body ? state.X_OB * placement.X_PA : placement.X_PA;
}

}  // namespace hexagait
