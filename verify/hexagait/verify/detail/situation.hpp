// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/verify/rules.hpp>
#include <string>
#include <vector>

/// Time in slices, as in [PC04] 5.1: in each slice feet land, then the gait state is decided, then
/// legs lift. A step lasts T slices.
///
/// A situation determines the future if priorities change only when a step ends. Its successor is
/// computed by the library's update, with a latch and foot positions constructed for the situation.
namespace hexagait::verify {

using gait_state::Adjustment;
using gait_state::GaitState;

/// A gait state, and the remaining air time of each leg.
struct Situation {
  GaitState state;
  std::array<std::int8_t, kMaxLegs> air{};  ///< slices until the foot lands; 0 if it stands
  /// Legs that slipped, and are in the air without a step: they land where they were, with
  /// unchanged relations. Others land at the front.
  LegSet slipped;

  friend bool operator==(const Situation&, const Situation&) = default;
};

[[nodiscard]] LegSet airborne(const Situation& situation) noexcept;

/// For example "<><><>, leg 2 in the air for 3 slices".
[[nodiscard]] std::string to_string(const Situation& situation);

/// All relations of a ring, cyclic ones too, ordered by their bits.
[[nodiscard]] std::vector<GaitState> all_relations(const gait_state::Ring& ring);

/// Those that are not cyclic.
[[nodiscard]] std::vector<GaitState> non_cyclic_states(const gait_state::Ring& ring);

/// Those of n legs with CCN = n/2.
[[nodiscard]] std::vector<GaitState> balanced_states(int n);

/// Lags [m] from which the state follows, with differences much larger than a tie: for each leg,
/// the length of the longest chain of legs that step after it, in centimetres. Greater than −1 cm.
/// @param state  not cyclic
[[nodiscard]] LegArray<double> lags_of(const GaitState& state);

/// The result of one slice.
struct Slice {
  Situation next;
  LegSet lifted;
  GaitState expected;  ///< `> a <` for every `< a >` that landed from a step, otherwise unchanged
};

/// Did the relations change as by [PC04] (2), with lifts of priority legs only?
[[nodiscard]] bool is_step(const Slice& slice) noexcept;

/// Did no leg lift beside a leg in the air?
[[nodiscard]] bool keeps_rule_1(const Slice& slice) noexcept;

/// Which of the legs that may step do so; by default, all.
using Choose = std::function<LegSet(LegSet may_step, LegSet airborne)>;

/// Applies the update of `rules` slice by slice.
class Slices {
 public:
  /// @param ring  of legs 0 … n − 1
  Slices(const Rules& rules, const gait_state::Ring& ring, int step_time, Adjustment adjustment);

  /// The update is called after the landings and again after the lifts, since the control loop is
  /// faster than a slice.
  /// @param situation  of n legs, not cyclic
  [[nodiscard]] Slice advance(const Situation& situation, const Choose& choose = {}) const;

  /// A latch in this situation.
  [[nodiscard]] gait_state::GaitLatch latch_in(const Situation& situation) const;

  int step_time() const { return step_time_; }

 private:
  const Rules& rules_;
  LegSet lost_;
  int n_, step_time_;
  gait_state::GaitParams params_{.tie_tolerance = 1e-3};
  std::vector<LegArray<double>> lags_;  // indexed by the state's bits
};

}  // namespace hexagait::verify
