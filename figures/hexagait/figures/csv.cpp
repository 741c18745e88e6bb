// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/figures/csv.hpp>
#include <iterator>

namespace hexagait::figures {

void Csv::add(double value) {
  if (!std::isnan(value)) fmt::format_to(std::back_inserter(text_), "{:.9g}", value);
  text_ += ',';
}

void Csv::add(std::string_view value) {
  if (value.find_first_of(",\"\n\r") == std::string_view::npos) {
    text_ += value;
  } else {
    text_ += '"';
    for (const char letter : value) text_.append(letter == '"' ? 2 : 1, letter);
    text_ += '"';
  }
  text_ += ',';
}

}  // namespace hexagait::figures
