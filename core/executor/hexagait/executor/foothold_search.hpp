// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace hexagait {

/// Where a step is to end, seen from where it began.
struct FootholdTry {
  double along = 1.0;   ///< share of the way to the commanded foothold
  double beside = 0.0;  ///< to the left of that way, in widths of the search
};

/// The k-th place of the search for a foothold (swing 5): what is tried, over and over, by a foot
/// that has found ground neither at its foothold, nor nearer, nor where it stood. There is no map, so
/// the places are spread over the way: the body has often gone on, and the next one is within reach.
/// @param k  0, 1, 2, …
[[nodiscard]] constexpr FootholdTry searched_foothold(int k) noexcept {
  constexpr std::array<FootholdTry, 6> kPlaces = {
      {{0.5, 0.0}, {0.75, 1.0}, {0.75, -1.0}, {1.0, 0.0}, {0.25, 1.0}, {0.25, -1.0}}};
  return kPlaces[static_cast<std::size_t>(k) % kPlaces.size()];
}

}  // namespace hexagait
