// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/gait_state/gait_state.hpp>

/// The gait state of a walking robot, update by update ([PC04] 3.3).
///
/// **Raw relation** of ring neighbours a (before) and b (after), with lags δ and tolerance ε:
///
///   1. one in the air: it has priority
///   2. both on the ground: a < b if δ_a < δ_b, the leg that lags more goes first         (gait 3)
///   3. |δ_a − δ_b| ≤ ε: a tie; the one of the first tripod goes first
///   4. both in the air (start-up, fault, slip): as it was
///
/// Hysteresis. While both stay on the ground, a relation turns round only when the lags contradict
/// it by more than ε: a tie is left, and an order reversed, at ε on the far side. Noise of less
/// than ε/2 on each lag then turns no tie and no order clearer than 2ε, and any other relation at
/// most once. When one of the two has lifted and landed there is nothing to hold on to: the lags
/// decide afresh.
///
/// **The latch.** [PC04] adjusts the CCN at every time slice. Taken literally (all relations
/// computed anew, then adjusted) the adjustment is inert: it never moves a `< >` pair, so it lets
/// the same legs step, and at the next slice it is forgotten. It works if an adjusted relation
/// persists. So, a deviation from the paper's words:
///
///     stored ← raw now       where that differs from the raw relation at the update before
///     stored ← raw now       next to an urgent leg
///     stored ← stored        elsewhere: there nothing happened                          (gait 4)
///     stored ← fresh         everywhere, if the above has made it cyclic
///     state = stored ← adjusted(stored, n/2)
///
/// **Never cyclic.** Old adjusted relations and new raw ones can add up to `<<<<<<`, in which
/// nobody steps for ever. `fresh` is the raw state without any memory: rules 1 to 3, and the lags
/// also where both are in the air. It is never cyclic. If some leg is in the air and some not, the
/// ring has an edge `ground < air` and an edge `air > ground`. Otherwise the lags decide on every
/// edge: `<` needs a rise of more than ε into a leg of the second tripod, and no fall of more than
/// ε into one of the first. These alternate, so n equal relations would make δ rise, or fall, all
/// the way round the ring. It is for ties that this needs proof: "within ε" is not transitive, but
/// neighbours are of different tripods.
namespace hexagait::gait_state {

/// What becomes of a state whose CCN is not n/2.
enum class Adjustment {
  latched,  ///< adjusted, and the adjusted relations persist (gait 4)
  none,     ///< not adjusted: the raw relations, to compare with
  literal,  ///< [PC04] to the letter: raw relations at each update, then adjusted; lets the same
            ///< legs step as `none`
};

struct GaitParams {
  /// ε: lags that differ by no more are tied, and the width of the hysteresis [m of path], ≥ 0.
  /// Below twice the noise of a lag, noise re-decides relations while nothing happens, and each
  /// time wipes out the adjustment. Too large, and legs near the end of their reach wait for legs
  /// that are not: the first tripod's. Source: our choice, 1 % of a stride of 10 cm.
  double tie_tolerance = 1e-3;
  Adjustment adjustment = Adjustment::latched;
};

struct GaitInput {
  LegArray<double> lag;  ///< δ: foot behind its workspace centre, along the path [m], finite
  LegSet airborne;       ///< legs that are not in contact with the ground
  LegSet urgent;         ///< legs whose lag has used up 80 % of their reach
};

/// All that an update computed.
///
/// A leg in the air is inside `< a >` of `state` if it lifted when it was allowed to. One that lost
/// its hold instead may keep an adjusted relation; `may_step` holds its neighbours back all the
/// same.
struct GaitDecision {
  GaitState raw;                  ///< raw relations, with hysteresis
  GaitState state;                ///< the gait state; never cyclic
  int ccn_before_adjustment = 0;  ///< CCN of the stored relations before the last line of (gait 4)
  bool was_cyclic = false;        ///< the stored relations were cyclic and gave way to fresh ones
  LegSet priority;                ///< legs inside `< a >` of `state`
  LegSet may_step;                ///< those on the ground with both neighbours on the ground
};

/// The raw state without memory (`fresh` above). Never cyclic. With equal lags, all feet on the
/// ground: the first tripod steps.
[[nodiscard]] GaitState fresh_relations(const GaitInput& input, double tie_tolerance) noexcept;

/// What (gait 4) combines.
struct LatchStep {
  GaitState stored;      ///< after the previous update, not cyclic
  GaitState raw_before;  ///< at the previous update
  GaitState raw_now;     ///< may be cyclic: hysteresis is not transitive
  GaitState fresh;       ///< not cyclic
  LegSet urgent;
};
struct Combined {
  GaitState state;  ///< not yet adjusted; not cyclic
  bool was_cyclic = false;
};

/// The first four lines of (gait 4).
[[nodiscard]] Combined combine(const LatchStep& step) noexcept;

/// The memory between updates. A value: a copy continues identically. The first update, and one
/// with another number of legs, starts from fresh relations.
struct GaitLatch {
  GaitState stored;  ///< gait state of the last update
  GaitState raw;     ///< raw relations of the last update; fresh ones if those had to step in
  LegSet airborne;   ///< at the last update

  /// One update, at any rate: time does not enter. No allocation.
  /// @param input  lag.size() is the number of legs
  [[nodiscard]] GaitDecision update(const GaitInput& input, const GaitParams& params = {}) noexcept;
};

}  // namespace hexagait::gait_state
