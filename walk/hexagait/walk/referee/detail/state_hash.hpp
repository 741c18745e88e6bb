// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <hexagait/plant/plant.hpp>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sim/ground_truth.hpp>

namespace hexagait::walk {

/// Takes the bits of one tick, true pose of the base and measured joints (those that there are),
/// into the hash of a trial.
/// @param hash  of the ticks before; kFnv1aBasis at first
[[nodiscard]] inline std::uint64_t state_hash(const RobotModel& model, const GroundTruth& truth,
                                              const Measurement& measurement, std::uint64_t hash) {
  const auto add = [&hash](double value) {
    hash = fnv1a(std::bit_cast<std::uint64_t>(value), hash);
  };
  for (int k = 0; k < 3; ++k) add(truth.X_WB.p[k]);
  for (int k = 0; k < 9; ++k) add(truth.X_WB.R(k / 3, k % 3));
  for (LegId i = 0; i < measurement.q.size(); ++i)
    for (int k = 0; k < model.legs[i].num_joints(); ++k) add(measurement.q[i][k]);
  return hash;
}

}  // namespace hexagait::walk
