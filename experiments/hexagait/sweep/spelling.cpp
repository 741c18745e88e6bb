// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/sweep/spelling.hpp>
#include <numeric>

namespace hexagait::sweep {
namespace {

// Levenshtein's distance, row by row.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> above(b.size() + 1), row(b.size() + 1);
  std::iota(above.begin(), above.end(), 0U);
  for (std::size_t i = 0; i < a.size(); ++i) {
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
      row[j + 1] = std::min({above[j + 1] + 1, row[j] + 1, above[j] + (a[i] == b[j] ? 0U : 1U)});
    above.swap(row);
  }
  return above.back();
}

}  // namespace

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  // The beginning of one, if it says enough.
  for (const std::string& candidate : known)
    if (word.size() >= 3 && candidate.starts_with(word))
      return fmt::format("; did you mean '{}'?", candidate);
  const auto nearest = std::ranges::min_element(
      known, {}, [&](const std::string& candidate) { return distance(word, candidate); });
  if (nearest != known.end() &&
      3 * distance(word, *nearest) <= std::max(word.size(), nearest->size()))
    return fmt::format("; did you mean '{}'?", *nearest);
  return fmt::format("; there are {}", fmt::join(known, ", "));
}

}  // namespace hexagait::sweep
