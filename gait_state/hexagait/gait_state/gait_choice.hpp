// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/gait_state/latch.hpp>
#include <hexagait/gait_state/stepper.hpp>

namespace hexagait::gait_state {

/// The choice of a gait: its parameters of latch and stepper.
struct GaitChoice {
  Adjustment adjustment = Adjustment::latched;
  StepperParams stepper = {};
  /// The controller feels nothing, neither feet nor joints: steps end when they were planned to, and
  /// nothing waits.
  bool open_loop = false;
};

/// The gaits that parse_gait_choice() accepts, for messages and `--help`.
inline constexpr const char* kGaitChoices =
    "free, unadjusted, literal, tripod, clocked or wave:BETA";

/// Reads "free", "unadjusted" (no CCN adjustment), "literal" (the adjustment of [PC04] taken
/// literally), "tripod" (waits for all legs), "clocked" (the tripods in turn by the clock, in open
/// loop) or "wave:BETA" with a duty factor 1/2 ≤ BETA < 1.
/// @returns nothing for any other text
[[nodiscard]] std::optional<GaitChoice> parse_gait_choice(std::string_view text);

/// Inverse of parse_gait_choice(). Allocates.
[[nodiscard]] std::string to_string(const GaitChoice& choice);

}  // namespace hexagait::gait_state
