// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/sim2d/genghis.hpp>
#include <string>

namespace hexagait::recording {

/// A walk of Genghis in the side view, and how it went.
struct GenghisReport {
  sim2d::GenghisTrial trial;
  sim2d::GenghisSummary summary;
  bool interrupted = false;  ///< stopped by the user
};

/// One JSON object, indented, with the keys of the walk in space where they make sense.
[[nodiscard]] std::string to_json(const GenghisReport& report);

/// For a person: in a sentence, in a line of numbers, and both with all the rest.
[[nodiscard]] std::string headline(const GenghisReport& report);
[[nodiscard]] std::string subtitle(const GenghisReport& report);
[[nodiscard]] std::string in_words(const GenghisReport& report);

}  // namespace hexagait::recording
