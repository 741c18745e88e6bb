// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <utility>

namespace hexagait {

/// Largest number of legs of a robot. Storage per leg is inline, without allocation.
inline constexpr int kMaxLegs = 12;

/// Smallest and largest number of joints of a leg. Legs of one robot may differ.
inline constexpr int kMinLegJoints = 2;
inline constexpr int kMaxLegJoints = 6;

/// Index of a leg, 0 … n − 1. Left legs are even, right legs odd, and pairs are counted from the
/// front: of six legs, 0 … 5 are LF RF LM RM LR RR, legs 1 … 6 of [PC04] Fig. 2.
using LegId = int;

/// How many bits are set. Inline: std::popcount() calls a library, since not every x86-64 processor
/// has an instruction for it.
[[nodiscard]] constexpr int bit_count(std::uint32_t bits) noexcept {
  bits -= bits >> 1 & 0x55555555U;
  bits = (bits & 0x33333333U) + (bits >> 2 & 0x33333333U);
  bits = (bits + (bits >> 4)) & 0x0F0F0F0FU;
  return static_cast<int>(bits * 0x01010101U >> 24);
}

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
  constexpr void set(LegId leg, bool member) {
    bits_ = (bits_ & ~(1U << leg)) | (std::uint32_t{member} << leg);
  }
  constexpr int size() const { return bit_count(bits_); }
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

/// An array of up to kCapacity values, stored inline. A copy costs what is used, not what could be.
template <class T, int kCapacity>
class InlineArray {
 public:
  InlineArray() = default;
  explicit InlineArray(int n) : size_(n) { assert(0 <= n && n <= kCapacity); }
  InlineArray(int n, const T& value) : size_(n) {
    assert(0 <= n && n <= kCapacity);
    std::fill_n(begin(), n, value);
  }
  ~InlineArray() = default;

  InlineArray(const InlineArray& other) { *this = other; }
  InlineArray(InlineArray&& other) noexcept { *this = std::move(other); }
  InlineArray& operator=(const InlineArray& other) {
    size_ = other.size_;
    std::copy_n(other.begin(), size_, begin());
    return *this;
  }
  InlineArray& operator=(InlineArray&& other) noexcept {
    size_ = other.size_;
    std::copy_n(std::make_move_iterator(other.begin()), size_, begin());
    return *this;
  }

  InlineArray& operator=(std::initializer_list<T> values) {
    size_ = static_cast<int>(values.size());
    assert(size_ <= kCapacity);
    std::copy(values.begin(), values.end(), values_.begin());
    return *this;
  }

  int size() const { return size_; }

  T& operator[](int index) {
    assert(0 <= index && index < size_);
    return values_[static_cast<std::size_t>(index)];
  }
  const T& operator[](int index) const {
    assert(0 <= index && index < size_);
    return values_[static_cast<std::size_t>(index)];
  }
  const T& back() const { return (*this)[size_ - 1]; }

  T* begin() { return values_.data(); }
  T* end() { return values_.data() + size_; }
  const T* begin() const { return values_.data(); }
  const T* end() const { return values_.data() + size_; }

 private:
  std::array<T, kCapacity> values_{};
  int size_ = 0;
};

/// One value per leg.
template <class T>
using LegArray = InlineArray<T, kMaxLegs>;

/// One value per joint of a leg, from hip to foot.
template <class T>
using JointArray = InlineArray<T, kMaxLegJoints>;

}  // namespace hexagait
