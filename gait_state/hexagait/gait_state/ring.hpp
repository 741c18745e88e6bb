// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <hexagait/math/leg.hpp>

/// The ring: the clockwise circuit around the robot, seen from above, in which neighbours are legs
/// that must not be in the air together ([PC04] 3.1, Fig. 2).
///
///     position   0  1  2  3 …  n/2   n/2+1 …  n−2  n−1
///     leg        0  1  3  5 …  n−1    n−2  …   4    2                                (gait 1)
///
/// Down the right side from the front, up the left one. Six legs are in the order 0 1 3 5 4 2, in
/// the paper's numbers 1 2 4 6 5 3. A robot has an even number of legs, 4 to 12. Where legs are lost
/// the ring closes over them: those that are left keep their order and are counted anew, so a ring
/// has 3 to 12 positions and may be odd.
namespace hexagait::gait_state {

/// One bit per ring position k: for the leg at that position, or for the edge from it to the next.
using RingBits = std::uint32_t;

[[nodiscard]] constexpr bool is_ring_size(int n) noexcept {
  return n % 2 == 0 && 4 <= n && n <= kMaxLegs;
}

/// The legs of a ring. A number of legs stands for the ring of all of them.
struct Ring {
  int legs = 0;  ///< of the robot, lost ones too: even, 4 to 12
  LegSet lost;

  // NOLINTNEXTLINE(google-explicit-constructor): see above
  constexpr Ring(int all = 0, LegSet gone = {}) noexcept : legs(all), lost(gone) {}

  /// Number n of its positions.
  [[nodiscard]] constexpr int size() const noexcept { return legs - lost.size(); }
  /// Those that are in it.
  [[nodiscard]] constexpr LegSet present() const noexcept {
    return without(LegSet::all(legs), lost);
  }
  friend constexpr bool operator==(const Ring&, const Ring&) = default;
};

/// All positions, or all edges, of the ring.
[[nodiscard]] constexpr RingBits ring_mask(int n) noexcept { return (1U << n) - 1U; }

/// Bit k of the result is bit k − 1: that of the previous position, counter-clockwise.
[[nodiscard]] constexpr RingBits from_before(RingBits bits, int n) noexcept {
  return ((bits << 1) | (bits >> (n - 1))) & ring_mask(n);
}

/// Bit k of the result is bit k + 1: that of the next position, clockwise.
[[nodiscard]] constexpr RingBits from_after(RingBits bits, int n) noexcept {
  return ((bits >> 1) | (bits << (n - 1))) & ring_mask(n);
}

namespace detail {

/// Of a ring that has lost no leg.
[[nodiscard]] constexpr LegId leg_at(int position, int n) noexcept {
  assert(is_ring_size(n) && 0 <= position && position < n);
  if (position == 0) return 0;
  return 2 * position <= n ? 2 * position - 1 : 2 * (n - position);
}

/// Lookup tables from sets of legs to ring positions and back, six legs at a time.
struct RingTable {
  std::array<std::uint8_t, kMaxLegs> leg{};  ///< leg_at()
  std::array<std::array<std::uint16_t, 64>, 2> to_ring{}, to_legs{};

