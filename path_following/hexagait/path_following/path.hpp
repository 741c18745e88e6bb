// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/geometry.hpp>
#include <limits>
#include <optional>
#include <vector>

namespace hexagait::path_following {

/// A point of a path as it is given, in the path's frame P: that of the base where it starts, x ahead,
/// y to the left.
struct Waypoint {
  Vector2 p_P = Vector2::Zero();  ///< [m]
  /// Where the body faces there, from x of P [rad]. Between points that have one it turns evenly, the
  /// shorter way; before the first of them and after the last it stays, unless the path is closed.
  std::optional<double> facing = {};
  /// Bound of the speed from here on [m/s], at the farthest workspace centre.
  double speed = std::numeric_limits<double>::infinity();
};

/// What is between two waypoints.
enum class Shape : std::uint8_t {
  lines,   ///< straight, with corners at the waypoints
  spline,  ///< centripetal Catmull-Rom (path 1): smooth, through all waypoints
};

/// A path in the plane, by its length s from the first waypoint [m]. A closed one goes on for ever, lap
/// after lap; an open one goes on straight beyond its end. A value; what asks it neither throws nor
/// allocates, and takes the logarithm of the number of its pieces.
class Path {
 public:
  /// A straight piece. Of a spline, its direction turns along it as the spline's does.
  struct Piece {
    Vector2 p_P;                       ///< where it begins [m]
    double s = 0.0;                    ///< there [m]
    double direction = 0.0;            ///< there, from x of P [rad]
    double turn = 0.0;                 ///< of the direction along it [rad]
    double facing = 0.0, swing = 0.0;  ///< the same of the facing; not a number where none is given
    double speed = 0.0;                ///< bound [m/s]
    std::size_t waypoint = 0;          ///< the last one before it, from 0
  };

  /// @pre faults_of() finds none in the waypoints
  Path(const std::vector<Waypoint>& waypoints, Shape shape, bool closed);

  [[nodiscard]] double length() const noexcept { return length_; }  ///< of a lap [m]
  [[nodiscard]] bool closed() const noexcept { return closed_; }
  [[nodiscard]] bool has_facing() const noexcept { return has_facing_; }
  [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }
  [[nodiscard]] double end_of(std::size_t piece) const noexcept;  ///< where it ends [m]

  [[nodiscard]] Vector2 at(double s) const noexcept;        ///< [m], in P
  [[nodiscard]] double direction(double s) const noexcept;  ///< from x of P, in (−π, π] [rad]
  [[nodiscard]] double facing(double s) const noexcept;     ///< the same of the facing
  [[nodiscard]] double speed(double s) const noexcept;      ///< bound [m/s]

  /// The place nearest to a point among those from `from` to `to`; of several the first [m].
  [[nodiscard]] double nearest(const Vector2& p_P, double from, double to) const noexcept;

 private:
  /// A place, as a piece and the way along it.
  struct Place {
    std::size_t piece = 0;
    double along = 0.0;  ///< [m]; beyond an end, negative or more than the piece is long
  };
  [[nodiscard]] Place place(double s) const noexcept;
  [[nodiscard]] Vector2 point(const Place& place) const noexcept;
  [[nodiscard]] double share_of(const Place& place) const noexcept;
  void face(const std::vector<Waypoint>& waypoints);

  std::vector<Piece> pieces_;
  Vector2 end_P_ = Vector2::Zero();  ///< of the last piece [m]
  double length_ = 0.0;
  bool closed_ = false, has_facing_ = false;
};

}  // namespace hexagait::path_following
