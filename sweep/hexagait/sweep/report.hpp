// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <hexagait/statistics/statistics.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hexagait::sweep {

/// What the trials of one controller on one terrain say about a measure.
struct ReportLine {
  std::string robot, terrain, controller;
  double roughness = 0.0;
  int trials = 0;                                  ///< with and without a value
  std::optional<statistics::Estimate> value;       ///< of those that have one
  std::optional<statistics::Estimate> difference;  ///< from the first controller, paired by seed
};

/// A sweep in numbers: robots × terrains × controllers.
struct Report {
  std::string directory;
  std::string measure;  ///< a column of trials.csv
  std::string first;    ///< the controller that the others are compared with
  std::vector<ReportLine> lines;
};

/// Reads trials.csv of a sweep.
/// @param measure  a column of it; empty for the one that the sweep names
/// @throws InvalidInput  if the sweep is not finished, or has no such column of numbers
[[nodiscard]] Report make_report(const std::filesystem::path& directory,
                                 const std::string& measure);

/// As a table, and as one JSON object.
[[nodiscard]] std::string in_words(const Report& report);
[[nodiscard]] std::string to_json(const Report& report);

/// Writes report.csv, report.gp, report.svg, report.pdf and report.png into the directory.
/// @throws InvalidInput  if it can't be written
void draw(const Report& report);

}  // namespace hexagait::sweep
