// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/situation.hpp>

namespace hexagait::verify {

using namespace gait_state;

namespace {

constexpr double kSpacing = 0.01;   // of constructed lags [m]
constexpr double kInFront = -0.01;  // lag of a foot that lands from a step [m]

std::int8_t& air_of(Situation& situation, LegId leg) {
  return situation.air[static_cast<std::size_t>(leg)];
}
int air_of(const Situation& situation, LegId leg) {
  return situation.air[static_cast<std::size_t>(leg)];
}

/// The raw relation of neighbours a, b that are both in the air: is it `a < b`? It dates from when
/// the first of them lifted. If that leg is in a step, the other one slipped later; if a slipped
/// leg is the first to land, the other one lifted first, and the landing must not change anything.
bool second_goes_first(const Situation& situation, LegId a, LegId b) {
  const bool a_lands_first = air_of(situation, a) <= air_of(situation, b);
  const bool first_slipped = situation.slipped.contains(a_lands_first ? a : b);
  return a_lands_first == first_slipped;
}

GaitState raw_of(const Situation& situation) {
  const GaitState& state = situation.state;
  const Ring ring = state.ring();
  const RingBits air = ring_bits(airborne(situation), ring);
  const RingBits next_air = from_after(air, state.n);
  GaitState raw{(state.bits & ~air) | (next_air & ~air), state.n, state.lost};
  for (int k = 0; k < state.n; ++k) {
    if (((air & next_air) >> k & 1U) == 0) continue;
    if (second_goes_first(situation, leg_at(k, ring), leg_at((k + 1) % state.n, ring)))
      raw.bits |= 1U << k;
  }
  return raw;
}

GaitState turned(GaitState state, LegSet landed) {
  for (LegId leg = 0; leg < state.n; ++leg)
    if (landed.contains(leg)) state = after_step(state, leg);
  return state;
}

}  // namespace

LegSet airborne(const Situation& situation) noexcept {
  LegSet legs;
  for (LegId leg = 0; leg < situation.state.n; ++leg) legs.set(leg, air_of(situation, leg) > 0);
  return legs;
}

bool is_step(const Slice& slice) noexcept {
  return slice.next.state == slice.expected &&
         without(slice.lifted, priority_legs(slice.expected)).empty();
}

bool keeps_rule_1(const Slice& slice) noexcept {
  return (neighbours_of(slice.lifted, slice.next.state.ring()) & airborne(slice.next)).empty();
}

std::string to_string(const Situation& situation) {
  std::string text = to_string(situation.state);
  for (LegId leg = 0; leg < situation.state.n; ++leg) {
    const int left = air_of(situation, leg);
    if (left == 0) continue;
    text += fmt::format(", leg {} in the air for {} slice{}{}", leg, left, left == 1 ? "" : "s",
                        situation.slipped.contains(leg) ? " after a slip" : "");
  }
  return text;
}

std::vector<GaitState> all_relations(const Ring& ring) {
  const int n = ring.size();
  std::vector<GaitState> relations;
  for (RingBits bits = 0; bits <= ring_mask(n); ++bits) relations.push_back({bits, n, ring.lost});
  return relations;
}

std::vector<GaitState> non_cyclic_states(const Ring& ring) {
  std::vector<GaitState> states = all_relations(ring);
  std::erase_if(states, [](const GaitState& state) { return state.is_cyclic(); });
  return states;
}

std::vector<GaitState> balanced_states(int n) {
  std::vector<GaitState> states = non_cyclic_states(n);
  std::erase_if(states, [n](const GaitState& state) { return 2 * state.ccn() != n; });
  return states;
}

LegArray<double> lags_of(const GaitState& state) {
  const Ring ring = state.ring();
  LegArray<double> lag(ring.legs, 0.0);
  for (int round = 0; round < state.n; ++round) {
    for (int k = 0; k < state.n; ++k) {
      const bool less = ((state.bits >> k) & 1U) != 0;
      double& a = lag[leg_at(k, ring)];
      double& b = lag[leg_at((k + 1) % state.n, ring)];
      double& first = less ? b : a;
      first = std::max(first, (less ? a : b) + kSpacing);
    }
  }
  return lag;
}

Slices::Slices(const Rules& rules, const Ring& ring, int step_time, Adjustment adjustment)
    : rules_(rules),
      lost_(ring.lost),
      n_(ring.size()),
      step_time_(step_time),
      lags_(std::size_t{1} << n_) {
  params_.adjustment = adjustment;
  for (const GaitState& state : non_cyclic_states(ring)) lags_[state.bits] = lags_of(state);
}

GaitLatch Slices::latch_in(const Situation& situation) const {
  return {situation.state, raw_of(situation), airborne(situation)};
}

Slice Slices::advance(const Situation& situation, const Choose& choose) const {
  GaitLatch latch = latch_in(situation);
  Slice slice{.next = situation, .lifted = {}, .expected = {}};
  GaitInput input{lags_[situation.state.bits], {}, {}, lost_};

  // Landings: at the front after a step, unchanged after a slip.
  LegSet landed;
  for (LegId leg = 0; leg < n_; ++leg) {
    std::int8_t& left = air_of(slice.next, leg);
    if (left == 1 && !situation.slipped.contains(leg)) landed.insert(leg);
    if (left > 0) --left;
  }
  for (LegId leg = 0; leg < n_; ++leg)
    if (landed.contains(leg)) input.lag[leg] = kInFront;
  slice.expected = turned(situation.state, landed);
  slice.next.slipped = situation.slipped & airborne(slice.next);

  // The decision, and lifts.
  input.airborne = airborne(slice.next);
  const GaitDecision decision = rules_.update(latch, input, params_);
  slice.next.state = decision.state;
  slice.lifted = choose ? choose(decision.may_step, input.airborne) : decision.may_step;
  if (slice.lifted.empty()) return slice;
  for (LegId leg = 0; leg < n_; ++leg)
    if (slice.lifted.contains(leg)) air_of(slice.next, leg) = static_cast<std::int8_t>(step_time_);
  input.airborne = airborne(slice.next);
  slice.next.state = rules_.update(latch, input, params_).state;
  return slice;
}

}  // namespace hexagait::verify
