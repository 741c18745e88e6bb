// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/sim2d/genghis.hpp>
#include <iosfwd>
#include <limits>
#include <vector>

namespace hexagait::recording {

/// What of a walk of Genghis is drawn: the body every 20 ms, every step, every change of the gait
/// state.
class GenghisRecording {
 public:
  /// Genghis at one instant.
  struct Sample {
    double time = 0.0;   ///< since the start [s]
    Vector2 p_WB;        ///< [m]
    double pitch = 0.0;  ///< positive nose up [rad]
    LegArray<Vector2> p_WF;
  };
  /// One step of one leg.
  struct Step {
    LegId leg = 0;
    double lift = 0.0;                                       ///< [s]
    double land = std::numeric_limits<double>::quiet_NaN();  ///< [s]; NaN if it did not
    Vector2 p_WF = Vector2::Zero();                          ///< where it landed [m]
  };
  /// A time in which the gait state had one CCN before adjustment and one type.
  struct GaitSpan {
    double from = 0.0, to = 0.0;  ///< [s]
    int ccn = 0;
    gait_state::GaitType type = gait_state::GaitType::none;
  };

  void observe(const sim2d::GenghisRecord& record, const sim2d::GenghisTruth& truth);

  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }

  /// Comma-separated values, with units in the header.
  void write_body(std::ostream& out) const;
  void write_steps(std::ostream& out) const;
  void write_gait(std::ostream& out) const;

 private:
  double start_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<Sample> samples_;
  std::vector<Step> steps_;
  std::vector<GaitSpan> gait_;
};

/// A trace: the first line, and a line per tick, of comma-separated values.
void write_genghis_trace_header(std::ostream& out);
void write_genghis_trace_row(std::ostream& out, const sim2d::GenghisRecord& record,
                             const sim2d::GenghisTruth& truth);

/// LF RF LM RM LR RR.
[[nodiscard]] const char* genghis_leg_name(LegId leg);

}  // namespace hexagait::recording
