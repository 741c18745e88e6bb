// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/verify/detail/theorems.hpp>
#include <hexagait/verify/verify.hpp>

namespace hexagait::verify {

TheoremReport verify(const Rules& rules, const Scope& scope, const Progress& progress) {
  TheoremReport report;
  double done = 0.0;
  // `share`: approximate fraction of the total time.
  const auto finish = [&](Theorem theorem, double share) {
    report.theorems.push_back(std::move(theorem));
    done += share;
    if (progress) progress(done);
  };
  finish(states(rules, scope), 0.0);
  finish(adjustment(rules, scope), 0.0);
  finish(no_lock(rules, scope), 0.11);
  finish(rule_1(rules, scope), 0.11);
  constexpr double kConvergence = 0.5;
  finish(convergence(rules, scope,
                     [&](double share) {
                       if (progress) progress(done + kConvergence * share);
                     }),
         kConvergence);
  finish(latched_convergence(rules, scope), 0.11);
  finish(throughput(rules, scope), 0.03);
  finish(speed(rules, scope), 0.03);
  finish(literal_reading(rules, scope), 0.02);
  finish(wave_gaits(rules, scope), 0.09);
  finish(duty_factor_changes(rules, scope), 0.0);
  finish(odd_no_lock(rules, scope), 0.0);
  finish(odd_rule_1(rules, scope), 0.0);
  finish(odd_throughput(rules, scope), 0.0);
  return report;
}

}  // namespace hexagait::verify
