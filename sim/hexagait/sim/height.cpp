// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <charconv>
#include <cmath>
#include <hexagait/sim/height.hpp>

namespace hexagait {
namespace {

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 4> kUnits = {{{"", 1.0}, {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}}};

}  // namespace

ParsedHeight parse_height(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{})
    return {.problem = std::string("\"").append(text).append("\" is not a height")};

  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  for (const Unit& known : kUnits) {
    if (known.name != unit) continue;
    const double metres = value * known.metres;
    if (!std::isfinite(metres)) return {.problem = "the height must be finite"};
    if (metres < 0.0) return {.problem = "the height must not be negative"};
    return {.metres = metres};
  }
  return {.problem =
              std::string("unknown unit \"").append(unit).append("\", it should be m, cm or mm")};
}

}  // namespace hexagait
