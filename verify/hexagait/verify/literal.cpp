// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/situation.hpp>
#include <hexagait/verify/detail/theorems.hpp>

namespace hexagait::verify {

using namespace gait_state;

namespace {

/// All lags that differ by ±0.8 or ±1.5 tolerances from each leg to the next on the ring: ties,
/// orders, and chains of ties whose ends are not tied.
std::vector<LegArray<double>> rows_of_lags(double tolerance) {
  const std::array steps = {-1.5 * tolerance, -0.8 * tolerance, 0.8 * tolerance, 1.5 * tolerance};
  std::vector<LegArray<double>> rows;
  for (unsigned code = 0; code < 1U << 2 * (kLegs - 1); ++code) {
    LegArray<double> row(kLegs, 0.0);
    for (int k = 1; k < kLegs; ++k)
      row[leg_at(k, kLegs)] = row[leg_at(k - 1, kLegs)] + steps[code >> 2 * (k - 1) & 3];
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

Theorem literal_reading(const Rules& rules, const Scope&) {
  Theorem theorem;
  theorem.name = "literal_reading";
  theorem.statement =
      "[PC04] 3.3 taken literally, with relations recomputed in every slice and then adjusted, "
      "walks "
      "exactly as without adjustment: the same legs step in every slice.";
  theorem.convention =
      "Six legs. One update of both from the same raw memory and the same feet: every raw memory, "
      "every set of legs in the air that keeps rule 1, lags that differ by ±0.8 or ±1.5 tolerances "
      "from leg to leg: a grid, not all lags that there can be. The same legs may step and both "
      "remember the same, so the next feet are the same, and so on by induction.";
  theorem.table.columns = {"raw", "sets_in_the_air", "rows_of_lags", "adjusted_in_vain"};

  constexpr double kTolerance = 1e-3;  // the lags are multiples of it
  const GaitParams literal{.tie_tolerance = kTolerance, .adjustment = Adjustment::literal};
  const GaitParams none{.tie_tolerance = kTolerance, .adjustment = Adjustment::none};
  const auto rows = rows_of_lags(kTolerance);
  std::int64_t sets = 0, in_vain = 0;
  for (std::uint32_t air = 0; air <= ring_mask(kLegs); ++air) {
    if (breaks_rule_1(LegSet(air), kLegs)) continue;
    ++sets;
    for (RingBits raw = 0; raw <= ring_mask(kLegs); ++raw) {
      for (const LegArray<double>& lags : rows) {
        const GaitInput input{lags, LegSet(air), {}};
        const GaitState memory{raw, kLegs};
        GaitLatch a{rules.adjusted(memory, kLegs / 2), memory, LegSet(air)};
        GaitLatch b{memory, memory, LegSet(air)};
        const GaitDecision with = rules.update(a, input, literal);
        const GaitDecision without = rules.update(b, input, none);
        theorem.check(with.may_step == without.may_step && a.raw == b.raw, [&] {
          return fmt::format("raw memory {}: adjusted {}, not adjusted {}", to_string(memory),
                             to_string(with.state), to_string(without.state));
        });
        in_vain += with.state == without.state ? 0 : 1;
        ++theorem.cases;
      }
    }
  }
  theorem.table.add(1 << kLegs, sets, static_cast<std::int64_t>(rows.size()), in_vain);
  return theorem;
}

}  // namespace hexagait::verify
