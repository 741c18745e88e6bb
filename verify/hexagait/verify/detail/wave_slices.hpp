// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/verify/detail/situations.hpp>
#include <span>

namespace hexagait::verify {

/// A situation and the state of the rear-leg rule (gait 5).
struct WaveSituation {
  Situation legs;
  /// Slices since the lifts of the legs before and after the rear edge, at most the longest period,
  /// after which a leg no longer waits.
  std::array<int, 2> since{};

  friend bool operator==(const WaveSituation&, const WaveSituation&) = default;
};

struct WaveSlice {
  Slice slice;
  WaveSituation next;
};

/// Slices in which the stepper of `rules` decides the lifts.
class WaveSlices {
 public:
  /// @param rear_edge  ring edge between the rear legs
  /// @param longest_period  [slices]
  WaveSlices(const Rules& rules, int n, int step_time, int rear_edge, int longest_period);

  /// @param half_period  the duty factor is 1 − T / (2 half_period) [slices]
  [[nodiscard]] WaveSlice advance(const WaveSituation& situation, int half_period) const;

  /// The situation in which neither rear leg has lifted yet.
  [[nodiscard]] WaveSituation fresh(const Situation& legs) const;

  /// One to one, for situations of `legs`.
  [[nodiscard]] std::size_t key(const Situations& legs, const WaveSituation& situation) const;

 private:
  const Rules& rules_;
  Slices slices_;
  int n_, rear_edge_, longest_period_;
};

/// Is a cycle the exact wave gait: on each side, from the rear forwards, a leg lifts T after the
/// one behind it, and one side lifts half a period after the other?
[[nodiscard]] bool is_wave(std::span<const LegSet> lifted, int n, int step_time, int rear_edge);

}  // namespace hexagait::verify
