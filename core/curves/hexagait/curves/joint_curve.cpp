// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/curves/joint_curve.hpp>

namespace hexagait {
namespace {

// A quintic with mean velocity s is monotone if its end velocities are at most this times s.
constexpr double kQuinticMaxToMean = 2.0;

// Time and joint positions of a knot.
struct Place {
  double time = 0.0;
  LegJoints q, qd;
};

LegJoints given_or(const LegJoints& given, const LegJoints& otherwise) {
  return given.array().isNaN().select(otherwise, given);
}

// Positions that are not given: the integral of given velocities, otherwise unchanged.
Place place_of(const JointKnot& knot, const Place& last) {
  const double T = knot.time - last.time;
  const LegJoints still = LegJoints::Zero();
  const LegJoints coasted = last.q + 0.5 * T * (last.qd + knot.qd);
  const LegJoints q = given_or(knot.q, given_or(coasted, last.q));
  return {knot.time, q, given_or(knot.qd, still)};
}

/// Velocity and acceleration of all joints at a knot.
struct JointRates {
  LegJoints v = LegJoints::Zero(), a = LegJoints::Zero();
};

/// The state of the three joints from `first` on.
PointState three_of(int first, const LegJoints& q, const LegJoints& qd, const LegJoints& qdd) {
  return {q.segment<3>(first), qd.segment<3>(first), qdd.segment<3>(first)};
}

JointRates bounded_rates(const Place& last, const Place& now, const Place& next) {
  const double before = now.time - last.time, after = next.time - now.time;
  const LegJoints slope_before = (now.q - last.q) / before, slope_after = (next.q - now.q) / after;
  JointRates rates;
  for (int i = 0; i < kMaxLegJoints; i += 3) {
    const KnotRates three =
        parabola_rates(slope_before.segment<3>(i), before, slope_after.segment<3>(i), after);
    rates.v.segment<3>(i) = three.v;
    rates.a.segment<3>(i) = three.a;
  }
  for (int i = 0; i < kMaxLegJoints; ++i) {
    const bool turns = slope_before[i] * slope_after[i] <= 0.0;
    const double bound =
        turns ? 0.0
              : kQuinticMaxToMean * std::min(std::abs(slope_before[i]), std::abs(slope_after[i]));
    if (std::abs(rates.v[i]) <= bound) continue;
    rates.v[i] = std::copysign(bound, rates.v[i]);
    rates.a[i] = 0.0;
  }
  return rates;
}

}  // namespace

double joint_duration(const LegJoints& from, const LegJoints& to, double average_velocity,
                      double minimum) noexcept {
  return std::max((to - from).cwiseAbs().maxCoeff() / average_velocity, minimum);
}

LegJoints peak_joint_velocity(const LegJoints& from, const LegJoints& to,
                              double duration) noexcept {
  return kMinimumJerkPeak / duration * (to - from).cwiseAbs();
}

JointCurve& JointCurve::operator=(const JointCurve& other) {
  if (this == &other) return *this;
  splines_ = other.splines_;
  efforts_.reserve(other.efforts_.capacity());
  efforts_ = other.efforts_;
  return *this;
}

void JointCurve::reserve(int knots) {
  const std::size_t nodes = static_cast<std::size_t>(std::max(knots, 1)) + 1;
  for (QuinticSpline& spline : splines_) spline.reserve(nodes);
  efforts_.reserve(nodes);
}

void JointCurve::plan(const JointState& start, std::span<const JointKnot> knots) noexcept {
  std::size_t room = efforts_.capacity();
  for (const QuinticSpline& spline : splines_) room = std::min(room, spline.capacity());
  const auto usable = usable_knots(knots, std::max<std::size_t>(room, 1) - 1);
  for (int i = 0; i < kMaxLegJoints; i += 3)
    splines_[static_cast<std::size_t>(i / 3)].start(three_of(i, start.q, start.qd, start.qdd));
  efforts_.clear();
  if (room == 0) return;
  efforts_.push_back(start.effort);

  Place last{0.0, start.q, start.qd};
  for (std::size_t k = 0; k < usable.size(); ++k) {
    const JointKnot& knot = usable[k];
    const Place now = place_of(knot, last);
    JointRates rates;
    if (k + 1 < usable.size()) rates = bounded_rates(last, now, place_of(usable[k + 1], now));
    const LegJoints qd = given_or(knot.qd, rates.v), qdd = given_or(knot.qdd, rates.a);
    for (int i = 0; i < kMaxLegJoints; i += 3)
      splines_[static_cast<std::size_t>(i / 3)].add(knot.time, three_of(i, now.q, qd, qdd));
    efforts_.push_back(given_or(knot.effort, efforts_.back()));
    last = now;
  }
}

bool JointCurve::in_range() const noexcept {
  const auto finite = [](const LegJoints& effort) { return hexagait::in_range(effort); };
  return splines_[0].in_range() && splines_[1].in_range() && std::ranges::all_of(efforts_, finite);
}

JointState JointCurve::at(double t) const noexcept {
  JointState result;
  for (int i = 0; i < kMaxLegJoints; i += 3) {
    const PointState three = splines_[static_cast<std::size_t>(i / 3)].at(t);
    result.q.segment<3>(i) = three.p;
    result.qd.segment<3>(i) = three.v;
    result.qdd.segment<3>(i) = three.a;
  }
  result.effort = effort_at(t);
  return result;
}

LegJoints JointCurve::effort_at(double t) const noexcept {
  if (efforts_.empty()) return LegJoints::Zero();
  if (efforts_.size() == 1) return efforts_.front();
  const QuinticSpline& spline = splines_[0];
  const std::size_t k = spline.segment(t);
  const double begin = spline.nodes()[k].time, end = spline.nodes()[k + 1].time;
  const double share = std::clamp((t - begin) / (end - begin), 0.0, 1.0);
  return (1.0 - share) * efforts_[k] + share * efforts_[k + 1];
}

}  // namespace hexagait
