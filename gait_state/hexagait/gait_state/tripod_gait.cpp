// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/gait_state/ring.hpp>
#include <hexagait/gait_state/tripod_gait.hpp>

namespace hexagait::gait_state {
namespace {

// Which tripod a group of lifts is, if it is one within the tolerance.
std::optional<LegSet> tripod_of(const TimedLift* first, int num_legs, double tolerance) {
  const int half = num_legs / 2;
  LegSet legs;
  for (int k = 0; k < half; ++k) legs.insert(first[k].leg);
  const bool together = first[half - 1].time - first[0].time <= tolerance;
  const bool tripod = legs == first_tripod(num_legs) || legs == second_tripod(num_legs);
  return together && tripod ? std::optional(legs) : std::nullopt;
}

}  // namespace

std::optional<int> first_tripod_gait(const std::vector<TimedLift>& lifts, int num_legs,
                                     double step_time) {
  constexpr int kGroups = 4;
  const int half = num_legs / 2;
  const int count = static_cast<int>(lifts.size());
  for (int k = 0; k + kGroups * half <= count; ++k) {
    std::optional<LegSet> before;
    int groups = 0;
    for (; groups < kGroups; ++groups) {
      const auto tripod =
          tripod_of(&lifts[static_cast<std::size_t>(k + groups * half)], num_legs, 0.2 * step_time);
      if (!tripod || tripod == before) break;
      before = tripod;
    }
    if (groups == kGroups) return k;
  }
  return std::nullopt;
}

}  // namespace hexagait::gait_state
