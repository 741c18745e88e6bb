// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <hexagait/statistics/differences.hpp>
#include <hexagait/sweep/engine.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hexagait::sweep {

/// What is compared: all others with the first of them, all else equal.
enum class Compare { controllers, terrains, robots, plants };
inline constexpr std::array kComparisons = {Compare::controllers, Compare::terrains,
                                            Compare::robots, Compare::plants};
[[nodiscard]] std::string_view to_string(Compare compare);

struct ReportOptions {
  std::string measure = {};  ///< a column of trials.csv; empty for the one that the sweep names
  Compare compare = Compare::controllers;
  bool all_trials = false;  ///< also those that fell, got stuck or ended by a fault
};

/// A mean or, of a column of zeros and ones, a proportion.
struct Measured {
  int count = 0;  ///< trials with a value
  double value = 0.0;
  double lower = 0.0, upper = 0.0;  ///< 95 % confidence interval; infinite for one trial
  std::optional<double> sd = {};    ///< of one trial; a proportion has none
};

/// Less the first.
struct Compared {
  statistics::Difference difference;
  int count = 0;                       ///< pairs, or trials of the smaller sample
  std::optional<double> percent = {};  ///< of the first's mean, unless that is 0
};

/// What the trials of one controller with one robot and plant on one terrain say about a measure.
struct ReportLine {
  std::string robot, plant, terrain, controller;
  double roughness = 0.0;
  std::array<int, kOutcomes.size()> outcomes = {};  ///< trials by how they ended
  std::optional<Measured> value = {};               ///< of those that count and have one
  std::optional<Compared> difference = {};

  [[nodiscard]] int trials() const;
};

/// A sweep in numbers: robots × plants × terrains × controllers.
struct Report {
  std::string directory;
  Column measure;
  std::string roughness_label;
  Compare compare = Compare::controllers;
  std::string first;  ///< the controller, terrain, robot or plant that the others are compared with
  bool paired = true;  ///< by seed; terrains have seeds of their own, and are not
  bool all_trials = false;
  std::vector<ReportLine> lines;
};

/// Reads trials.csv of a sweep. Its rows may stand in any order, and some may be missing: they are
/// paired by terrain, robot, plant and seed.
///
/// A mean is that of the trials that walked on (see walked_on()), unless all are asked for: a robot
/// that lies on its back says nothing of how fast it walks. Proportions are those of all trials,
/// with Wilson's interval.
/// @throws InvalidInput  if the sweep is not finished, a row is damaged or there twice, or there is
///                       no such column of numbers
[[nodiscard]] Report make_report(const std::filesystem::path& directory,
                                 const ReportOptions& options);

/// As a table, and as one JSON object.
[[nodiscard]] std::string in_words(const Report& report);
[[nodiscard]] std::string to_json(const Report& report);

/// "0.067 ± 0.005": the error with one digit, or two if the first is a 1; the value with as many
/// decimals.
[[nodiscard]] std::string with_error(double value, double half_width);

/// Writes STEM.csv, STEM.gp, STEM.svg, STEM.pdf and STEM.png into the directory, with STEM of
/// report_stem().
/// @param headline  above it; empty: none
/// @throws InvalidInput  if it can't be written
void draw(const Report& report, const std::string& headline);

/// "report-speed_m_s", or "report-speed_m_s-terrains": another for every report.
[[nodiscard]] std::string report_stem(const Report& report);

/// "Speed by controller and terrain".
[[nodiscard]] std::string usual_headline(const Report& report);

}  // namespace hexagait::sweep
