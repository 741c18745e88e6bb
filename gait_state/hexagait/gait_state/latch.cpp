// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/gait_state/latch.hpp>

namespace hexagait::gait_state {
namespace {

/// The inputs of the raw relations, one bit per edge. Edge k joins leg a at ring position k with
/// leg b at the next one.
struct EdgeFacts {
  Ring ring;
  int n = 0;             ///< of its positions
  RingBits a_lags = 0;   ///< δ_a − δ_b > ε
  RingBits b_lags = 0;   ///< δ_b − δ_a > ε
  RingBits b_first = 0;  ///< both on the ground: a < b, by lag or by tie
  RingBits a_airborne = 0;
  RingBits b_airborne = 0;

  RingBits both_on_ground() const noexcept { return ~(a_airborne | b_airborne); }
  RingBits both_airborne() const noexcept { return a_airborne & b_airborne; }
};

/// For each edge, a where `from_a`, else b.
RingBits select(RingBits from_a, RingBits a, RingBits b) noexcept {
  return (a & from_a) | (b & ~from_a);
}

EdgeFacts edge_facts(const GaitInput& input, double tolerance) noexcept {
  EdgeFacts facts{.ring = {input.lag.size(), input.lost}};
  facts.n = facts.ring.size();
  facts.a_airborne = ring_bits(input.airborne, facts.ring);
  facts.b_airborne = from_after(facts.a_airborne, facts.n);
  const double first_lag = input.lag[leg_at(0, facts.ring)];
  double lag_b = first_lag;
  for_each_backwards(facts.ring, [&](LegId a) {
    const double lag_a = input.lag[a];
    facts.a_lags = facts.a_lags << 1 | RingBits{lag_a - lag_b > tolerance};
    facts.b_lags = facts.b_lags << 1 | RingBits{lag_b - lag_a > tolerance};
    lag_b = lag_a;
  });
  // Where b belongs to the first tripod, it wins ties. The last edge of an odd ring is between two of
  // them, and has no ties.
  facts.b_first = select(kOddPositions, ~facts.a_lags, facts.b_lags);
  const RingBits last = 1U << (facts.n - 1);
  if (facts.n % 2 == 1)
    facts.b_first = select(last, first_lag > input.lag[leg_at(facts.n - 1, facts.ring)] ? last : 0U,
                           facts.b_first);
  return facts;
}

RingBits fresh_relations(const EdgeFacts& facts) noexcept {
  const RingBits one_airborne = facts.a_airborne ^ facts.b_airborne;
  return select(one_airborne, facts.b_airborne, facts.b_first) & ring_mask(facts.n);
}

/// The raw relations (gait 3) with hysteresis.
RingBits raw_relations(const EdgeFacts& facts, const GaitLatch& before, RingBits fresh) noexcept {
  // Hysteresis applies to edges whose legs both stood at the last update too.
  const RingBits was_airborne = ring_bits(before.airborne, facts.ring);
  const RingBits settled =
      facts.both_on_ground() & ~was_airborne & ~from_after(was_airborne, facts.n);
  const RingBits contradicted = select(before.raw.bits, facts.a_lags, facts.b_lags);
  const RingBits kept = facts.both_airborne() | (settled & ~contradicted);
  return select(kept, before.raw.bits, fresh);
}

/// The first four lines of (gait 4), on relations and positions of one ring.
struct Latching {
  RingBits stored, raw_before, raw_now, fresh, urgent;
  int n;
};
struct Latched {
  RingBits bits;
  bool was_cyclic;
};
Latched latched(const Latching& step) noexcept {
  const RingBits changed = step.raw_before ^ step.raw_now;
  const RingBits reconsidered = changed | step.urgent | from_after(step.urgent, step.n);
  const RingBits bits = select(reconsidered, step.raw_now, step.stored);
  const bool is_cyclic = GaitState{bits, step.n, {}}.is_cyclic();
  return {is_cyclic ? step.fresh : bits, is_cyclic};
}

}  // namespace

GaitState fresh_relations(const GaitInput& input, double tie_tolerance) noexcept {
  const EdgeFacts facts = edge_facts(input, tie_tolerance);
  return {fresh_relations(facts), facts.n, input.lost};
}

Combined combine(const LatchStep& step) noexcept {
  const GaitState& now = step.raw_now;
  const Latched result = latched({.stored = step.stored.bits,
                                  .raw_before = step.raw_before.bits,
                                  .raw_now = now.bits,
                                  .fresh = step.fresh.bits,
                                  .urgent = ring_bits(step.urgent, now.ring()),
                                  .n = now.n});
  return {{result.bits, now.n, now.lost}, result.was_cyclic};
}

GaitDecision GaitLatch::update(const GaitInput& input, const GaitParams& params) noexcept {
  const EdgeFacts facts = edge_facts(input, params.tie_tolerance);
  const auto state_of = [&](RingBits bits) { return GaitState{bits, facts.n, input.lost}; };
  const RingBits fresh = fresh_relations(facts);
  if (raw.n != facts.n || raw.lost != input.lost)
    *this = {state_of(fresh), state_of(fresh), input.airborne};

  // Without the latch, only the raw relations are remembered.
  const bool is_latched = params.adjustment == Adjustment::latched;
  const RingBits raw_now = raw_relations(facts, *this, fresh);
  const Latched combined = latched({.stored = is_latched ? stored.bits : raw.bits,
                                    .raw_before = raw.bits,
                                    .raw_now = raw_now,
                                    .fresh = fresh,
                                    .urgent = ring_bits(input.urgent, facts.ring),
                                    .n = facts.n});
  GaitDecision decision;
  decision.raw = state_of(combined.was_cyclic ? fresh : raw_now);
  decision.state = state_of(combined.bits);
  decision.ccn_before_adjustment = decision.state.ccn();
  decision.was_cyclic = combined.was_cyclic;
  if (params.adjustment != Adjustment::none) decision.state = balanced(decision.state);
  decision.priority = legs_at(detail::priority_positions(decision.state), facts.ring);
  decision.may_step =
      legs_at(detail::positions_that_may_step(decision.state, facts.a_airborne), facts.ring);

  *this = {decision.state, decision.raw, input.airborne};
  return decision;
}

}  // namespace hexagait::gait_state
