// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <hexagait/gait_state/ring.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace hexagait::gait_state {

/// The gait state: who steps first, for each pair of neighbours ([PC04] 3.2).
///
/// `a < b` says that b has the higher priority: it steps before a. The state is the row of the n
/// relations along the ring (gait 1), the last one between position n − 1 and position 0:
///
///     < > < > < >   is   0 < 1 > 3 < 5 > 4 < 2 > 0     (1 < 2 > 4 < 6 > 5 < 3 > 1 in [PC04])
///
/// A leg may step only inside `< a >`. A state of n equal relations is cyclic: it orders nobody,
/// and nobody ever steps. A default-constructed state (n = 0) is "not computed": it counts as
/// cyclic, has no text, and no other function takes it.
struct GaitState {
  RingBits bits = 0;  ///< bit k set: the relation between ring positions k and k + 1 is `<`
  int n = 0;          ///< legs

  /// Clockwise circularity number: how many of the relations are `<` ([PC04] 3.2).
  [[nodiscard]] constexpr int ccn() const noexcept { return std::popcount(bits); }
  [[nodiscard]] constexpr bool is_cyclic() const noexcept {
    return bits == 0 || bits == ring_mask(n);
  }
  friend constexpr bool operator==(const GaitState&, const GaitState&) = default;
};

/// Legs inside `< a >`: those that step before both of their neighbours. Never two neighbours.
/// Empty if and only if the state is cyclic.
[[nodiscard]] LegSet priority_legs(const GaitState& state) noexcept;

/// Legs that may start a step now: priority legs on the ground with both neighbours on the ground.
/// Lifting all of them at once keeps rule 1.
[[nodiscard]] LegSet may_step(const GaitState& state, LegSet airborne) noexcept;

/// The types of [PC04] 3.2, for six legs. A: one leg has priority; B: two that share a neighbour;
/// C: two that don't; D: three. For other rings priority_legs(state).size() says what can be said.
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
/// ends in `> > <`; mirrored above n/2. Neither rule moves a `< >` pair, so whoever was to step
/// first still is.
///
/// The paper leaves open which one, if there is a choice. Either rule lets a leg that waits for
/// both of its neighbours (`> a <`) pass one of them. We take a leg of the first tripod if there is
/// one, as for ties, and of several the relation at the lowest ring position. Six legs have a
/// choice only in type C, between one leg of each tripod, so there the position never decides.
///
/// @param state  not cyclic: no rule applies to a cyclic one, which is returned as it is
/// @param ccn  wanted, normally n/2; between the number of priority legs p and n − p, the least and
///   the greatest CCN with p pairs `< >`
[[nodiscard]] GaitState adjusted(GaitState state, int ccn) noexcept;

/// The state when `leg` has stepped and no other priority has changed: `< a >` becomes `> a <`, and
/// the CCN stays ([PC04] 3.2, eq. 2).
/// @param leg  one of priority_legs(state)
[[nodiscard]] GaitState after_step(GaitState state, LegId leg) noexcept;

/// "<><><>". Allocates: for logs and tests, not inside a tick.
[[nodiscard]] std::string to_string(const GaitState& state);

/// Inverse of to_string; nothing unless `text` is 4, 6, 8, 10 or 12 times `<` or `>`.
[[nodiscard]] std::optional<GaitState> parse_gait_state(std::string_view text) noexcept;

}  // namespace hexagait::gait_state
