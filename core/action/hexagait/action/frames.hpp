// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <hexagait/plant/robot_state.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait {

/// A frame in which commands are given. The first four are always there; those after them are
/// registered by the program.
using FrameId = std::uint8_t;
inline constexpr FrameId kOdom = 0;       ///< smooth, drifts: where everything is executed
inline constexpr FrameId kMap = 1;        ///< of a localisation: true on average, may jump
inline constexpr FrameId kBase = 2;       ///< the body; what is given in it moves along with it
inline constexpr FrameId kFootprint = 3;  ///< centre of where the feet last stood, z up, body's yaw
inline constexpr FrameId kFirstRegistered = 4;
inline constexpr int kMaxFrames = 16;

/// The names of the frames, for loaders. `base_link` is another name of base.
class FrameNames {
 public:
  FrameNames();

  /// Registers a frame; its pose is given by Frames::poses.
  /// @throws InvalidInput  if the name is taken, or kMaxFrames are there
  FrameId add(std::string name);

  [[nodiscard]] std::optional<FrameId> find(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// Where the frames are that odometry does not know, as the program last heard. May be changed
/// between any two ticks: a motion takes the poses of the moment in which it starts, so a jump of
/// the localisation moves no foot that is under way ([FG16] III-C).
struct Frames {
  struct Placed {
    FrameId parent = kMap;  ///< kOdom, kMap or kBase
    Pose X_PA;              ///< pose of this frame in its parent
  };
  Pose X_OM;                                  ///< map in odom
  std::array<Placed, kMaxFrames> registered;  ///< [id]; used from kFirstRegistered on
};

/// Pose X_OA of a frame in odom at this moment. The footprint stands in the mean of where each foot
/// last stood (state.print_O), so that it stays where it is while a foot is in the air.
[[nodiscard]] Pose pose_in_odom(FrameId frame, const Frames& frames,
                                const RobotState& state) noexcept;

}  // namespace hexagait
