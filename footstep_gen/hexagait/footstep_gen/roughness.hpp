// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <hexagait/executor/commands.hpp>
#include <hexagait/gait_state/stepper.hpp>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/params/robot_params.hpp>

namespace hexagait::footstep_gen {

/// How much higher the highest of the last footprints is than the lowest, along gravity [m].
/// \param print_O  of all legs, in odom; not empty
[[nodiscard]] inline double height_spread(const LegArray<Vector3>& print_O) noexcept {
  double lowest = print_O[0].z(), highest = lowest;
  for (const Vector3& print : print_O) {
    lowest = std::min(lowest, print.z());
    highest = std::max(highest, print.z());
  }
  return highest - lowest;
}

inline constexpr double kSlowFrom = 2.5;  ///< spread without haste, of the step height

/// The spread of ground that no foot has stood on yet: the first steps are as high as over rough
/// ground [m].
[[nodiscard]] inline double unknown_spread(const StepParams& step) noexcept { return step.height; }

/// The spread by which steps are chosen: the greatest of late, less a step height for each two strokes of
/// path since, (step 4) [m].
/// @param before  its value until now [m]
/// @param spread  of the last footprints now [m]
/// @param way     of the robot since [m]
[[nodiscard]] inline double remembered_spread(double before, double spread, double way,
                                              const StepParams& step) noexcept {
  constexpr double kStrokes = 2.0;
  const double fades = step.stroke > 0.0 ? way / (kStrokes * step.stroke) * step.height : before;
  return std::max(spread, std::min(before, kSlowFrom * step.height) - fades);
}

/// The steps for ground as rough as the feet have found it. Lower on level ground; from a spread of
/// (1 − level_height) height on, as high as over rough ground, (step 2). In haste, and down as fast as a guess allows,
/// up to a spread of 1.5 heights; from 2.5 heights on without, (step 3) and (step 9).
[[nodiscard]] inline StepParams on_ground(StepParams step, double spread) noexcept {
  constexpr double kHastyUpTo = 1.5;
  const double range = (kSlowFrom - kHastyUpTo) * step.height;
  const double level = std::clamp(kSlowFrom * step.height - spread, 0.0, range);
  step.haste = range > 0.0 ? 1.0 + (step.haste - 1.0) * level / range : 1.0;
  step.descent = range > 0.0 ? 1.0 + (step.descent - 1.0) * level / range : 1.0;
  step.height = std::min(step.height, step.level_height * step.height + spread);
  return step;
}

/// The steps where the height of the ground is a guess, because the last footprints differ by more than the
/// highest steps need. Feet touch down faster, (step 6): the ground is seldom where a slow touchdown would meet it.
/// Strokes are longer, (step 7): the search for the ground takes more time than the way. From a spread of the
/// height on feet also descend faster, (step 9).
/// \param spread  of the last footprints now [m]
[[nodiscard]] inline StepParams on_guessed_ground(StepParams step, double spread) noexcept {
  constexpr double kLonger = 0.1;
  const auto guess = [&](double from, double to) {
    const double range = (to - from) * step.height;
    return range > 0.0 ? std::clamp((spread - from * step.height) / range, 0.0, 1.0) : 0.0;
  };
  const double guessed = guess(0.65, 0.95);
  step.descent = 1.0 + (step.descent - 1.0) * guess(1.0, 1.3);
  step.touchdown = 1.0 + (step.touchdown - 1.0) * guessed;
  step.stroke *= 1.0 + kLonger * guessed;
  return step;
}

inline constexpr double kLevelUpTo = 0.3;  ///< spread of level ground, of the step height

/// The steps on level ground, where nothing is a guess, (step 10): lower, in more haste, down fast until just
/// above the ground, which they meet no faster for it, and inside the workspace. All of it where the prints don't
/// differ, nothing from a spread of kLevelUpTo heights on.
/// @param step    as on_ground(), with the haste that the drives leave
/// @param spread  of the ground of late, as remembered_spread() [m]
/// @param full    what it was made from
[[nodiscard]] inline StepParams on_level_ground(StepParams step, double spread,
                                                const StepParams& full) noexcept {
  constexpr double kLower = 0.12, kHastier = 0.35, kNearer = 0.7;
  if (!(full.height > 0.0 && full.haste > 1.0)) return step;
  const double hasty = (step.haste - 1.0) / (full.haste - 1.0);
  const double level = hasty * std::max(0.0, 1.0 - spread / (kLevelUpTo * full.height));
  const double haste = step.haste + kHastier * level * (full.haste - 1.0);
  step.height = std::max(0.0, step.height - kLower * level * full.height);
  step.touchdown *= step.haste / haste;
  step.haste = haste;
  step.slow_way -= kNearer * level;
  step.overreach -= level;
  return step;
}

/// From how far below the expected ground on a foot stands on an edge, (step 11) [m]: an eighth of its radius, or by
/// more than the prints differ; infinite where they differ by half its radius.
/// @param spread  of the ground of late, as remembered_spread() [m]
[[nodiscard]] inline double edge_depth(double spread, double foot_radius) noexcept {
  constexpr double kShare = 0.125, kRough = 0.5;
  const double depth = std::max(kShare * foot_radius, spread);
  return depth < kRough * foot_radius ? depth : SearchDepth::kNever;
}

/// The steps where the path leads up or down a slope: from 6 to 9° feet lose the speed that descents gain by (step 9).
/// @param sine  of the slope
[[nodiscard]] inline StepParams on_slope(StepParams step, double sine) noexcept {
  constexpr double kGentle = 0.10, kSteep = 0.15;
  const double gentle = std::clamp((kSteep - std::abs(sine)) / (kSteep - kGentle), 0.0, 1.0);
  step.descent = 1.0 + (step.descent - 1.0) * gentle;
  return step;
}

/// Ground on which a free gait becomes very_rough_gait(): a spread of at least 2.3 step heights, (step 8).
/// \param spread  of late, as remembered_spread() [m]
[[nodiscard]] inline bool very_rough(double spread, const StepParams& step) noexcept {
  constexpr double kFrom = 2.3;
  return step.height > 0.0 && spread >= kFrom * step.height;
}

/// The rear legs wait for each other, but never as if steps took longer than 1.2 times the usual, (step 8).
/// \param step_time  usual [s]
[[nodiscard]] inline gait_state::StepperParams very_rough_gait(double step_time) noexcept {
  constexpr double kLongest = 1.2;
  return {.stepping = gait_state::Stepping::wave,
          .duty_factor = 0.5,
          .longest_step = kLongest * step_time};
}

}  // namespace hexagait::footstep_gen
