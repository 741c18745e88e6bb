// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/gait_state/latch.hpp>
#include <hexagait/gait_state/stepper.hpp>

namespace hexagait::gait_state {

/// Which gait generator walks: the latch's part of the choice and the stepper's.
struct GaitChoice {
  Adjustment adjustment = Adjustment::latched;
  StepperParams stepper = {};
};

/// The spellings that parse_gait_choice() takes, for messages and `--help`.
inline constexpr const char* kGaitChoices = "free, unadjusted, literal, tripod or wave:BETA";

/// "free", "unadjusted" (no CCN adjustment), "literal" ([PC04] to the letter), "tripod" (waiting
/// for all legs), or "wave:0.75" with a duty factor of at least 1/2 and less than 1. Nothing else.
[[nodiscard]] std::optional<GaitChoice> parse_gait_choice(std::string_view text);

/// Inverse of parse_gait_choice. Allocates.
[[nodiscard]] std::string to_string(const GaitChoice& choice);

}  // namespace hexagait::gait_state