  constexpr explicit RingTable(int n) {
    for (int k = 0; k < n; ++k)
      leg[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(leg_at(k, n));
    for (unsigned half = 0; half < 2; ++half) {
      for (unsigned six = 0; six < 64; ++six) {
        for (int k = 0; k < n; ++k) {
          to_ring[half][six] |=
              static_cast<std::uint16_t>((six << 6 * half >> leg_at(k, n) & 1) << k);
          to_legs[half][six] |=
              static_cast<std::uint16_t>((six << 6 * half >> k & 1) << leg_at(k, n));
        }
      }
    }
  }
};
inline constexpr std::array kRingTables = {RingTable(4), RingTable(6), RingTable(8), RingTable(10),
                                           RingTable(12)};

[[nodiscard]] constexpr const RingTable& ring_table(int n) noexcept {
  assert(is_ring_size(n));
  return kRingTables[static_cast<std::size_t>(n / 2 - 2)];
}

[[nodiscard]] constexpr RingBits in_ring(LegSet legs, const RingTable& table) noexcept {
  return RingBits{table.to_ring[0][legs.bits() & 63U]} |
         RingBits{table.to_ring[1][legs.bits() >> 6 & 63U]};
}

/// The bits without those of the gaps, which close.
[[nodiscard]] constexpr RingBits closed(RingBits bits, RingBits gaps) noexcept {
  for (; gaps != 0; gaps ^= std::bit_floor(gaps)) {
    const RingBits below = std::bit_floor(gaps) - 1U;
    bits = (bits & below) | (bits >> 1 & ~below);
  }
  return bits;
}

/// Inverse of closed(); nobody is in a gap.
[[nodiscard]] constexpr RingBits opened(RingBits bits, RingBits gaps) noexcept {
  for (; gaps != 0; gaps &= gaps - 1U) {
    const RingBits below = (gaps & (~gaps + 1U)) - 1U;
    bits = (bits & below) | (bits & ~below) << 1;
  }
  return bits;
}

}  // namespace detail

/// Visits the legs of the ring from its last position to its first.
template <class Visit>
constexpr void for_each_backwards(const Ring& ring, Visit&& visit) {
  const detail::RingTable& table = detail::ring_table(ring.legs);
  for (int k = ring.legs - 1; k >= 0; --k) {
    const LegId leg = table.leg[static_cast<std::size_t>(k)];
    if (!ring.lost.contains(leg)) visit(leg);
  }
}

[[nodiscard]] constexpr RingBits ring_bits(LegSet legs, const Ring& ring) noexcept {
  const detail::RingTable& table = detail::ring_table(ring.legs);
  const RingBits bits = detail::in_ring(legs, table);
  return ring.lost.empty() ? bits : detail::closed(bits, detail::in_ring(ring.lost, table));
}

/// Inverse of ring_bits().
[[nodiscard]] constexpr LegSet legs_at(RingBits bits, const Ring& ring) noexcept {
  const detail::RingTable& table = detail::ring_table(ring.legs);
  if (!ring.lost.empty()) bits = detail::opened(bits, detail::in_ring(ring.lost, table));
  return LegSet(RingBits{table.to_legs[0][bits & 63U]} |
                RingBits{table.to_legs[1][bits >> 6 & 63U]});
}

/// @param position  0 … n − 1
[[nodiscard]] constexpr LegId leg_at(int position, const Ring& ring) noexcept {
  assert(0 <= position && position < ring.size());
  if (ring.lost.empty()) return detail::leg_at(position, ring.legs);
  return std::countr_zero(legs_at(1U << position, ring).bits());
}

/// Inverse of leg_at().
[[nodiscard]] constexpr int position_of(LegId leg, const Ring& ring) noexcept {
  assert(ring.present().contains(leg));
  return std::countr_zero(ring_bits(LegSet(1U << leg), ring));
}

/// The two neighbours of a leg.
struct Neighbours {
  LegId before = 0;  ///< counter-clockwise
  LegId after = 0;   ///< clockwise
};

[[nodiscard]] constexpr Neighbours neighbours_of(LegId leg, const Ring& ring) noexcept {
  const int k = position_of(leg, ring), n = ring.size();
  return {leg_at(k == 0 ? n - 1 : k - 1, ring), leg_at(k == n - 1 ? 0 : k + 1, ring)};
}

/// All legs with a neighbour in `legs`.
[[nodiscard]] constexpr LegSet neighbours_of(LegSet legs, const Ring& ring) noexcept {
  const RingBits bits = ring_bits(legs, ring);
  const int n = ring.size();
  return legs_at(from_before(bits, n) | from_after(bits, n), ring);
}

/// [PC04] rule 1: never two neighbours off the ground at the same time.
[[nodiscard]] constexpr bool breaks_rule_1(LegSet airborne, const Ring& ring) noexcept {
  const RingBits bits = ring_bits(airborne, ring);
  return (bits & from_after(bits, ring.size())) != 0;
}

/// Of the legs that lift, those with a neighbour that lifts too or is off the ground already.
[[nodiscard]] constexpr LegSet rule_1_violations(LegSet lifts, LegSet airborne,
                                                 const Ring& ring) noexcept {
  return lifts & neighbours_of(lifts | airborne, ring);
}

/// Positions 0, 2, 4, …; as edges, those whose earlier leg belongs to the first tripod.
inline constexpr RingBits kEvenPositions = 0x555U;
/// Positions 1, 3, 5, …; as edges, those whose later leg belongs to the first tripod.
inline constexpr RingBits kOddPositions = 0xAAAU;

/// Every other leg of the ring, starting with leg 0: of six legs 0 3 4 (1, 4, 5 in [PC04]). These
/// win ties. Of two neighbours exactly one belongs to it.
[[nodiscard]] constexpr LegSet first_tripod(int n) noexcept {
  return legs_at(kEvenPositions & ring_mask(n), n);
}

/// The other legs: of six, 1 2 5 (2, 3, 6 in [PC04]).
[[nodiscard]] constexpr LegSet second_tripod(int n) noexcept {
  return legs_at(kOddPositions & ring_mask(n), n);
}

}  // namespace hexagait::gait_state
