// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hexagait::detail {

// The shape of a step in the measures of RobotScale, as its time and the parameters know it.
inline constexpr double kStroke = 0.91, kHeight = 0.45;  // of ℓ
inline constexpr double kSidewaysSpeed = 2.93;           // over the ground, of ℓ/T
inline constexpr double kBodySpeed = 0.33;               // which the body has then, of ℓ/T
inline constexpr double kTransferTime = 1.18;            // of T
inline constexpr double kDescentSpeed = 0.44;            // of ℓ/T
inline constexpr double kLiftTime = 0.62;                // of T
inline constexpr double kHaste = 1.4;                    // of swings on level ground

}  // namespace hexagait::detail
