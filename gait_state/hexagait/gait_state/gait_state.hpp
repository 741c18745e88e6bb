// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/gait_state/ring.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace hexagait::gait_state {

/// The gait state: which of each two neighbours steps first ([PC04] 3.2).
///
/// `a < b` means that b has the higher priority: it steps before a. The state consists of the n
/// relations along the ring (gait 1), the last one between position n − 1 and position 0:
///
///     < > < > < >   is   0 < 1 > 3 < 5 > 4 < 2 > 0     (1 < 2 > 4 < 6 > 5 < 3 > 1 in [PC04])
///
/// A leg may step only inside `< a >`. A state of n equal relations is cyclic: no leg has priority,
/// and none ever steps. A default-constructed state (n = 0) means "not computed": it counts as
/// cyclic, its text is empty, and it is not a valid argument of the other functions.
struct GaitState {
  RingBits bits = 0;  ///< bit k set: the relation between ring positions k and k + 1 is `<`
  int n = 0;          ///< relations: legs of the ring
  LegSet lost = {};   ///< legs of the robot over which the ring has closed

  [[nodiscard]] constexpr Ring ring() const noexcept { return {n + lost.size(), lost}; }

  /// Clockwise circularity number: how many of the relations are `<` ([PC04] 3.2).
  [[nodiscard]] constexpr int ccn() const noexcept { return bit_count(bits); }
  [[nodiscard]] constexpr bool is_cyclic() const noexcept {
    return bits == 0 || bits == ring_mask(n);
  }
  friend constexpr bool operator==(const GaitState&, const GaitState&) = default;
};

namespace detail {
[[nodiscard]] constexpr RingBits priority_positions(const GaitState& state) noexcept {
  return from_before(state.bits, state.n) & ~state.bits;
}
/// @param air  positions of legs that do not stand
[[nodiscard]] constexpr RingBits positions_that_may_step(const GaitState& state,
                                                         RingBits air) noexcept {
  const RingBits barred = air | from_before(air, state.n) | from_after(air, state.n);
  return priority_positions(state) & ~barred;
}
}  // namespace detail

/// Legs inside `< a >`, which step before both of their neighbours. Never two neighbours; empty if
/// and only if the state is cyclic.
[[nodiscard]] LegSet priority_legs(const GaitState& state) noexcept;

/// Legs that may start a step now: priority legs on the ground with both neighbours on the ground.
/// Lifting all of them at once does not break rule 1.
[[nodiscard]] LegSet may_step(const GaitState& state, LegSet airborne) noexcept;

/// The types of [PC04] 3.2, for six legs. A: one leg has priority; B: two that share a neighbour;
/// C: two that do not; D: three. For other rings, see priority_legs(state).size().
enum class GaitType {
  none,  ///< cyclic, or not six legs
  A,
  B,
  C,
  D,
};
[[nodiscard]] GaitType type_of(const GaitState& state) noexcept;

/// CCN adjustment ([PC04] 3.3): the state with exactly `ccn` relations `<` and the same priority
/// legs.
///
///     CCN too small:  replace a `> > <` by `> < <`
///     CCN too large:  replace a `> < <` by `> > <`        until it is right               (gait 2)
///
/// It always ends: below n/2 the `>` outnumber the `<`, so some run of `>` is at least 2 long and
/// ends in `> > <`; likewise, mirrored, above n/2. Neither rule changes a `< >` pair, so the
/// priority legs stay the same.
///
/// The paper leaves open which of several places to replace. Either rule lets a leg that waits for
/// both of its neighbours (`> a <`) pass one of them. We choose a leg of the first tripod if there
/// is one, as for ties, and among several the lowest ring position. Six legs have a choice only in
/// type C, between one leg of each tripod, so there the position never decides.
///
/// @param state  a cyclic state, to which no rule applies, is returned unchanged
/// @param ccn    desired, normally n/2; in [p, n − p] with p priority legs
[[nodiscard]] GaitState adjusted(GaitState state, int ccn) noexcept;

/// adjusted() to the nearest CCN with which most legs are in the air, n/2; in an odd ring, to the
/// nearer one of (n − 1)/2 and (n + 1)/2, which are equally good: m = (n − 1)/2.
[[nodiscard]] GaitState balanced(const GaitState& state) noexcept;

/// The state after `leg` has stepped: `< a >` becomes `> a <`, and the CCN stays ([PC04] 3.2, eq.
/// 2).
/// @param leg  one of priority_legs(state)
[[nodiscard]] GaitState after_step(GaitState state, LegId leg) noexcept;

/// For example "<><><>". Allocates: not for use in a tick.
[[nodiscard]] std::string to_string(const GaitState& state);

/// Inverse of to_string(); nothing unless `text` consists of 4, 6, 8, 10 or 12 `<` or `>`.
[[nodiscard]] std::optional<GaitState> parse_gait_state(std::string_view text) noexcept;

}  // namespace hexagait::gait_state
