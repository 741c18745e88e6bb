// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>

namespace hexagait {

/// Largest number of legs a robot may have. Per-leg storage is inline up to this count.
inline constexpr int kMaxLegs = 12;

/// Index of a leg, 0 … n − 1. Even indices are left legs, odd ones right legs, pairs count from the
/// front: for six legs 0 … 5 = LF RF LM RM LR RR, which are legs 1 … 6 of [PC04] Fig. 2.
using LegId = int;

/// A set of legs, one bit per leg.
class LegSet {
 public:
  constexpr LegSet() = default;
  constexpr explicit LegSet(std::uint32_t bits) : bits_(bits) {}

  /// All of n legs.
  static constexpr LegSet all(int n) { return LegSet((1U << n) - 1U); }

  constexpr bool contains(LegId leg) const { return ((bits_ >> leg) & 1U) != 0; }
  constexpr void insert(LegId leg) { bits_ |= 1U << leg; }
  constexpr void erase(LegId leg) { bits_ &= ~(1U << leg); }
  constexpr void set(LegId leg, bool member) { member ? insert(leg) : erase(leg); }
  constexpr int size() const { return std::popcount(bits_); }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr std::uint32_t bits() const { return bits_; }

  friend constexpr bool operator==(LegSet, LegSet) = default;
  friend constexpr LegSet operator|(LegSet a, LegSet b) { return LegSet(a.bits_ | b.bits_); }
  friend constexpr LegSet operator&(LegSet a, LegSet b) { return LegSet(a.bits_ & b.bits_); }

  /// All members of `a` that are not in `b`.
  friend constexpr LegSet without(LegSet a, LegSet b) { return LegSet(a.bits_ & ~b.bits_); }

 private:
  std::uint32_t bits_ = 0;
};

/// One value per leg, stored inline. The number of legs is a property of the robot, set once.
template <class T>
class LegArray {
 public:
  LegArray() = default;
  explicit LegArray(int n) : size_(n) { assert(0 <= n && n <= kMaxLegs); }
  LegArray(int n, const T& value) : LegArray(n) { values_.fill(value); }

  int size() const { return size_; }

  T& operator[](LegId leg) {
    assert(0 <= leg && leg < size_);
    return values_[static_cast<std::size_t>(leg)];
  }
  const T& operator[](LegId leg) const {
    assert(0 <= leg && leg < size_);
    return values_[static_cast<std::size_t>(leg)];
  }

  T* begin() { return values_.data(); }
  T* end() { return values_.data() + size_; }
  const T* begin() const { return values_.data(); }
  const T* end() const { return values_.data() + size_; }

 private:
  std::array<T, kMaxLegs> values_{};
  int size_ = 0;
};

}  // namespace hexagait
