// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/verify/rules.hpp>
#include <string>
#include <vector>

/// Time in slices, as in [PC04] 5.1: first feet land, then the gait state is decided, then legs
/// lift. A step lasts T slices.
///
/// A situation is all that the future depends on, if priorities change only when a step ends. The
/// library's update is driven with a latch and with foot positions that are made for the situation,
/// slice by slice. So a situation has one successor, and the library finds it.
namespace hexagait::verify {

using gait_state::Adjustment;
using gait_state::GaitState;

/// Relations, and who is in the air for how long.
struct Situation {
  GaitState state;
  std::array<std::int8_t, kMaxLegs> air{};  ///< slices until the foot lands; 0: it stands
  /// Legs in the air that have made no step but lost their hold: they come down where they were,
  /// with the relations that they had. The others land in front.
  LegSet slipped;

  friend bool operator==(const Situation&, const Situation&) = default;
};

[[nodiscard]] LegSet airborne(const Situation& situation) noexcept;

/// "<><><>, leg 2 in the air for 3 slices": legs counted from 0.
[[nodiscard]] std::string to_string(const Situation& situation);

/// All states of n legs that are not cyclic, in the order of their bits.
[[nodiscard]] std::vector<GaitState> non_cyclic_states(int n);

/// Those of them whose CCN is n/2.
[[nodiscard]] std::vector<GaitState> balanced_states(int n);

/// Lags [m] whose order is the state's, each step of it much larger than a tie: the longest row of
/// waiting legs below a leg, in centimetres. Always more than −1 cm.
/// @param state  not cyclic
[[nodiscard]] LegArray<double> lags_of(const GaitState& state);

/// One slice.
struct Slice {
  Situation next;
  LegSet lifted;
  GaitState expected;  ///< every `< a >` that landed from its step turned to `> a <`, no other
};

/// Has it gone as [PC04] (2) says, with lifts of priority legs only?
[[nodiscard]] bool is_step(const Slice& slice) noexcept;

/// Does nobody lift who has a neighbour in the air?
[[nodiscard]] bool keeps_rule_1(const Slice& slice) noexcept;

/// Who of those that may step does: all, unless said otherwise.
using Choose = std::function<LegSet(LegSet may_step, LegSet airborne)>;

/// Drives the update of `rules` through slices.
class Slices {
 public:
  Slices(const Rules& rules, int n, int step_time, Adjustment adjustment);

  /// The update is called after the landings and, the control loop being faster than a slice, once
  /// more when legs have lifted.
  /// @param situation  of n legs, not cyclic
  [[nodiscard]] Slice advance(const Situation& situation, const Choose& choose = {}) const;

  /// Feet and memory of a latch that is in this situation.
  [[nodiscard]] gait_state::GaitLatch latch_in(const Situation& situation) const;

  int step_time() const { return step_time_; }

 private:
  const Rules& rules_;
  int n_, step_time_;
  gait_state::GaitParams params_;
  std::vector<LegArray<double>> lags_;  // by the state's bits
};

}  // namespace hexagait::verify
