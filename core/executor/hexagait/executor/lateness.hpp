// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace hexagait {

/// How late drives are: 0 up to the lag of prompt ones, 1 from twice that on, and linear between.
/// @param lag     of the drives [s]
/// @param prompt  at most [s]
[[nodiscard]] inline double lateness(double lag, double prompt) noexcept {
  return std::clamp(lag / prompt - 1.0, 0.0, 1.0);
}

}  // namespace hexagait
