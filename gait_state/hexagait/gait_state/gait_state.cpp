// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/gait_state/gait_state.hpp>

namespace hexagait::gait_state {
namespace {

using detail::priority_positions;

/// The lowest of the preferred candidates, else the lowest of all.
RingBits chosen(RingBits candidates, RingBits preferred) noexcept {
  const RingBits best = (candidates & preferred) != 0 ? candidates & preferred : candidates;
  return best & (~best + 1U);
}

/// Middle relations of `> > <`: raising one favours its later leg.
RingBits raisable(const GaitState& state) noexcept {
  return ~from_before(state.bits, state.n) & ~state.bits & from_after(state.bits, state.n);
}

/// Middle relations of `> < <`: lowering one favours its earlier leg.
RingBits lowerable(const GaitState& state) noexcept {
  return ~from_before(state.bits, state.n) & state.bits & from_after(state.bits, state.n);
}

}  // namespace

LegSet priority_legs(const GaitState& state) noexcept {
  return legs_at(priority_positions(state), state.ring());
}

LegSet may_step(const GaitState& state, LegSet airborne) noexcept {
  const Ring ring = state.ring();
  return legs_at(detail::positions_that_may_step(state, ring_bits(airborne, ring)), ring);
}

GaitType type_of(const GaitState& state) noexcept {
  if (state.n != 6) return GaitType::none;
  const RingBits priority = priority_positions(state);
  const RingBits two_further = from_before(from_before(priority, 6), 6);
  switch (bit_count(priority)) {
    case 1:
      return GaitType::A;
    case 2:
      return (priority & two_further) != 0 ? GaitType::B : GaitType::C;
    case 3:
      return GaitType::D;
    default:
      return GaitType::none;
  }
}

GaitState adjusted(GaitState state, int ccn) noexcept {
  // Each round changes the CCN by one; without a candidate, nothing changes.
  for (int excess = state.ccn() - ccn; excess < 0; ++excess) {
    state.bits |= chosen(raisable(state), kOddPositions);
  }
  for (int excess = state.ccn() - ccn; excess > 0; --excess) {
    state.bits &= ~chosen(lowerable(state), kEvenPositions);
  }
  return state;
}

GaitState balanced(const GaitState& state) noexcept {
  const int ccn = state.ccn(), nearest = std::clamp(ccn, state.n / 2, (state.n + 1) / 2);
  return ccn == nearest ? state : adjusted(state, nearest);
}

GaitState after_step(GaitState state, LegId leg) noexcept {
  assert(priority_legs(state).contains(leg));
  const RingBits after = 1U << position_of(leg, state.ring());
  state.bits &= ~from_after(after, state.n);
  state.bits |= after;
  return state;
}

std::string to_string(const GaitState& state) {
  std::string text;
  for (int k = 0; k < state.n; ++k) text += ((state.bits >> k) & 1U) != 0 ? '<' : '>';
  return text;
}

std::optional<GaitState> parse_gait_state(std::string_view text) noexcept {
  if (text.size() > kMaxLegs || !is_ring_size(static_cast<int>(text.size()))) return std::nullopt;
  GaitState state{0, static_cast<int>(text.size()), {}};
  for (int k = 0; k < state.n; ++k) {
    const char relation = text[static_cast<std::size_t>(k)];
    if (relation != '<' && relation != '>') return std::nullopt;
    if (relation == '<') state.bits |= 1U << k;
  }
  return state;
}

}  // namespace hexagait::gait_state
