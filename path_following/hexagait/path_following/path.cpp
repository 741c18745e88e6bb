// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/path_following/path.hpp>

namespace hexagait::path_following {
namespace {

constexpr double kTurnOfPiece = 0.03;  // of a spline [rad]
constexpr int kMostPieces = 64;        // between two waypoints

// One span of a spline, as a cubic by its ends and the velocities there.
struct Span {
  Vector2 p0, p1, v0, v1;

  [[nodiscard]] Vector2 at(double u) const {
    const double w = 1.0 - u;
    return w * w * (1.0 + 2.0 * u) * p0 + u * w * w * v0 + u * u * (3.0 - 2.0 * u) * p1 -
           u * u * w * v1;
  }
  [[nodiscard]] Vector2 velocity(double u) const {
    const double w = 1.0 - u;
    return 6.0 * u * w * (p1 - p0) + w * (1.0 - 3.0 * u) * v0 + u * (3.0 * u - 2.0) * v1;
  }
  // As many pieces as its turns ask for.
  [[nodiscard]] int pieces() const {
    const double chord = angle_of(p1 - p0);
    const double turn =
        std::abs(wrap_angle(angle_of(v0) - chord)) + std::abs(wrap_angle(angle_of(v1) - chord));
    return std::clamp(static_cast<int>(std::ceil(2.0 * turn / kTurnOfPiece)), 1, kMostPieces);
  }
};

// (path 1): the span from b to c, of neighbours a and d.
Span span(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const auto knot = [](const Vector2& p, const Vector2& q) { return std::sqrt((q - p).norm()); };
  const double t1 = knot(a, b), t2 = knot(b, c), t3 = knot(c, d);
  const auto velocity = [&](const Vector2& p, const Vector2& q, const Vector2& r, double s,
                            double t) -> Vector2 {
    return t2 * ((q - p) / s - (r - p) / (s + t) + (r - q) / t);
  };
  return {b, c, velocity(a, b, c, t1, t2), velocity(b, c, d, t2, t3)};
}

// Of the spans of a path, by the number of the waypoint from which each begins.
Span span_from(const std::vector<Waypoint>& waypoints, bool closed, std::size_t k) {
  const auto n = static_cast<long>(waypoints.size());
  const auto at = [&](long i) -> Vector2 {
    const auto p = [&](long j) { return waypoints[static_cast<std::size_t>(j)].p_P; };
    if (closed) return p((i + n) % n);
    // Beyond an end lies the mirror image of the point before it.
    if (i < 0) return 2.0 * p(0) - p(1);
    if (i >= n) return 2.0 * p(n - 1) - p(n - 2);
    return p(i);
  };
  const auto i = static_cast<long>(k);
  return span(at(i - 1), at(i), at(i + 1), at(i + 2));
}

}  // namespace

Path::Path(const std::vector<Waypoint>& waypoints, Shape shape, bool closed) : closed_(closed) {
  const std::size_t n = waypoints.size();
  double speed = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + (closed ? 0 : 1) < n; ++k) {
    if (std::isfinite(waypoints[k].speed)) speed = waypoints[k].speed;
    const Vector2 from = waypoints[k].p_P, to = waypoints[(k + 1) % n].p_P;
    const auto add = [&](const Vector2& p, const Vector2& q, double direction, double turn) {
      pieces_.push_back({p, length_, direction, turn, 0.0, 0.0, speed, k});
      length_ += (q - p).norm();
    };
    if (shape == Shape::lines) {
      add(from, to, angle_of(to - from), 0.0);
      continue;
    }
    const Span cubic = span_from(waypoints, closed, k);
    const int count = cubic.pieces();
    for (int j = 0; j < count; ++j) {
      const double u0 = static_cast<double>(j) / count, u1 = static_cast<double>(j + 1) / count;
      const double direction = angle_of(cubic.velocity(u0));
      add(cubic.at(u0), cubic.at(u1), direction,
          wrap_angle(angle_of(cubic.velocity(u1)) - direction));
    }
  }
  end_P_ = closed ? waypoints.front().p_P : waypoints.back().p_P;
  face(waypoints);
}

