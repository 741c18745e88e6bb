// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/executor/felt_while_held.hpp>

namespace hexagait {
namespace {

constexpr double kMostTurn = 0.04;  // for a leg that is held [rad]

}  // namespace

Vector3 FeltWhileHeld::update(const Vector3& felt, LegSet held, LegSet stand, LegSet lost,
                              double dt, double found) noexcept {
  const LegSet before = held_;
  held_ = without(before | held, stand | lost);
  if ((before | held_).empty()) return felt;  // as a rule
  Vector3 back = Vector3::Zero();
  LegSet may_be_gone;
  bool too_far = false;
  for (LegId i = 0; i < turned_.size(); ++i) {
    if (held_.contains(i)) {
      time_[i] += dt;
      if (time_[i] > found) continue;
      may_be_gone.insert(i);
      const double then = (turned_[i] + felt).norm();
      too_far = too_far || (then > kMostTurn && then > turned_[i].norm());
    } else {
      if (lost.contains(i)) back -= turned_[i];
      turned_[i].setZero();
      time_[i] = 0.0;
    }
  }
  if (too_far) return back;
  for (LegId i = 0; i < turned_.size(); ++i)
    if (may_be_gone.contains(i)) turned_[i] += felt;
  return back + felt;
}

}  // namespace hexagait
