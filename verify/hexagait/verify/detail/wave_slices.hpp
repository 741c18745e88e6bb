// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/verify/detail/situations.hpp>
#include <span>

namespace hexagait::verify {

/// A situation, and what the rear-leg rule (gait 5) remembers.
struct WaveSituation {
  Situation legs;
  /// Slices since the leg before the rear edge lifted, and the one after it; no more than the
  /// longest period, after which a leg waits no longer.
  std::array<int, 2> since{};

  friend bool operator==(const WaveSituation&, const WaveSituation&) = default;
};

struct WaveSlice {
  Slice slice;
  WaveSituation next;
};

/// Slices with the stepper of `rules` between the update and the lifts.
class WaveSlices {
 public:
  /// @param rear_edge  ring edge between the rear legs
  /// @param longest_period  [slices]
  WaveSlices(const Rules& rules, int n, int step_time, int rear_edge, int longest_period);

  /// @param half_period  the duty factor is 1 − T / (2 half_period) [slices]
  [[nodiscard]] WaveSlice advance(const WaveSituation& situation, int half_period) const;

  /// Neither rear leg has ever lifted.
  [[nodiscard]] WaveSituation fresh(const Situation& legs) const;

  /// One to one, for situations of `legs`.
  [[nodiscard]] std::size_t key(const Situations& legs, const WaveSituation& situation) const;

 private:
  const Rules& rules_;
  Slices slices_;
  int n_, rear_edge_, longest_period_;
};

/// The exact wave gait, as a property of a cycle: from the rear edge forwards a leg lifts T after
/// the one behind it, on each side, and one side half a period after the other.
[[nodiscard]] bool is_wave(std::span<const LegSet> lifted, int n, int step_time, int rear_edge);

}  // namespace hexagait::verify
