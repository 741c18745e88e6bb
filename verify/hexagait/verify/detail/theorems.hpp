// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/verify/verify.hpp>

/// One function per theorem: it checks every case and reports the first counterexample.
namespace hexagait::verify {

inline constexpr int kLegs = 6;             ///< where a theorem is about six
inline constexpr double kTolerance = 1e-3;  ///< ε of the lags [m]

/// The 62 states of six legs by CCN and type: one class up to rotation in each cell ([PC04] Table
/// 1).
[[nodiscard]] Theorem states(const Rules& rules, const Scope& scope);

/// (gait 2) ends at n/2 from every state and keeps every `< >` pair.
[[nodiscard]] Theorem adjustment(const Rules& rules, const Scope& scope);

/// From any stored, raw and urgent inputs the update ends in a balanced state in which a leg may
/// step.
[[nodiscard]] Theorem no_lock(const Rules& rules, const Scope& scope);

/// No leg ever lifts beside a leg in the air.
[[nodiscard]] Theorem rule_1(const Rules& rules, const Scope& scope);

/// From CCN = n/2 the tripod gait appears from every situation, in less than n/2 step times.
[[nodiscard]] Theorem convergence(const Rules& rules, const Scope& scope, const Progress& progress);

/// With the latch, the tripod gait appears from every other CCN too.
[[nodiscard]] Theorem latched_convergence(const Rules& rules, const Scope& scope);

/// Without adjustment, min(CCN, n − CCN) legs are in the air on average, and the tripod gait
/// appears only if CCN = n/2.
[[nodiscard]] Theorem throughput(const Rules& rules, const Scope& scope);

/// The resulting speed in the slice model of [PC04] 5.1.
[[nodiscard]] Theorem speed(const Rules& rules, const Scope& scope);

/// The paper taken literally walks as if there were no adjustment.
[[nodiscard]] Theorem literal_reading(const Rules& rules, const Scope& scope);

/// The rear-leg rule (gait 5) has one attractor, the exact wave gait.
[[nodiscard]] Theorem wave_gaits(const Rules& rules, const Scope& scope);

/// The same if the duty factor changes at any slice.
[[nodiscard]] Theorem duty_factor_changes(const Rules& rules, const Scope& scope);

/// Odd rings, of legs that are left: never cyclic, balanced, and a leg may step.
[[nodiscard]] Theorem odd_no_lock(const Rules& rules, const Scope& scope);

/// Rule 1 for six legs of which any one is lost.
[[nodiscard]] Theorem odd_rule_1(const Rules& rules, const Scope& scope);

/// (n − 1)/2 legs of an odd ring are in the air on average, and all step equally often.
[[nodiscard]] Theorem odd_throughput(const Rules& rules, const Scope& scope);

}  // namespace hexagait::verify
