// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/quintic.hpp>

namespace hexagait {

PointState Quintic::at(double t) const noexcept {
  Vector3 p = c[5], v = Vector3::Zero(), half_a = Vector3::Zero();
  for (std::size_t k = 5; k-- > 0;) {
    half_a = v + t * half_a;
    v = p + t * v;
    p = c[k] + t * p;
  }
  return {p, v, 2.0 * half_a};
}

Quintic quintic(const PointState& from, const PointState& to, double duration) noexcept {
  // End state minus that of the parabola that starts at `from`, in units of the duration.
  const double T = duration, per_T3 = 1.0 / (T * T * T);
  const Vector3 missing_p = to.p - from.p - T * (from.v + 0.5 * T * from.a);
  const Vector3 missing_v = T * (to.v - from.v - T * from.a);
  const Vector3 missing_a = T * T * (to.a - from.a);
  return {{from.p, from.v, 0.5 * from.a,
           per_T3 * (10.0 * missing_p - 4.0 * missing_v + 0.5 * missing_a),
           per_T3 / T * (-15.0 * missing_p + 7.0 * missing_v - missing_a),
           per_T3 / (T * T) * (6.0 * missing_p - 3.0 * missing_v + 0.5 * missing_a)}};
}

PointState quintic(const PointState& from, const PointState& to, double duration,
                   double t) noexcept {
  if (!(t > 0.0)) return from;
  if (t >= duration) return to;
  return quintic(from, to, duration).at(t);
}

KnotRates parabola_rates(const Vector3& slope_before, double time_before,
                         const Vector3& slope_after, double time_after) noexcept {
  const double T = time_before + time_after;
  return {(time_after * slope_before + time_before * slope_after) / T,
          2.0 / T * (slope_after - slope_before)};
}

QuinticSpline& QuinticSpline::operator=(const QuinticSpline& other) {
  if (this == &other) return *this;
  nodes_.reserve(other.nodes_.capacity());
  nodes_ = other.nodes_;
  piece_begin_ = piece_end_ = 0.0;
  return *this;
}

void QuinticSpline::start(const PointState& state) noexcept {
  nodes_.clear();
  piece_begin_ = piece_end_ = 0.0;
  if (nodes_.capacity() > 0) nodes_.push_back({0.0, state});
}

void QuinticSpline::add(double time, const PointState& state) noexcept {
  const bool room = nodes_.size() < nodes_.capacity();
  if (room && time - duration() >= kShortestSegment) nodes_.push_back({time, state});
}

bool QuinticSpline::in_range() const noexcept {
  return std::ranges::all_of(nodes_, [](const Node& node) {
    return node.time <= kLargestMotion && hexagait::in_range(node.state.p) &&
           hexagait::in_range(node.state.v) && hexagait::in_range(node.state.a);
  });
}

double QuinticSpline::duration() const noexcept {
  return nodes_.empty() ? 0.0 : nodes_.back().time;
}

std::size_t QuinticSpline::segment(double t) const noexcept {
  const auto later =
      std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, t,
                       [](double time, const Node& node) { return time < node.time; });
  return static_cast<std::size_t>(later - nodes_.begin()) - 1;
}

PointState QuinticSpline::at(double t) const noexcept {
  if (nodes_.empty()) return {};
  if (nodes_.size() == 1) return nodes_.front().state;
  const std::size_t k = segment(t);
  const Node &from = nodes_[k], &to = nodes_[k + 1];
  return quintic(from.state, to.state, to.time - from.time, t - from.time);
}

PointState QuinticSpline::along(double t) noexcept {
  if (nodes_.size() < 2 || !(t > 0.0) || t >= duration()) return at(t);
  if (t < piece_begin_ || t >= piece_end_) {
    const std::size_t k = segment(t);
    const Node &from = nodes_[k], &to = nodes_[k + 1];
    piece_ = quintic(from.state, to.state, to.time - from.time);
    piece_begin_ = from.time;
    piece_end_ = to.time;
  }
  return piece_.at(t - piece_begin_);
}

}  // namespace hexagait
