// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <hexagait/math/geometry.hpp>

/// Two legs at once. Every x86-64 processor adds, multiplies and divides two doubles in one instruction,
/// each rounded as if it were alone: a lane holds the bits that the same sum of one leg has.
namespace hexagait {

/// A number of each of two legs.
using Lanes = double __attribute__((vector_size(16)));

[[nodiscard]] constexpr Lanes both(double value) { return Lanes{value, value}; }

/// The bits of two numbers. Of a comparison: all of a lane are set where it is true.
using LaneBits = unsigned long long __attribute__((vector_size(16)));

[[nodiscard]] inline Lanes root(Lanes x) { return Lanes{std::sqrt(x[0]), std::sqrt(x[1])}; }
[[nodiscard]] inline Lanes magnitude(Lanes x) {
  constexpr LaneBits kNoSign = {0x7fffffffffffffff, 0x7fffffffffffffff};
  return reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(x) & kNoSign);
}
template <class Facts>
[[nodiscard]] bool all(const Facts& facts) {
  return (facts[0] & facts[1]) != 0;
}

/// A vector of each of two legs, by coordinates.
struct LaneVector {
  Lanes x, y, z;
};

[[nodiscard]] inline LaneVector lanes(const Vector3& a, const Vector3& b) {
  return {Lanes{a.x(), b.x()}, Lanes{a.y(), b.y()}, Lanes{a.z(), b.z()}};
}
[[nodiscard]] inline Vector3 lane(const LaneVector& v, int k) { return {v.x[k], v.y[k], v.z[k]}; }

}  // namespace hexagait
