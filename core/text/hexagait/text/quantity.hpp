// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hexagait {

/// What a number measures, and so the units that may follow it. Without a unit it is in SI units.
enum class Dimension : std::uint8_t {
  number,        ///< no unit is read
  length,        ///< m, cm, mm
  time,          ///< s, ms, us, min
  angle,         ///< rad, mrad, deg; without a unit at most 2π
  angular_rate,  ///< as an angle, per second or per second squared, but without that bound
};

/// No number that is read from a file or a command line may be larger: sums, quotients and fifth
/// powers of such numbers stay finite.
inline constexpr double kLargestQuantity = 1e9;

/// The least value of what must be more than 0, such as a time to divide by.
inline constexpr double kSmallestQuantity = 1e-9;

/// What a text says, or what is wrong with it.
struct Quantity {
  double value = 0.0;        ///< [SI units, radians]
  std::string problem = {};  ///< names the text and what would be right; empty: nothing is wrong
};

/// Reads a number with or without a unit, such as 0.5, 45deg, deg(45), 5cm or 20ms. A bare angle of
/// more than 2π is refused, since degrees were probably meant.
[[nodiscard]] Quantity parse_quantity(std::string_view text, Dimension dimension);

/// What may be written, with examples, for messages: "an angle such as 45deg or 0.5 (radians)".
[[nodiscard]] std::string_view expected(Dimension dimension);

}  // namespace hexagait
