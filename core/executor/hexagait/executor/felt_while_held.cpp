// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/executor/felt_while_held.hpp>

namespace hexagait {
namespace {

constexpr double kMostTurn = 0.04;  // for a leg that is held [rad]

}  // namespace

Vector3 FeltWhileHeld::update(const Vector3& felt, LegSet held, LegSet stand,
                              LegSet lost) noexcept {
  Vector3 back = Vector3::Zero();
  bool too_far = false;
  held_ = without(held_ | held, stand | lost);
  for (LegId i = 0; i < turned_.size(); ++i) {
    if (lost.contains(i) && !lost_.contains(i)) back -= turned_[i];
    if (!held_.contains(i)) turned_[i].setZero();
    const double now = turned_[i].norm(), then = (turned_[i] + felt).norm();
    too_far = too_far || (held_.contains(i) && then > kMostTurn && then > now);
  }
  lost_ = lost;
  if (too_far) return back;
  for (LegId i = 0; i < turned_.size(); ++i)
    if (held_.contains(i)) turned_[i] += felt;
  return back + felt;
}

}  // namespace hexagait
