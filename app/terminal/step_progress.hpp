// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <hexagait/action/action_feedback.hpp>

namespace hexagait::app {

/// Tells on stderr what an action is doing: one line that updates itself on a terminal, elsewhere a
/// line per step.
class StepProgress {
 public:
  explicit StepProgress(bool quiet);
  ~StepProgress();
  StepProgress(const StepProgress&) = delete;
  StepProgress& operator=(const StepProgress&) = delete;

  void at(const ActionFeedback& feedback);

 private:
  using Clock = std::chrono::steady_clock;

  bool quiet_, terminal_;
  bool line_open_ = false;
  int step_ = 0;
  Clock::time_point shown_;
};

}  // namespace hexagait::app
