// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
#include <hexagait/figures/csv.hpp>
#include <hexagait/recording/json.hpp>
#include <hexagait/recording/provenance.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexagait::experiments {

/// What an experiment found.
struct Outcome {
  std::optional<recording::WalkReport> walk = {};  ///< if it is one
  std::vector<Verdict> verdicts = {};
  std::vector<std::pair<std::string, std::string>> settings = {};  ///< if it is no walk
  /// Model, physics and controller, if it is no walk but has some.
  std::optional<recording::Provenance> provenance = {};
  figures::Csv table = {};  ///< its numbers, for the page; may be empty
  bool judges_all = true;   ///< false: fewer trials were asked for than the claims need
  /// If only a part of its walks was asked for: what the user does next. Then all else is empty.
  std::string left = {};
  double compute_seconds = 0.0;  ///< time that the runs took, without drawing; 0: not measured
};

/// Where the files of an experiment come from.
struct Manifest {
  struct Output {
    std::string name;
    std::uint64_t hash = 0;  ///< FNV-1a of the bytes
  };
  std::string experiment, title;
  bool short_form = false;
  Outcome outcome;
  std::vector<Output> outputs;
  recording::Provenance provenance = {};
  recording::PlantSetup plant = {};  ///< if it is another one, no claim is judged

  /// Each claim holds, fails as it was declared to, or can't be judged by this run (a short form, too few
  /// trials, another plant); or this is one part of the walks, and claims wait for all parts.
  [[nodiscard]] bool is_accounted_for() const;
};

/// The manifest as one JSON object: provenance, configuration, verdicts, results, hashes. Everything
/// that depends on the machine's speed is under "timing".
[[nodiscard]] std::string to_json(const Manifest& manifest);

/// Verdicts of several experiments as one JSON object, by experiment.
[[nodiscard]] std::string to_json(const std::vector<Manifest>& manifests);

}  // namespace hexagait::experiments
