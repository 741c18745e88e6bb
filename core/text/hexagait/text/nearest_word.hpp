// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hexagait {

/// How many letters must be put in, left out, exchanged, or swapped with their neighbour to make one
/// word of the other (optimal string alignment). Letters are bytes.
[[nodiscard]] int word_distance(std::string_view a, std::string_view b);

/// The known word that was probably meant: one of which `word` is the beginning, of three letters
/// or more; else the nearest, if at most a third of the letters of the longer of the two are wrong;
/// of equals the first. None if none is near, or if the word is longer than 64 letters.
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view word,
                                                      std::span<const std::string> known);

/// "; did you mean 'nod'?" for messages; empty if no word is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace hexagait
