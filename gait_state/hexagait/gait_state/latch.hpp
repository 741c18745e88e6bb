// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/gait_state/gait_state.hpp>

/// The gait state of a walking robot over time ([PC04] 3.3).
///
/// **Raw relation** of ring neighbours a (before) and b (after), with lags δ and tolerance ε:
///
///   1. one in the air: it has priority
///   2. both on the ground: a < b if δ_a < δ_b, the leg that lags more goes first         (gait 3)
///   3. |δ_a − δ_b| ≤ ε: a tie; the leg of the first tripod goes first
///   4. both in the air (start-up, fault, slip): unchanged
///
/// Hysteresis: while both legs stay on the ground, a relation is reversed only when the lags
/// contradict it by more than ε. Noise of less than ε/2 on each lag then reverses no tie and no
/// order clearer than 2ε, and any other relation at most once. After one of the two has lifted and
/// landed, the lags decide without hysteresis.
///
/// **The latch.** [PC04] adjusts the CCN at every time slice. Taken literally (all relations
/// recomputed, then adjusted) the adjustment has no effect: it never changes a `< >` pair, so it
/// lets the same legs step, and the next slice discards it. It works if adjusted relations persist.
/// So we deviate from the paper:
///
///     stored ← raw now       where that differs from the raw relation at the update before
///     stored ← raw now       next to an urgent leg
///     stored ← stored        elsewhere: nothing has happened there                      (gait 4)
///     stored ← fresh         everywhere, if the above has made it cyclic
///     state = stored ← adjusted(stored, n/2)
///
/// **Never cyclic.** Old adjusted relations and new raw ones can combine to `<<<<<<`, in which no
/// leg ever steps. `fresh` is the raw state without memory: rules 1 to 3, with the lags deciding
/// also where both legs are in the air. It is never cyclic. If some legs are in the air and some
/// are not, the ring has an edge `ground < air` and an edge `air > ground`. Otherwise the lags
/// decide on every edge: `<` requires that δ rises by more than ε into a leg of the second tripod,
/// and does not fall by more than ε into one of the first. These alternate, so n equal relations
/// would make δ rise, or fall, all the way round the ring. (Ties make the proof necessary: "within
/// ε" is not transitive.)
///
/// **Odd rings**, which have lost a leg, have one edge between two legs of the first tripod, the last
/// one. It has no ties: `<` if δ_b > δ_a, else `>`. So `<` on every edge requires that δ rises by more
/// than ε on (n − 1)/2 edges, falls by at most ε on as many, and rises on the last; likewise `>`. With
/// ties on that edge too, a ring of five could be cyclic.
namespace hexagait::gait_state {

/// What to do with a state whose CCN is not n/2.
enum class Adjustment {
  latched,  ///< adjusted, and the adjusted relations persist (gait 4)
  none,     ///< the raw relations, not adjusted; for comparison
  literal,  ///< [PC04] taken literally: the raw relations of each update, adjusted; the same legs
            ///< step as with `none`
};

struct GaitParams {
  /// ε: largest difference of tied lags, and width of the hysteresis [m of path], ≥ 0. Less than
  /// twice the noise of a lag: noise changes relations while nothing happens, and each change
  /// discards the adjustment. Too large: legs near the end of their reach wait for legs of the
  /// first tripod that are not. 0: only equal lags are tied.
  double tie_tolerance = 0.0;
  Adjustment adjustment = Adjustment::latched;
};

struct GaitInput {
  LegArray<double> lag;  ///< δ: foot behind its workspace centre, along the path [m], finite
  LegSet airborne;       ///< legs that do not stand on the ground
  LegSet urgent;         ///< legs whose lag has used up 80 % of their reach
  LegSet lost = {};      ///< legs over which the ring closes; they have no relations
};

/// The result of an update.
///
/// A leg in the air is inside `< a >` of `state` if it lifted when it was allowed to. One that
/// slipped may have kept an adjusted relation instead; `may_step` excludes its neighbours in either
/// case.
struct GaitDecision {
  GaitState raw;                  ///< raw relations, with hysteresis
  GaitState state;                ///< the gait state; never cyclic
  int ccn_before_adjustment = 0;  ///< CCN of the stored relations before the last line of (gait 4)
  bool was_cyclic = false;  ///< the stored relations were cyclic and were replaced by fresh ones
  LegSet priority;          ///< legs inside `< a >` of `state`
  LegSet may_step;          ///< those on the ground with both neighbours on the ground
};

/// The raw state without memory (`fresh` above); never cyclic. With equal lags and all feet on the
/// ground, the first tripod steps.
[[nodiscard]] GaitState fresh_relations(const GaitInput& input, double tie_tolerance) noexcept;

/// The inputs of combine().
struct LatchStep {
  GaitState stored;      ///< after the previous update, not cyclic
  GaitState raw_before;  ///< at the previous update
  GaitState raw_now;     ///< may be cyclic: hysteresis is not transitive
  GaitState fresh;       ///< not cyclic
  LegSet urgent;
};
struct Combined {
  GaitState state;  ///< before the adjustment; not cyclic
  bool was_cyclic = false;
};

/// The first four lines of (gait 4).
[[nodiscard]] Combined combine(const LatchStep& step) noexcept;

/// The state between updates. A value: a copy continues identically. The first update, and one
/// whose ring is another one, starts from fresh relations.
struct GaitLatch {
  GaitState stored;  ///< gait state of the last update
  GaitState raw;     ///< raw relations of the last update, or the fresh ones if they replaced them
  LegSet airborne;   ///< at the last update

  /// One update, at any rate: it does not depend on time. Does not allocate.
  /// @param input  lag.size() is the number of legs, lost ones too
  [[nodiscard]] GaitDecision update(const GaitInput& input, const GaitParams& params = {}) noexcept;
};

}  // namespace hexagait::gait_state
