// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/step_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace hexagait::app {
StepProgress::StepProgress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

StepProgress::~StepProgress() {
  if (line_open_) fmt::print(stderr, "\r\033[K");
}

void StepProgress::at(const ActionFeedback& feedback) {
  if (quiet_ || feedback.step == 0) return;
  constexpr std::chrono::milliseconds kRefresh(100);  // of the line on a terminal
  const Clock::time_point now = Clock::now();
  const bool is_new = feedback.step != step_;
  if (!is_new && (!terminal_ || now - shown_ < kRefresh)) return;
  step_ = feedback.step;
  shown_ = now;
  line_open_ = terminal_;
  if (terminal_)
    fmt::print(stderr, "\r\033[Kstep {}/{}  {:3.0f} %  {}", step_, feedback.steps,
               100.0 * feedback.phase, feedback.description);
  else
    fmt::print(stderr, "step {}/{}: {}, {:.2f} s\n", step_, feedback.steps, feedback.description,
               feedback.duration);
  std::fflush(stderr);
}

}  // namespace hexagait::app
