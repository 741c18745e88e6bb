// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <hexagait/curves/foot_curve.hpp>

namespace hexagait {
namespace {

constexpr double kMinDuration = 1e-3;  // [s]
constexpr double kMinBrakeWay = 0.9;   // length of a ramp where the segment has none, tolerances
constexpr double kSnap = 1e-3;         // closer nodes are merged, as a fraction of a segment
constexpr std::size_t kMaxSwingNodes = 7;  // five knots and the ends of both ramps

// The polygon of a swing. Axes: x along the chord, z along the normal, origin at the start.
struct Polygon {
  std::array<Vector3, 5> p;
  std::array<double, 5> time{};
  std::array<Vector3, 5> v;
  std::size_t size = 0;

  void add(double along, double height) { p[size++] = {along, 0.0, height}; }
  std::size_t last() const { return size - 1; }
  double segment_time(std::size_t k) const { return time[k + 1] - time[k]; }
};

// A quintic from one state to another; the end states stand before and after it.
struct Piece {
  PointState from, to;
  double duration = 0.0;
  PointState at(double t) const { return quintic(from, to, duration, t); }
};

PointState sum(const PointState& a, const PointState& b) {
  return {a.p + b.p, a.v + b.v, a.a + b.a};
}

Matrix3 swing_axes(const Vector3& way, const Vector3& normal) {
  const Vector3 n = normal.squaredNorm() > 0.0 ? normal.normalized() : Vector3::UnitZ();
  const Vector3 chord = way - way.dot(n) * n;
  const Vector3 u = chord.norm() > 1e-9 ? chord.normalized() : n.unitOrthogonal();
  return (Matrix3() << u, n.cross(u), n).finished();
}

Polygon swing_polygon(double along, double rise, const FootSwing& swing) {
  const double h = std::max(0.0, swing.profile_height);
  const double top = std::max(0.0, rise) + h;
  Polygon polygon;
  polygon.add(0.0, 0.0);
  switch (swing.profile) {
    case SwingProfile::straight:
      break;
    case SwingProfile::triangle:
      polygon.add(0.5 * along, top);
      break;
    case SwingProfile::square:
      polygon.add(0.0, top);
      polygon.add(along, top);
      break;
    case SwingProfile::trapezoid:
      polygon.add(0.1 * along, h);
      polygon.add(0.5 * along, rise + h);
      polygon.add(0.9 * along, rise + h);
      break;
  }
  polygon.add(along, rise);
  return polygon;
}

// The polygon without inner knots that coincide with a neighbour.
Polygon distinct(const Polygon& all, double tolerance) {
  Polygon kept;
  kept.p[kept.size++] = all.p[0];
  const Vector3& target = all.p[all.last()];
  for (std::size_t k = 1; k < all.last(); ++k) {
    const Vector3& p = all.p[k];
    if ((p - kept.p[kept.last()]).norm() < tolerance || (p - target).norm() < tolerance) continue;
    kept.p[kept.size++] = p;
  }
  kept.p[kept.size++] = target;
  return kept;
}

void set_times(Polygon& polygon, double duration) {
  double total = 0.0;
  for (std::size_t k = 0; k < polygon.last(); ++k) {
    total += std::sqrt((polygon.p[k + 1] - polygon.p[k]).norm());
    polygon.time[k + 1] = total;
  }
  for (std::size_t k = 1; k < polygon.last(); ++k) polygon.time[k] *= duration / total;
  polygon.time[polygon.last()] = duration;
}

// Time τ in which velocity v and acceleration a ramp to 0 (or from 0, in reverse): such that the
// longest distance of the ramp, |v| τ/2 + |a| τ²/12, is at most the available one.
double brake_time(const Vector3& v, const Vector3& a, const Vector3& way, double longest,
                  const FootSwing& swing) {
  double time = longest;
  for (int i = 0; i < 3; ++i) {
    const double ahead = std::copysign(1.0, v[i] != 0.0 ? v[i] : a[i]) * way[i];
    const double available = std::max(ahead, kMinBrakeWay * swing.tolerance);
    const double half = 0.5 * std::abs(v[i]);
    const double speed = half + std::sqrt(half * half + std::abs(a[i]) * available / 3.0);
    if (2.0 * available < speed * time) time = 2.0 * available / speed;
  }
  return time > (1.0 - kSnap) * longest ? longest : time;
}

Piece start_brake(const PointState& start, const Polygon& polygon, const FootSwing& swing) {
  const double longest = polygon.segment_time(0);
  const double hardest = 1.5 * start.v.norm() / swing.braking;
  const double soft = brake_time(start.v, start.a, polygon.p[1], longest, swing);
  const double time = std::min(longest, std::max(hardest, soft));
  const Vector3 way = time * (0.5 * start.v + time / 12.0 * start.a);
  return {{Vector3::Zero(), start.v, start.a}, {way, Vector3::Zero(), Vector3::Zero()}, time};
}

Piece touchdown_ramp(const Polygon& polygon, const FootSwing& swing) {
  const Vector3 v(0.0, 0.0, -swing.touchdown_speed);
  const std::size_t k = polygon.last() - 1;
  const double time = brake_time(v, Vector3::Zero(), polygon.p[k + 1] - polygon.p[k],
                                 polygon.segment_time(k), swing);
  return {{}, {0.5 * time * v, v, Vector3::Zero()}, time};
}

// Velocities at the knots: no faster than both neighbouring segments allow, 0 where an axis
// reverses.
void set_velocities(Polygon& polygon, const std::array<Vector3, 4>& way) {
  for (std::size_t k = 0; k < polygon.size; ++k) polygon.v[k].setZero();
  for (std::size_t k = 1; k < polygon.last(); ++k) {
    const double before = (k == 1 ? kMinimumJerkPeak : 1.0) / polygon.segment_time(k - 1);
    const double after =
        (k + 1 == polygon.last() ? kMinimumJerkPeak : 1.0) / polygon.segment_time(k);
    for (int i = 0; i < 3; ++i) {
      const double v_before = before * way[k - 1][i], v_after = after * way[k][i];
      if (v_before * v_after <= 0.0) continue;
      polygon.v[k][i] = std::abs(v_before) < std::abs(v_after) ? v_before : v_after;
    }
  }
}

std::array<Vector3, 4> ways(const Polygon& polygon) {
  std::array<Vector3, 4> way;
  for (std::size_t k = 0; k < polygon.last(); ++k) way[k] = polygon.p[k + 1] - polygon.p[k];
  return way;
}

// The terms whose sum is a swing, in the axes of its polygon.
struct SwingTerms {
  Polygon polygon;
  std::array<Vector3, 4> way;  // of the moves from knot to knot, less that of brake and touchdown
  Piece brake, touchdown;
};

SwingTerms swing_terms(const PointState& start, const Vector3& way, const FootSwing& swing,
                       double duration) {
  SwingTerms terms;
  terms.polygon = distinct(swing_polygon(way.x(), way.z(), swing), swing.tolerance);
  set_times(terms.polygon, std::max(duration, kMinDuration));
  terms.way = ways(terms.polygon);
  terms.brake = start_brake(start, terms.polygon, swing);
  terms.touchdown = touchdown_ramp(terms.polygon, swing);
  terms.way[0] -= terms.brake.to.p;
  terms.way[terms.polygon.last() - 1] -= terms.touchdown.to.p;
  set_velocities(terms.polygon, terms.way);
  return terms;
}

// One segment: its move, and the brake or touchdown that falls into it.
struct Segment {
  Piece move, brake, touchdown;
  double touchdown_begin = 0.0;  // since the start of the segment [s]

