// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace hexagait::experiments {

/// How the joints of a leg turn.
enum class LegLayout : std::uint8_t {
  yaw_pitch_pitch,   ///< most robots with six legs
  leaning,           ///< the same, the first axis off the vertical by up to 20°
  four_joints,       ///< the same as the first, with an ankle
  roll_pitch_pitch,  ///< legs below the body, as mammals have them
};
[[nodiscard]] const char* to_string(LegLayout layout);

/// A robot that nobody has seen before.
struct RandomRobot {
  std::uint64_t seed = 0;
  int legs = 0;
  LegLayout layout = LegLayout::yaw_pitch_pitch;
  bool round = false;  ///< hips on a circle, not in two rows
  std::string urdf;
};

/// Draws one: sizes from 0.12 to 1.6 m, as often in each octave; 4 to 10 legs; proportions, layout,
/// axes, limits and masses uniform within what robots have. A pure function of the seed.
[[nodiscard]] RandomRobot random_robot(std::uint64_t seed);

}  // namespace hexagait::experiments
