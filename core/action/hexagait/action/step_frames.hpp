// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/action.hpp>

namespace hexagait {

/// The frame P in which a motion is executed, and the pose in it of the frame A of its command.
struct Placement {
  bool in_body = false;  ///< P is the body frame, otherwise odom
  Pose X_PA;
};

/// The poses of the frames of an action. Frames that the action adapts are fixed to their target
/// frame when it starts; all others have their pose at the time of the call ([FG16] III-C: "right
/// before the execution").
class StepFrames {
 public:
  /// Starts an action: fixes its adapted frames.
  void start(const action::Action& action, const Frames& frames, const RobotState& state) noexcept;

  /// Commands given in the body frame, or in one fixed to it, are executed there.
  [[nodiscard]] Placement place(FrameId frame, const Frames& frames,
                                const RobotState& state) const noexcept;

  /// X_OA, for motions that are executed in odom in any case.
  [[nodiscard]] Pose in_odom(FrameId frame, const Frames& frames,
                             const RobotState& state) const noexcept;

 private:
  struct Adapted {
    bool adapted = false;
    FrameId target = kOdom;
    Pose X_TA;
  };
  std::array<Adapted, kMaxFrames> adapted_;
};

}  // namespace hexagait
