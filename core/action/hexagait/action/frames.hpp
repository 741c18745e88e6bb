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

/// A frame in which commands are given: four built-in ones and those that the program registers.
using FrameId = std::uint8_t;
inline constexpr FrameId kOdom = 0;       ///< smooth, but drifts; motions are executed in it
inline constexpr FrameId kMap = 1;        ///< of a localisation: does not drift, but may jump
inline constexpr FrameId kBase = 2;       ///< the body; motions given in it move with it
inline constexpr FrameId kFootprint = 3;  ///< mean of the last footprints, z up, yaw of the body
inline constexpr FrameId kFirstRegistered = 4;
inline constexpr int kMaxFrames = 16;

/// The names of the frames, for loaders. `base_link` is an alias of `base`.
class FrameNames {
 public:
  FrameNames();

  /// Registers a frame; its pose is in Frames::registered.
  /// @throws InvalidInput  if the name is taken, or there are kMaxFrames already
  FrameId add(std::string name);

  [[nodiscard]] std::optional<FrameId> find(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// The poses of frames that are not part of odometry. The program may change them between any two
/// ticks: a motion uses the poses at its start, so a jump of the localisation does not affect a
/// foot that is already moving ([FG16] III-C).
struct Frames {
  struct Placed {
    FrameId parent = kMap;  ///< kOdom, kMap or kBase
    Pose X_PA;              ///< pose of this frame in its parent
  };
  Pose X_OM;                                  ///< map in odom
  std::array<Placed, kMaxFrames> registered;  ///< by FrameId, from kFirstRegistered on
};

/// Present pose X_OA of a frame in odom. The footprint is at the mean of the last footprints of all
/// feet (state.print_O), so it does not move while a foot is in the air.
[[nodiscard]] Pose pose_in_odom(FrameId frame, const Frames& frames,
                                const RobotState& state) noexcept;

}  // namespace hexagait
