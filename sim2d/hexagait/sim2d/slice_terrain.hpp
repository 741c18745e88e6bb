// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/leg.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace hexagait::sim2d {

/// The ground of the slice model: how many slices a foot needs to come down to it.
///
/// **flat**: 5 slices ([PC04] 5.1).
///
/// **descent**: an integer uniform in descent_min … descent_max, drawn by leg and step index: the
/// k-th step of a leg takes the same time whichever controller makes it, and wherever.
///
/// **profile**: ground that is there. Each leg has a track of its own, of cells as long as `cell`,
/// each at a height uniform in 0 … roughness; heights count in what a foot descends in a slice. The
/// body rides at the mean height of the last footholds. A foot is raised 5 above that level, comes
/// down by 1 a slice while the body carries it on, and stands in the first slice in which it is
/// less than half a slice's descent above the ground below it:
///
///     5 − k + mean_j h_j ≤ h_i(x) + 1/2,    k ≥ 1 slices of descent                     (slice 3)
///
/// On roughness 0 that is flat ground, slice for slice.
struct SliceTerrain {
  enum class Kind : std::uint8_t { flat, descent, profile };
  Kind kind = Kind::flat;
  int descent_min = 3;     ///< descent [slices], ≥ 1
  int descent_max = 7;     ///< descent [slices], ≥ descent_min
  double roughness = 0.0;  ///< profile: height of the highest cell [descent per slice], ≥ 0
  double cell = 50.0;      ///< profile: length of a cell [units], > 0; a stroke of the tripod gait
};

/// The spellings that parse_slice_terrain() takes, for messages and `--help`.
inline constexpr const char* kSliceTerrains = "flat, descent:MIN-MAX or profile:ROUGHNESS";

/// "flat", "descent:3-7" with 1 ≤ 3 ≤ 7 ≤ 1000, or "profile:2.5" with a finite roughness of 0 …
/// 1000. Nothing else.
[[nodiscard]] std::optional<SliceTerrain> parse_slice_terrain(std::string_view text);

/// Inverse of parse_slice_terrain. Allocates.
[[nodiscard]] std::string to_string(const SliceTerrain& terrain);

/// Whose ground: draws are a pure function of it, so every controller meets the same.
struct SliceSeed {
  std::uint64_t seed = 1;
  std::uint32_t trial = 0;
};

/// Slices that the `step`-th step of `leg` takes to descend, on flat ground or in descent mode.
[[nodiscard]] int descent_of(const SliceTerrain& terrain, const SliceSeed& seed, LegId leg,
                             int step) noexcept;

/// Profile mode: which cell of its track a place lies in.
/// @param x  along the way [units], any sign
[[nodiscard]] std::int64_t cell_at(const SliceTerrain& terrain, double x) noexcept;

/// Profile mode: height of a cell of a leg's track [descent per slice], 0 … roughness.
[[nodiscard]] double cell_height(const SliceTerrain& terrain, const SliceSeed& seed, LegId leg,
                                 std::int64_t cell) noexcept;

}  // namespace hexagait::sim2d
