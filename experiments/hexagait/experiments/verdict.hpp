// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/table.hpp>
#include <hexagait/recording/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexagait::experiments {

/// A claim of a paper, tested.
struct Verdict {
  std::string claim;         ///< what the paper says
  bool holds = false;        ///< does it, here?
  std::string numbers;       ///< the measurements that decide it, in words
  std::string why_not = {};  ///< if it is known not to hold: the reason. Such a claim fails no run.

  /// It holds, or it is known why not.
  [[nodiscard]] bool is_accounted_for() const { return holds || !why_not.empty(); }
};

/// What an experiment found.
struct Outcome {
  std::optional<recording::WalkReport> walk = {};  ///< if it is one
  std::vector<Verdict> verdicts = {};
  std::vector<std::pair<std::string, std::string>> settings = {};  ///< if it is no walk
  figures::Table table = {};     ///< its numbers, for the page; may be empty
  double compute_seconds = 0.0;  ///< time that the runs took, without drawing; 0: not measured
};

/// Where the files of an experiment come from.
struct Manifest {
  struct Output {
    std::string name;
    std::uint64_t hash = 0;  ///< FNV-1a of the bytes
  };
  std::string experiment, title;
  Outcome outcome;
  std::vector<Output> outputs;
};

/// The manifest as one JSON object: version, compiler, configuration, results, hashes. Everything
/// that depends on the machine's speed is under "timing".
[[nodiscard]] std::string to_json(const Manifest& manifest);

/// Verdicts of several experiments as one JSON object, by experiment.
[[nodiscard]] std::string to_json(const std::vector<Manifest>& manifests);

}  // namespace hexagait::experiments