  PointState at(double t) const {
    return sum(sum(move.at(t), brake.at(t)), touchdown.at(t - touchdown_begin));
  }
};

Segment segment(const SwingTerms& terms, std::size_t k) {
  const Polygon& polygon = terms.polygon;
  const double T = polygon.segment_time(k);
  Segment result;
  result.move = {{polygon.p[k], polygon.v[k], Vector3::Zero()},
                 {polygon.p[k] + terms.way[k], polygon.v[k + 1], Vector3::Zero()},
                 T};
  result.touchdown_begin = T;
  if (k == 0) result.brake = terms.brake;
  if (k + 1 == polygon.last()) {
    result.touchdown = terms.touchdown;
    result.touchdown_begin = T - terms.touchdown.duration;
  }
  return result;
}

// Times within a segment at which the brake ends and the touchdown begins, which need a node each;
// 0 for those that coincide with another node.
std::array<double, 2> inner_nodes(const Segment& segment) {
  const double T = segment.move.duration;
  std::array<double, 2> t = {std::min(segment.brake.duration, segment.touchdown_begin),
                             std::max(segment.brake.duration, segment.touchdown_begin)};
  if (t[0] < kSnap * T) t[0] = 0.0;
  if (t[1] - t[0] < kSnap * T || t[1] > (1.0 - kSnap) * T) t[1] = 0.0;
  if (t[0] > (1.0 - kSnap) * T) t[0] = 0.0;
  return t;
}

PointState turned(const Matrix3& R, const PointState& state) {
  return {R * state.p, R * state.v, R * state.a};
}

PointState placed(const Vector3& origin, const Matrix3& R, const PointState& state) {
  return {origin + R * state.p, R * state.v, R * state.a};
}

}  // namespace

double swing_duration(const Vector3& start, const FootSwing& swing, double average_velocity,
                      double minimum) noexcept {
  const Vector3 way = swing.target - start;
  const Vector3 local = swing_axes(way, swing.normal).transpose() * way;
  const Polygon polygon = swing_polygon(local.x(), local.z(), swing);
  double length = 0.0;
  for (std::size_t k = 0; k < polygon.last(); ++k)
    length += (polygon.p[k + 1] - polygon.p[k]).norm();
  return std::max(length / average_velocity, minimum);
}

void FootCurve::reserve(int knots) {
  spline_.reserve(std::max(static_cast<std::size_t>(std::max(knots, 0)) + 1, kMaxSwingNodes));
}

void FootCurve::plan_swing(const PointState& start, const FootSwing& swing,
                           double duration) noexcept {
  const Vector3 way = swing.target - start.p;
  const Matrix3 R = swing_axes(way, swing.normal);
  const SwingTerms terms =
      swing_terms(turned(R.transpose(), start), R.transpose() * way, swing, duration);

  // A node at each knot and wherever a term begins or ends.
  const Polygon& polygon = terms.polygon;
  spline_.start(start);
  for (std::size_t k = 0; k < polygon.last(); ++k) {
    const Segment now = segment(terms, k);
    for (const double t : inner_nodes(now))
      if (t > 0.0) spline_.add(polygon.time[k] + t, placed(start.p, R, now.at(t)));
    if (k + 1 == polygon.last()) break;
    spline_.add(polygon.time[k + 1],
                placed(start.p, R, {polygon.p[k + 1], polygon.v[k + 1], Vector3::Zero()}));
  }
  spline_.add(polygon.time[polygon.last()],
              {swing.target, R.col(2) * -swing.touchdown_speed, Vector3::Zero()});
}

void FootCurve::plan_target(const PointState& start, const PointState& target,
                            double duration) noexcept {
  spline_.start(start);
  spline_.add(std::max(duration, kMinDuration), target);
}

void FootCurve::plan_trajectory(const PointState& start, std::span<const FootKnot> knots) noexcept {
  const auto usable = usable_knots(knots, spline_.capacity() - 1);
  spline_.start(start);
  double time = 0.0;
  Vector3 p = start.p;
  for (std::size_t k = 0; k < usable.size(); ++k) {
    const FootKnot& knot = usable[k];
    KnotRates rates;
    if (k + 1 < usable.size()) {
      const double before = knot.time - time, after = usable[k + 1].time - knot.time;
      rates =
          parabola_rates((knot.p - p) / before, before, (usable[k + 1].p - knot.p) / after, after);
    }
    spline_.add(knot.time, {knot.p, knot.v.value_or(rates.v), rates.a});
    time = knot.time;
    p = knot.p;
  }
}

}  // namespace hexagait
