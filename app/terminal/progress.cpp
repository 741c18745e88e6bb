// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace hexagait::app {
namespace {

constexpr double kPatience = 2.0;  // nothing is said before [s]
constexpr double kRefresh = 0.2;   // of the line on a terminal [s]

}  // namespace

std::string duration(double seconds) {
  constexpr double kMinute = 60.0, kHour = 3600.0, kDay = 86400.0, kYear = 365.25 * kDay;
  if (seconds < 2.0 * kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2.0 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  if (seconds < 2.0 * kDay) return fmt::format("{:.1f} h", seconds / kHour);
  if (seconds < 2.0 * kYear) return fmt::format("{:.0f} days", seconds / kDay);
  return fmt::format("{:.2g} years", seconds / kYear);
}

Progress::Progress(double whole, Measure measure, bool quiet)
    : whole_(whole),
      measure_(measure),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      shown_(start_) {}

Progress::~Progress() {
  if (line_open_) fmt::print(stderr, "\r\033[K");
}

void Progress::at(double done) {
  if (quiet_) return;
  const Clock::time_point now = Clock::now();
  const double wall = std::chrono::duration<double>(now - start_).count();
  if (wall < kPatience) return;

  const int tenths = static_cast<int>(10.0 * done / whole_ + 1e-9);
  const bool due =
      terminal_ ? std::chrono::duration<double>(now - shown_).count() > kRefresh : tenths > tenths_;
  if (!due) return;
  tenths_ = tenths;
  shown_ = now;
  line_open_ = terminal_;
  fmt::print(stderr, "{}{}{}", terminal_ ? "\r\033[K" : "", line(done, wall),
             terminal_ ? "" : "\n");
  std::fflush(stderr);
}

std::string Progress::line(double done, double wall) const {
  const double rate = done / wall;
  const double left = std::max(0.0, whole_ - done) / rate;
  std::string text = fmt::format("{:3.0f} %", 100.0 * done / whole_);
  if (measure_ == Measure::simulated_seconds)
    text += fmt::format("  {:.1f} of {:.1f} s simulated, {:.1f} × real time", done, whole_, rate);
  if (measure_ == Measure::trials)
    text += fmt::format("  {:.0f} of {:.0f} trials, {:.{}f} per second", done, whole_, rate,
                        rate < 10.0 ? 2 : 0);
  return text + ", " + duration(left) + " left";
}

}  // namespace hexagait::app