// The facing of each piece from those of the waypoints that have one.
void Path::face(const std::vector<Waypoint>& waypoints) {
  struct Key {
    double s, facing;
  };
  std::vector<Key> keys;
  std::size_t next = 0;  // piece
  for (std::size_t k = 0; k < waypoints.size(); ++k) {
    while (next < pieces_.size() && pieces_[next].waypoint < k) ++next;
    if (!waypoints[k].facing) continue;
    const double s = next < pieces_.size() ? pieces_[next].s : length_;
    const double before = keys.empty() ? 0.0 : keys.back().facing;
    keys.push_back({s, before + wrap_angle(*waypoints[k].facing - before)});
  }
  has_facing_ = !keys.empty();
  if (closed_ && has_facing_) {
    const Key first = keys.front(), last = keys.back();
    const double to_first = wrap_angle(first.facing - last.facing);
    keys.push_back({first.s + length_, last.facing + to_first});
    keys.insert(keys.begin(), {last.s - length_, first.facing - to_first});
  }
  const auto facing_at = [&](double s) {
    if (keys.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto after = std::ranges::upper_bound(keys, s, {}, &Key::s);
    if (after == keys.begin()) return keys.front().facing;
    if (after == keys.end()) return keys.back().facing;
    const Key &a = *std::prev(after), &b = *after;
    return a.facing + (s - a.s) / (b.s - a.s) * (b.facing - a.facing);
  };
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    pieces_[k].facing = facing_at(pieces_[k].s);
    pieces_[k].swing = facing_at(end_of(k)) - pieces_[k].facing;
  }
}

double Path::end_of(std::size_t piece) const noexcept {
  return piece + 1 < pieces_.size() ? pieces_[piece + 1].s : length_;
}

Path::Place Path::place(double s) const noexcept {
  if (closed_) s -= length_ * std::floor(s / length_);
  const auto after = std::ranges::upper_bound(pieces_, s, {}, &Piece::s);
  const auto k = static_cast<std::size_t>(after - pieces_.begin());
  const std::size_t piece = k == 0 ? 0 : k - 1;
  return {piece, s - pieces_[piece].s};
}

double Path::share_of(const Place& place) const noexcept {
  const double length = end_of(place.piece) - pieces_[place.piece].s;
  return length > 0.0 ? std::clamp(place.along / length, 0.0, 1.0) : 0.0;
}

Vector2 Path::point(const Place& place) const noexcept {
  const Piece& piece = pieces_[place.piece];
  const bool last = place.piece + 1 == pieces_.size();
  const double length = end_of(place.piece) - piece.s;
  const Vector2 to = last ? end_P_ : pieces_[place.piece + 1].p_P;
  if (last && !closed_ && place.along > length)
    return to + (place.along - length) * unit_vector(piece.direction + piece.turn);
  return length > 0.0 ? piece.p_P + place.along / length * (to - piece.p_P) : to;
}

Vector2 Path::at(double s) const noexcept { return point(place(s)); }

double Path::direction(double s) const noexcept {
  const Place here = place(s);
  const Piece& piece = pieces_[here.piece];
  return wrap_angle(piece.direction + share_of(here) * piece.turn);
}

double Path::facing(double s) const noexcept {
  const Place here = place(s);
  const Piece& piece = pieces_[here.piece];
  return wrap_angle(piece.facing + share_of(here) * piece.swing);
}

double Path::speed(double s) const noexcept { return pieces_[place(s).piece].speed; }

double Path::nearest(const Vector2& p_P, double from, double to) const noexcept {
  const double infinity = std::numeric_limits<double>::infinity();
  double best = from, least = infinity;
  Place here = place(from);
  double s = from;
  while (true) {
    const bool last = here.piece + 1 == pieces_.size();
    const double length = last && !closed_ ? infinity : end_of(here.piece) - pieces_[here.piece].s;
    const double stretch = std::max(0.0, std::min(to - s, length - here.along));
    const Vector2 a = point(here), way = point({here.piece, here.along + stretch}) - a;
    const double square = way.squaredNorm();
    const double share = square > 0.0 ? std::clamp((p_P - a).dot(way) / square, 0.0, 1.0) : 0.0;
    const double distance = (p_P - a - share * way).squaredNorm();
    if (distance < least) {
      least = distance;
      best = s + share * stretch;
    }
    s += stretch;
    if (!(s < to) || length == infinity) return best;
    here = {last ? 0 : here.piece + 1, 0.0};
  }
}

}  // namespace hexagait::path_following
