// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/text/nearest_word.hpp>
#include <numeric>
#include <utility>
#include <vector>

namespace hexagait {
namespace {

constexpr std::size_t kLongestWord = 64;

}  // namespace

int word_distance(std::string_view a, std::string_view b) {
  // Row i, column j: the distance between the first i letters of a and the first j of b.
  std::vector<int> two_above, above(b.size() + 1), row(b.size() + 1);
  std::iota(above.begin(), above.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    row[0] = above[0] + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({above[j + 1] + 1, row[j] + 1, above[j] + (a[i] == b[j] ? 0 : 1)});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
        row[j + 1] = std::min(row[j + 1], two_above[j - 1] + 1);
    }
    two_above = std::exchange(above, row);
  }
  return above.back();
}

std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> known) {
  if (word.size() > kLongestWord) return {};

  // The beginning of one, if it says enough.
  for (const std::string& candidate : known)
    if (word.size() >= 3 && candidate.starts_with(word)) return candidate;

  const auto distance = [&](const std::string& candidate) {
    return word_distance(word, candidate);
  };
  const auto nearest = std::ranges::min_element(known, {}, distance);
  if (nearest == known.end()) return {};
  const std::size_t longer = std::max(word.size(), nearest->size());
  if (3 * static_cast<std::size_t>(distance(*nearest)) > longer) return {};
  return *nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const std::optional<std::string> meant = nearest_word(word, known);
  return meant ? "; did you mean '" + *meant + "'?" : "";
}

}  // namespace hexagait
