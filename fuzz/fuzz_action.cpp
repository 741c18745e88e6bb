// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <hexagait/load/load_action.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <testing/argos.hpp>

#include "played.hpp"

namespace hexagait {
namespace {

// What the executor counts on.
bool is_sound(const action::Action& action, const RobotModel& model) {
  for (const action::Step& step : action.steps) {
    LegSet legs;
    if (!(step.wait.duration >= 0.0)) return false;
    if (step.legs.empty() && !step.base && step.custom.empty() && step.wait.duration == 0.0)
      return false;
    for (const action::LegCommand& command : step.legs) {
      const LegId leg = leg_motion(command).leg;
      if (leg < 0 || leg >= model.num_legs() || legs.contains(leg)) return false;
      legs.insert(leg);
    }
  }
  return !action.steps.empty() && action.steps.size() <= action::kMaxSteps &&
         fuzz::is_bounded(action) && fuzz::is_played(action, model);
}

}  // namespace
}  // namespace hexagait

// Whatever the bytes: an action that is sound, or InvalidInput with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hexagait;
  static const RobotModel& model = testing::argos();
  static const action::ActionVocabulary vocabulary = [] {
    action::ActionVocabulary words;
    words.frames.add("door");
    words.custom_types = {"lamp", "gripper"};
    words.placeholders = {{"height", "0.2"}, {"target", "[0.3, 0.2, 0]"}};
    return words;
  }();
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const action::Action action = action::parse_action(text, "fuzz.yaml", model, vocabulary);
    if (!is_sound(action, model)) std::abort();
  } catch (const InvalidInput& error) {
    if (error.what()[0] == '\0') std::abort();
  }
  return 0;
}
