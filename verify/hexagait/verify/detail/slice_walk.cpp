// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/verify/detail/slice_walk.hpp>
#include <numeric>

namespace hexagait::verify {

using namespace gait_state;

namespace {

constexpr double kAhead = 25.0;
constexpr double kUnit = 1e-3;  // [m of path]; also the tolerance of ties

}  // namespace

SliceWalk::SliceWalk(const Rules& rules, const Situation& start, int step_time,
                     Adjustment adjustment)
    : rules_(rules), step_time_(step_time), legs_(start), foot_(lags_of(start.state)) {
  params_.tie_tolerance = kUnit;
  params_.adjustment = adjustment;
  const int n = foot_.size();
  const double mean = std::accumulate(foot_.begin(), foot_.end(), 0.0) / n;
  for (double& foot : foot_) foot = (mean - foot) / (5.0 * kUnit);
  const LegSet air = airborne(start);
  for (LegId leg = 0; leg < n; ++leg)
    if (air.contains(leg)) foot_[leg] = kAhead;
}

LegSet SliceWalk::advance() {
  const int n = foot_.size();
  for (std::int8_t& left : legs_.air) left = static_cast<std::int8_t>(left > 0 ? left - 1 : 0);
  GaitInput input{foot_, airborne(legs_), {}};
  for (double& lag : input.lag) lag *= -kUnit;
  const LegSet lifted = rules_.update(latch_, input, params_).may_step;
  for (LegId leg = 0; leg < n; ++leg) {
    if (!lifted.contains(leg)) continue;
    foot_[leg] = kAhead;
    legs_.air[static_cast<std::size_t>(leg)] = static_cast<std::int8_t>(step_time_);
  }

  // The control loop is faster than a slice and sees the lifts.
  const LegSet air = input.airborne = airborne(legs_);
  legs_.state = rules_.update(latch_, input, params_).state;

  const double forward = std::accumulate(foot_.begin(), foot_.end(), 0.0) / (n - air.size());
  for (LegId leg = 0; leg < n; ++leg)
    if (!air.contains(leg)) foot_[leg] -= forward;
  travelled_ += forward;
  return lifted;
}

}  // namespace hexagait::verify
