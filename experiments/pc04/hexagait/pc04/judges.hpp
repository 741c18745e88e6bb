// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/experiments/claim.hpp>
#include <hexagait/gait_state/gait_state.hpp>
#include <hexagait/pc04/gait_tables.hpp>
#include <hexagait/pc04/slice_comparison.hpp>
#include <hexagait/recording/genghis.hpp>
#include <hexagait/walk/referee/summary.hpp>

/// The claims of [PC04], judged: what each experiment measured, and the verdicts on it.
namespace hexagait::experiments {

[[nodiscard]] Verdict judge_table1(const std::vector<Table1Cell>& cells);
[[nodiscard]] Verdict judge_table2(const std::vector<Table2Row>& rows);

/// A wave gait of Fig. 3, as section 3.2 tells of it and as it was walked.
struct WaveGait {
  const char* label;         ///< of its duty factor, "5/6"
  const char* spelling;      ///< as a gait choice
  std::string sequence;      ///< types of the gait states, as told
  std::string found = {};    ///< the same, as walked
  int slices = 0;            ///< walked …
  int slices_not_ccn_3 = 0;  ///< … and those of them whose CCN was not 3
  std::string lifts = {};    ///< legs that lift together, in the paper's numbers
};
[[nodiscard]] std::vector<Verdict> judge_fig3(const std::vector<WaveGait>& gaits);

/// Legs with priority that step together, and what becomes of the gait state.
struct Transition {
  gait_state::GaitState from, to;
  LegSet legs;
};
[[nodiscard]] std::vector<Verdict> judge_fig4(const std::vector<Transition>& transitions);

/// The first slices of one walk of Fig. 6.
struct FirstSteps {
  std::vector<double> advance;  ///< per slice [units]
  double mean = 0.0;            ///< of the second half: without the start [units per slice]
  int most_lifts = 0;           ///< most legs in the air at a time
};
/// @param walks  of the tripod controller, the free gait, and the free gait without adjustment
[[nodiscard]] std::vector<Verdict> judge_fig6(const std::array<FirstSteps, 3>& walks);

/// @param comparison  gaits tripod, free, unadjusted, literal, in this order; then any others
[[nodiscard]] std::vector<Verdict> judge_fig7a(const SliceComparison& comparison);

/// Each with gaits tripod, free, …
/// @param rough   grounds on which the free gait is claimed to be ahead: rough enough to be felt,
///                and not rougher than half of the height to which feet are raised
/// @param all     those, and the smoothest and roughest
/// @param sample  whose strokes are compared
[[nodiscard]] std::vector<Verdict> judge_fig7b(const std::vector<SliceComparison>& rough,
                                               const std::vector<SliceComparison>& all,
                                               const SliceComparison& sample);

/// Walks of Genghis in Box2D on one ground: tripod, free, unadjusted. Speeds in cm/s.
using GenghisComparison = GaitComparison<recording::GenghisSummary>;
/// @param grounds  the flat one first, then rougher and rougher
[[nodiscard]] std::vector<Verdict> judge_fig7_physics(
    const std::vector<GenghisComparison>& grounds);

/// @param longest_pause  between two lifts [s]
[[nodiscard]] std::vector<Verdict> judge_fig9(const walk::Summary& summary, double longest_pause);
/// @param drawn   the walk of the figure
/// @param others  the same on other terrains of the same kind
[[nodiscard]] std::vector<Verdict> judge_fig10(const walk::Summary& drawn,
                                               const std::vector<walk::Summary>& others);

/// The time in which a walk kept one duty factor, and what was measured at its end, over whole
/// periods of the right rear leg.
struct WaveSegment {
  double duty_factor = 0.0;
  const char* name = "";        ///< "5/6"
  double from = 0.0, to = 0.0;  ///< [s]
  double judged_from = 0.0;     ///< [s]
  double period = 0.0;          ///< 0: the leg did not lift twice [s]
  double step_time = 0.0;       ///< [s]
  double speed = 0.0;           ///< [m/s]
  double speed_by_law = 0.0;    ///< S m / ((n − m) T), with the step time as measured [m/s]
  double least_duty = 1.0, greatest_duty = 0.0, mean_duty = 0.0;
  double phase_error = 0.0;  ///< of the worst lift, as a share of the period
};
[[nodiscard]] std::vector<Verdict> judge_wave_family(const std::vector<WaveSegment>& segments,
                                                     const walk::Summary& summary);

}  // namespace hexagait::experiments
