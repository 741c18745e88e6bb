// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace hexagait::app {

/// "12 s", "3 min", "5.2 h", "41 days", "3.2 years".
[[nodiscard]] std::string duration(double seconds);

/// Tells on stderr how far something of more than 2 s has got: one line that updates itself on a
/// terminal, elsewhere a line per 10 %.
class Progress {
 public:
  /// What there is to do.
  enum class Measure {
    simulated_seconds,
    share,  ///< 0 … 1
    trials,
  };
  Progress(double whole, Measure measure, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param done  so far, of `whole`
  void at(double done);

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] std::string line(double done, double wall) const;

  double whole_;
  Measure measure_;
  bool quiet_, terminal_;
  Clock::time_point start_, shown_;
  int tenths_ = 0;
  bool line_open_ = false;
};

}  // namespace hexagait::app
