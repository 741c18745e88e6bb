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
  for (int k = facts.n - 1; k >= 0; --k) {
    const double lag_a = input.lag[leg_at(k, facts.ring)];
    facts.a_lags |= RingBits{lag_a - lag_b > tolerance} << k;
    facts.b_lags |= RingBits{lag_b - lag_a > tolerance} << k;
    lag_b = lag_a;
  }
  // Where b belongs to the first tripod, it wins ties. The last edge of an odd ring is between two of
  // them, and has no ties.
  facts.b_first = select(kOddPositions, ~facts.a_lags, facts.b_lags);
  const RingBits last = 1U << (facts.n - 1);
  if (facts.n % 2 == 1)
    facts.b_first = select(last, first_lag > input.lag[leg_at(facts.n - 1, facts.ring)] ? last : 0U,
                           facts.b_first);
  return facts;
}

GaitState fresh_relations(const EdgeFacts& facts) noexcept {
  const RingBits one_airborne = facts.a_airborne ^ facts.b_airborne;
  return {select(one_airborne, facts.b_airborne, facts.b_first) & ring_mask(facts.n), facts.n,
          facts.ring.lost};
}

/// The raw relations (gait 3) with hysteresis.
GaitState raw_relations(const EdgeFacts& facts, const GaitLatch& before,
                        const GaitState& fresh) noexcept {
  // Hysteresis applies to edges whose legs both stood at the last update too.
  const RingBits was_airborne = ring_bits(before.airborne, facts.ring);
  const RingBits settled =
      facts.both_on_ground() & ~was_airborne & ~from_after(was_airborne, facts.n);
  const RingBits contradicted = select(before.raw.bits, facts.a_lags, facts.b_lags);
  const RingBits kept = facts.both_airborne() | (settled & ~contradicted);
  return {select(kept, before.raw.bits, fresh.bits), facts.n, facts.ring.lost};
}

}  // namespace

GaitState fresh_relations(const GaitInput& input, double tie_tolerance) noexcept {
  return fresh_relations(edge_facts(input, tie_tolerance));
}

Combined combine(const LatchStep& step) noexcept {
  const int n = step.raw_now.n;
  const RingBits urgent = ring_bits(step.urgent, step.raw_now.ring());
  const RingBits changed = step.raw_before.bits ^ step.raw_now.bits;
  const RingBits reconsidered = changed | urgent | from_after(urgent, n);
  const GaitState latched{select(reconsidered, step.raw_now.bits, step.stored.bits), n,
                          step.raw_now.lost};
  return latched.is_cyclic() ? Combined{step.fresh, true} : Combined{latched, false};
}

GaitDecision GaitLatch::update(const GaitInput& input, const GaitParams& params) noexcept {
  const EdgeFacts facts = edge_facts(input, params.tie_tolerance);
  const GaitState fresh = fresh_relations(facts);
  if (raw.ring() != facts.ring) *this = {fresh, fresh, input.airborne};

  // Without the latch, only the raw relations are remembered.
  const bool is_latched = params.adjustment == Adjustment::latched;
  const GaitState raw_now = raw_relations(facts, *this, fresh);
  const Combined combined = combine({.stored = is_latched ? stored : raw,
                                     .raw_before = raw,
                                     .raw_now = raw_now,
                                     .fresh = fresh,
                                     .urgent = input.urgent});
  GaitDecision decision;
  decision.raw = combined.was_cyclic ? fresh : raw_now;
  decision.state = combined.state;
  decision.ccn_before_adjustment = combined.state.ccn();
  decision.was_cyclic = combined.was_cyclic;
  if (params.adjustment != Adjustment::none) {
    decision.state = balanced(combined.state);
  }
  decision.priority = priority_legs(decision.state);
  decision.may_step = gait_state::may_step(decision.state, input.airborne);

  *this = {decision.state, decision.raw, input.airborne};
  return decision;
}

}  // namespace hexagait::gait_state
