// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/gait_state/stepper.hpp>

namespace hexagait::verify {

/// The functions under test, by default those of the library that the walker calls. Tests replace
/// one of them by a faulty one to show that the theorems then fail.
struct Rules {
  std::function<gait_state::GaitDecision(gait_state::GaitLatch&, const gait_state::GaitInput&,
                                         const gait_state::GaitParams&)>
      update = [](auto& latch, const auto& input, const auto& params) {
        return latch.update(input, params);
      };
  std::function<gait_state::GaitState(gait_state::GaitState, int)> adjusted = gait_state::adjusted;
  std::function<gait_state::Combined(const gait_state::LatchStep&)> combine = gait_state::combine;
  std::function<LegSet(gait_state::Stepper&, const gait_state::StepperInput&,
                       const gait_state::StepperParams&)>
      step = [](auto& stepper, const auto& input, const auto& params) {
        return stepper.update(input, params);
      };
};

}  // namespace hexagait::verify
