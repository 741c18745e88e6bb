// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/walk/actions/action_trial.hpp>
#include <string>

#include "options/action_input.hpp"

namespace hexagait::app {

/// An action that was checked, and perhaps carried out.
struct ActionReport {
  const ActionInput* input = nullptr;
  Preview ahead;
  walk::ActionSummary summary;  ///< of `run`
  bool interrupted = false;     ///< by the user
};

/// The first findings of every kind, a line each as compilers write them, and how many more there
/// are: later ones mostly follow from the first.
[[nodiscard]] std::string findings(const ActionReport& report);

/// The verdict of a check, in a line.
[[nodiscard]] std::string check_verdict(const ActionReport& report);
[[nodiscard]] std::string check_json(const ActionReport& report);

/// How it went: a sentence; with it a few aligned lines; all of it as one JSON object.
[[nodiscard]] std::string run_headline(const ActionReport& report);
[[nodiscard]] std::string run_in_words(const ActionReport& report);
[[nodiscard]] std::string run_json(const ActionReport& report);

}  // namespace hexagait::app
