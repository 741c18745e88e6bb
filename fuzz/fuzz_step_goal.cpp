// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <hexagait/load/load_step_goal.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <testing/argos.hpp>

#include "played.hpp"

// Whatever the bytes: a goal with a number for each of its steps, or InvalidInput with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hexagait;
  static const RobotModel& model = testing::argos();
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const action::StepGoal goal = action::parse_step_goal(text, "fuzz.yaml", model);
    const std::size_t steps = goal.action.steps.size();
    if (steps == 0 || steps != goal.step_numbers.size()) std::abort();
    if (!fuzz::is_bounded(goal.action) || !fuzz::is_played(goal.action, model)) std::abort();
  } catch (const InvalidInput& error) {
    if (error.what()[0] == '\0') std::abort();
  }
  return 0;
}
