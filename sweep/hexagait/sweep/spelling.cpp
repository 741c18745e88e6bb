// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/sweep/spelling.hpp>
#include <hexagait/text/nearest_word.hpp>

namespace hexagait::sweep {

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  if (const std::optional<std::string> nearest = nearest_word(word, known))
    return fmt::format("; did you mean '{}'?", *nearest);
  return fmt::format("; there are {}", fmt::join(known, ", "));
}

}  // namespace hexagait::sweep
