// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hexagait::testing {

inline constexpr double kDt = 0.002;  ///< control period of most tests [s]

}  // namespace hexagait::testing
