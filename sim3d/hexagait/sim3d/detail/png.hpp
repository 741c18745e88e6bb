// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/sim3d/heightmap.hpp>

namespace hexagait::sim3d::detail {

/// Reads a grey PNG of up to so many pixels, black as 0 and white as 1.
/// @returns what is wrong with it; empty: nothing
[[nodiscard]] std::string read_png(const std::string& bytes, std::size_t most_pixels,
                                   Heightmap& map);

}  // namespace hexagait::sim3d::detail
