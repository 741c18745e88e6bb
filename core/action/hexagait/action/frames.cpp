// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/action/frames.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait {
namespace {

Pose footprint(const RobotState& state) {
  Vector3 centre = Vector3::Zero();
  for (const Vector3& print : state.print_O) centre += print;
  const Matrix3& R = state.X_OB.R;
  return {rotation_z(portable::atan2(R(1, 0), R(0, 0))), centre / state.print_O.size()};
}

// Poses of the built-in frames.
Pose fixed_frame(FrameId frame, const Frames& frames, const RobotState& state) {
  switch (frame) {
    case kMap:
      return frames.X_OM;
    case kBase:
      return state.X_OB;
    case kFootprint:
      return footprint(state);
    default:
      return {};
  }
}

}  // namespace

FrameNames::FrameNames() : names_{"odom", "map", "base", "footprint"} {}

FrameId FrameNames::add(std::string name) {
  if (find(name)) throw InvalidInput("frame \"" + name + "\": the name is already taken");
  if (names_.size() == kMaxFrames)
    throw InvalidInput("frame \"" + name + "\": there are " + std::to_string(kMaxFrames) +
                       " frames already, the maximum");
  names_.push_back(std::move(name));
  return static_cast<FrameId>(names_.size() - 1);
}

std::optional<FrameId> FrameNames::find(std::string_view name) const {
  if (name == "base_link") return kBase;
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) return std::nullopt;
  return static_cast<FrameId>(found - names_.begin());
}

Pose pose_in_odom(FrameId frame, const Frames& frames, const RobotState& state) noexcept {
  if (frame < kFirstRegistered || frame >= kMaxFrames) return fixed_frame(frame, frames, state);
  const Frames::Placed& placed = frames.registered[frame];
  return fixed_frame(placed.parent, frames, state) * placed.X_PA;
}

}  // namespace hexagait
