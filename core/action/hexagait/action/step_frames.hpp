// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/action.hpp>

namespace hexagait {

/// The frame in which something is executed, and where the frame it was given in is in that one.
struct Placement {
  bool in_body = false;  ///< else in odom
  Pose X_PA;
};

/// Where the frames of an action are. Those that the action adapts were fixed to their target frame
/// when it started; all others are taken as they are at the moment of the call ([FG16] III-C:
/// "right before the execution").
class StepFrames {
 public:
  /// Fixes the adapted frames of an action that starts now.
  void start(const action::Action& action, const Frames& frames, const RobotState& state) noexcept;

  /// What is given in the body, or in a frame fixed to it, is executed there and moves along.
  [[nodiscard]] Placement place(FrameId frame, const Frames& frames,
                                const RobotState& state) const noexcept;

  /// X_OA now, for what is executed in odom in any case.
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
