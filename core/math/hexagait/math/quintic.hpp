// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <hexagait/math/geometry.hpp>
#include <span>
#include <vector>

namespace hexagait {

/// Where a point is and how it moves: of a foot [m], or the three joints of a leg [rad].
struct PointState {
  Vector3 p = Vector3::Zero();  ///< position
  Vector3 v = Vector3::Zero();  ///< velocity [1/s]
  Vector3 a = Vector3::Zero();  ///< acceleration [1/s²]
};

/// The polynomial of degree 5 that meets position, velocity and acceleration at both ends. From
/// rest to rest it is the minimum-jerk motion σ(τ) = 10τ³ − 15τ⁴ + 6τ⁵ (Flash & Hogan 1985).
struct Quintic {
  std::array<Vector3, 6> c;  ///< of t⁰ … t⁵

  /// @param t  since the begin [s]; between the ends
  [[nodiscard]] PointState at(double t) const noexcept;
};

/// @param duration  > 0 [s]
[[nodiscard]] Quintic quintic(const PointState& from, const PointState& to,
                              double duration) noexcept;

/// One value of it.
/// @param t  since `from` [s]; the ends hold before and after
[[nodiscard]] PointState quintic(const PointState& from, const PointState& to, double duration,
                                 double t) noexcept;

/// Peak over mean speed of the minimum-jerk motion: σ'(½).
inline constexpr double kMinimumJerkPeak = 1.875;

/// Velocity and acceleration at the middle one of three knots: those of the parabola through them.
///
///     v = (T₊ s₋ + T₋ s₊) / (T₋ + T₊),   a = 2 (s₊ − s₋) / (T₋ + T₊)
///
/// s₋, s₊ are the mean velocities before and after the knot, T₋, T₊ the times these take.
struct KnotRates {
  Vector3 v = Vector3::Zero();
  Vector3 a = Vector3::Zero();
};
[[nodiscard]] KnotRates parabola_rates(const Vector3& slope_before, double time_before,
                                       const Vector3& slope_after, double time_after) noexcept;

/// The knots that a curve can use: those later than 0, up to the first that isn't later than the
/// one before it, at most `capacity`. The loaders refuse what would be left out here.
template <class Knot>
[[nodiscard]] std::span<const Knot> usable_knots(std::span<const Knot> knots,
                                                 std::size_t capacity) noexcept {
  std::size_t first = 0;
  while (first < knots.size() && !(knots[first].time > 0.0)) ++first;
  std::size_t count = first < knots.size() && capacity > 0 ? 1 : 0;
  while (count > 0 && count < capacity && first + count < knots.size() &&
         knots[first + count].time > knots[first + count - 1].time)
    ++count;
  return knots.subspan(first, count);
}

/// A motion through given PointStates at given times, a quintic() between neighbours. Position,
/// velocity and acceleration are continuous (C2) whatever the states are: who makes a motion
/// chooses states, and has nothing left to do for continuity.
///
/// Only reserve() allocates. A value: a copy has the same room, and assignment to a spline that has
/// as much room doesn't allocate.
class QuinticSpline {
 public:
  QuinticSpline() = default;
  QuinticSpline(const QuinticSpline& other) { *this = other; }
  QuinticSpline(QuinticSpline&&) noexcept = default;
  QuinticSpline& operator=(const QuinticSpline& other);
  QuinticSpline& operator=(QuinticSpline&&) noexcept = default;
  ~QuinticSpline() = default;

  /// Room for so many nodes.
  void reserve(std::size_t nodes) { nodes_.reserve(nodes); }
  [[nodiscard]] std::size_t capacity() const noexcept { return nodes_.capacity(); }

  /// Forgets all nodes and begins at time 0. Without any room nothing is kept.
  void start(const PointState& state) noexcept;
  /// @pre time is later than that of the last node, and there is room; else nothing happens
  void add(double time, const PointState& state) noexcept;

  /// Time of the last node [s]; 0 if there is none.
  [[nodiscard]] double duration() const noexcept;
  /// @param t  clamped into [0, duration()] [s]; a spline without nodes is at rest at 0
  [[nodiscard]] PointState at(double t) const noexcept;
  /// The same for who goes along: remembers the polynomial of the segment that it is in.
  [[nodiscard]] PointState along(double t) noexcept;

  struct Node {
    double time = 0.0;
    PointState state;
  };
  [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }
  /// Index of the node before t, at most the last but one. @pre two nodes or more
  [[nodiscard]] std::size_t segment(double t) const noexcept;

 private:
  std::vector<Node> nodes_;
  Quintic piece_;  ///< from piece_begin_ to piece_end_, if that is later
  double piece_begin_ = 0.0, piece_end_ = 0.0;
};

}  // namespace hexagait
