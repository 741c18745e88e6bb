// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/curves/base_curve.hpp>
#include <hexagait/math/quintic.hpp>

namespace hexagait {
namespace {

constexpr double kCubicMaxToMean = 3.0;  // Fritsch & Carlson 1980

// Velocity at a knot, from the mean velocities before and after it.
Vector3 bounded_velocity(const Vector3& before, double T_before, const Vector3& after,
                         double T_after) {
  if (before.dot(after) <= 0.0) return Vector3::Zero();
  const Vector3 v = parabola_rates(before, T_before, after, T_after).v;
  const double bound = kCubicMaxToMean * std::min(before.norm(), after.norm());
  return std::min(1.0, bound / v.norm()) * v;
}

Twist knot_twist(const BaseKnot& last, const BaseKnot& now, const BaseKnot& next) {
  const double before = now.time - last.time, after = next.time - now.time;
  const Vector3 v_A = bounded_velocity((now.X_AB.p - last.X_AB.p) / before, before,
                                       (next.X_AB.p - now.X_AB.p) / after, after);
  const Vector3 turn_before = rotation_vector(last.X_AB.R.transpose() * now.X_AB.R);
  const Vector3 turn_after = rotation_vector(now.X_AB.R.transpose() * next.X_AB.R);
  return {now.X_AB.R.transpose() * v_A,
          bounded_velocity(turn_before / before, before, turn_after / after, after)};
}

// φ₂ of a segment.
Vector3 middle_turn(const BaseState& from, const BaseState& to, double T) {
  return rotation_vector(rotation(-T / 3.0 * from.V_B.w) * from.X_AB.R.transpose() * to.X_AB.R *
                         rotation(-T / 3.0 * to.V_B.w));
}

// Position and velocity in A at x = t/T of the cubic Hermite curve.
struct Line {
  Vector3 p, v;
};
Line hermite(const BaseState& from, const BaseState& to, double T, double x) {
  const Vector3 d0 = from.X_AB.R * from.V_B.v * T, d1 = to.X_AB.R * to.V_B.v * T;
  const Vector3 way = to.X_AB.p - from.X_AB.p;
  const double y = 1.0 - x;
  return {from.X_AB.p + x * x * (3.0 - 2.0 * x) * way + x * y * (y * d0 - x * d1),
          (6.0 * x * y * way + y * (1.0 - 3.0 * x) * d0 + x * (3.0 * x - 2.0) * d1) / T};
}

// Rotation and angular velocity in B at x = t/T.
struct Turn {
  Matrix3 R;
  Vector3 w;
};
Turn cumulative(const BaseState& from, const BaseState& to, const Vector3& phi_2, double T,
                double x) {
  const double y = 1.0 - x;
  const Vector3 phi_1 = T / 3.0 * from.V_B.w, phi_3 = T / 3.0 * to.V_B.w;
  const Matrix3 E2 = rotation(x * x * (3.0 - 2.0 * x) * phi_2);
  const Matrix3 E3 = rotation(x * x * x * phi_3);
  const Vector3 inner = 6.0 * x * y * phi_2 + E2.transpose() * (3.0 * y * y * phi_1);
  return {from.X_AB.R * rotation((1.0 - y * y * y) * phi_1) * E2 * E3,
          (3.0 * x * x * phi_3 + E3.transpose() * inner) / T};
}

}  // namespace

double base_duration(const Pose& from, const Pose& to, double average_speed,
                     double average_turn_rate, double minimum) noexcept {
  const double angle = rotation_vector(from.R.transpose() * to.R).norm();
  return std::max({(to.p - from.p).norm() / average_speed, angle / average_turn_rate, minimum});
}

BaseCurve& BaseCurve::operator=(const BaseCurve& other) {
  if (this == &other) return *this;
  nodes_.reserve(other.nodes_.capacity());
  nodes_ = other.nodes_;
  return *this;
}

void BaseCurve::reserve(int knots) {
  nodes_.reserve(static_cast<std::size_t>(std::max(knots, 1)) + 1);
}

void BaseCurve::plan(const BaseState& start, std::span<const BaseKnot> knots,
                     const Twist& end_V_B) noexcept {
  nodes_.clear();
  if (nodes_.capacity() == 0) return;
  const auto usable = usable_knots(knots, nodes_.capacity() - 1);
  nodes_.push_back({0.0, start, Vector3::Zero()});

  BaseKnot last{0.0, start.X_AB};
  for (std::size_t k = 0; k < usable.size(); ++k) {
    const BaseKnot& now = usable[k];
    const Twist V_B = k + 1 < usable.size() ? knot_twist(last, now, usable[k + 1]) : end_V_B;
    const BaseState state{now.X_AB, V_B};
    Node& before = nodes_.back();
    before.phi_2 = middle_turn(before.state, state, now.time - before.time);
    nodes_.push_back({now.time, state, Vector3::Zero()});
    last = now;
  }
}

bool BaseCurve::in_range() const noexcept {
  return std::ranges::all_of(nodes_, [](const Node& node) {
    const auto& [X_AB, V_B] = node.state;
    return node.time <= kLargestMotion && hexagait::in_range(X_AB.p) &&
           hexagait::in_range(X_AB.R) && hexagait::in_range(V_B.v) && hexagait::in_range(V_B.w) &&
           hexagait::in_range(node.phi_2);
  });
}

double BaseCurve::duration() const noexcept { return nodes_.empty() ? 0.0 : nodes_.back().time; }

BaseState BaseCurve::at(double t) const noexcept {
  if (nodes_.empty()) return {};
  if (!(t > 0.0)) return nodes_.front().state;
  if (t >= duration()) return nodes_.back().state;
  const auto to = std::upper_bound(nodes_.begin(), nodes_.end(), t,
                                   [](double time, const Node& node) { return time < node.time; });
  const Node& from = *(to - 1);
  const double T = to->time - from.time, x = (t - from.time) / T;
  const Line line = hermite(from.state, to->state, T, x);
  const Turn turn = cumulative(from.state, to->state, from.phi_2, T, x);
  return {{turn.R, line.p}, {turn.R.transpose() * line.v, turn.w}};
}

}  // namespace hexagait
