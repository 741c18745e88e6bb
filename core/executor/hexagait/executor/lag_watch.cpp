// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/executor/lag_watch.hpp>
#include <hexagait/executor/tick_motion.hpp>

namespace hexagait {
namespace {

// Longest lag that is taken for one [s]. What is slower cannot walk at the speeds of a swing.
constexpr double kLongest = 0.06;

// The lag is that of the last so many leg-seconds of motion [s].
constexpr double kMemory = 0.5;
// While the least lag rises, of so many times as many.
constexpr double kRising = 5.0;

double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 way = b - a;
  const double length2 = way.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp((p - a).dot(way) / length2, 0.0, 1.0) : 0.0;
  return (p - a - s * way).norm();
}

}  // namespace

// Until drives have shown that they are faster they may be as slow as they like.
LagWatch::LagWatch(int legs, double moving)
    : before_(legs, Vector3::Zero()),
      lagging_(legs, Vector3::Zero()),
      error_(legs, 0.0),
      moving_(moving),
      lag_(kLongest) {}

void LagWatch::watch(LegId leg, const Vector3& p, const Vector3& set_point, bool swings,
                     double dt) noexcept {
  const Vector3 way = set_point - before_[leg];
  go_on(leg, set_point, dt);
  error_[leg] = 0.0;
  if (!swings) return;
  error_[leg] = distance_to_segment(p, lagging_[leg], set_point);

  const Vector3 v = way / dt;
  const double v2 = v.squaredNorm();
  if (v2 < moving_ * moving_) return;
  const double lag = std::clamp((set_point - p).dot(v) / v2, 0.0, kLongest);
  lag_ += decay_share(dt / kMemory) * (lag - lag_);
  least_ += decay_share(dt / (lag > least_ ? kRising * kMemory : kMemory)) * (lag - least_);
}

// (lag 1) by the implicit rule, which trails a steady motion by just τ v at any period.
void LagWatch::go_on(LegId leg, const Vector3& set_point, double dt) noexcept {
  before_[leg] = set_point;
  lagging_[leg] += dt / (lag_ + dt) * (set_point - lagging_[leg]);
}

void LagWatch::restart(LegId leg, const Vector3& set_point) noexcept {
  before_[leg] = lagging_[leg] = set_point;
  error_[leg] = 0.0;
}

}  // namespace hexagait
