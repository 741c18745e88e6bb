// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <limits>
#include <optional>
#include <span>

namespace hexagait::footstep_gen {

/// Where feet have found no ground of late. What one leg has learnt, all others expect.
class Holes {
 public:
  /// Remembers a place; if there are many, it forgets the oldest.
  void add(const Vector2& p_O) noexcept;
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  /// Forgets those that are farther away.
  void forget_beyond(const Vector2& p_O, double distance) noexcept;
  /// Half their width, across the way [m]; ∞ at first: they are ditches.
  void set_half_width(double half_width) noexcept { half_width_ = half_width; }
  /// Are there holes beside that place, at least `near` across the way and at most six times as far from it, one of
  /// them farther along and another one not [m]? Then the ground there is no edge of a ditch.
  [[nodiscard]] bool beside(const Vector2& p_O, const Vector2& along_O, double near) const noexcept;
  /// From the nearest of them to a place, with that across a direction counted by a twentieth: ditches are taken
  /// to be as wide as the robot. Holes whose width ends before that place don't count [m]; ∞ if there is none.
  /// @param along_O  unit vector
  [[nodiscard]] double distance(const Vector2& p_O, const Vector2& along_O) const noexcept;

 private:
  static constexpr int kPlaces = 16;
  [[nodiscard]] std::span<const Vector2> places() const noexcept {
    return std::span(places_).first(static_cast<std::size_t>(size_));
  }

  std::array<Vector2, kPlaces> places_{};  // oldest first
  double half_width_ = std::numeric_limits<double>::infinity();
  int size_ = 0;
};

/// How often in a row each leg has stepped in place, since the ground beyond is in the margin of a hole. Holes are not
/// as wide as their margin: with each such step a leg is less cautious.
class StepsInPlace {
 public:
  explicit StepsInPlace(int legs) : print_O_(legs, Vector2::Zero()), times_(legs, 0) {}

  /// A foot has landed. Less than `near` from where it stood, that was a step in place [m].
  void landed(LegId leg, const Vector2& p_O, double near) noexcept {
    times_[leg] = (p_O - print_O_[leg]).norm() < near ? times_[leg] + 1 : 0;
    print_O_[leg] = p_O;
  }
  /// Share of the margin of holes that the leg keeps: all of it until it has stepped in place once, then a quarter
  /// less each time, down to 0.3.
  [[nodiscard]] double caution(LegId leg) const noexcept {
    return std::clamp(1.0 - 0.25 * (times_[leg] - 1), 0.3, 1.0);
  }

 private:
  LegArray<Vector2> print_O_;
  LegArray<int> times_;
};

/// [m]
struct Disc {
  Vector2 centre;
  double radius;
};

struct Foothold {
  Vector2 p_O;  ///< [m]
  double off;   ///< distance from the nearest hole, as Holes::distance() counts it [m]
};

/// The foothold where ground is expected (step 5): the one asked for or, if there is a hole, the end of the
/// workspace beyond it, whichever is well clear of holes; then the same, places closer and closer to where the
/// foot stands, and that itself, whichever is outside their radius. If there are holes everywhere, the place of
/// these that is farthest from all holes: so the leg tries one after the other.
/// @param from    where the foot stands [m]; as all others in odom
/// @param to      the foothold asked for [m]
/// @param end     the end of the workspace beyond it [m]
/// @param radius  of a hole [m]
/// @param within  where feet stand well; other places are not considered
[[nodiscard]] Foothold clear_of(const Holes& holes, const Vector2& from, const Vector2& to,
                                const Vector2& end, double radius,
                                const std::optional<Disc>& within = {}) noexcept;

}  // namespace hexagait::footstep_gen
