// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <hexagait/math/geometry.hpp>
#include <span>
#include <vector>

namespace hexagait {

/// Bounds within which no motion overflows: its values and their derivatives in SI units, its time,
/// and the time between its nodes [s]. Between them a quintic's coefficients are at most 1e12 / 1e-45.
inline constexpr double kLargestMotion = 1e12;
inline constexpr double kShortestSegment = 1e-9;

/// Position, velocity and acceleration of a point [m], or of three joints [rad].
struct PointState {
  Vector3 p = Vector3::Zero();  ///< position
  Vector3 v = Vector3::Zero();  ///< velocity [1/s]
  Vector3 a = Vector3::Zero();  ///< acceleration [1/s²]
};

/// Are all values numbers of at most kLargestMotion?
template <class Derived>
[[nodiscard]] bool in_range(const Eigen::MatrixBase<Derived>& values) noexcept {
  return (values.array().abs() <= kLargestMotion).all();
}

/// The polynomial of degree 5 with given position, velocity and acceleration at both ends. From
/// rest to rest it is the minimum-jerk motion σ(τ) = 10τ³ − 15τ⁴ + 6τ⁵ (Flash & Hogan 1985).
struct Quintic {
  std::array<Vector3, 6> c;  ///< coefficients of t⁰ … t⁵

  /// @param t  since the start [s], in [0, duration]
  [[nodiscard]] PointState at(double t) const noexcept;
};

/// @param duration  at least kShortestSegment [s]
[[nodiscard]] Quintic quintic(const PointState& from, const PointState& to,
                              double duration) noexcept;

/// The value of quintic(from, to, duration) at one time.
/// @param t  since `from` [s]; clamped into [0, duration], where `from` and `to` stand
[[nodiscard]] PointState quintic(const PointState& from, const PointState& to, double duration,
                                 double t) noexcept;

/// Ratio of peak to mean speed of the minimum-jerk motion: σ'(½).
inline constexpr double kMinimumJerkPeak = 1.875;

/// Velocity and acceleration at the middle of three knots, of the parabola through them:
///
///     v = (T₊ s₋ + T₋ s₊) / (T₋ + T₊),   a = 2 (s₊ − s₋) / (T₋ + T₊)
///
/// with s₋, s₊ the mean velocities of the segments before and after it and T₋, T₊ their durations.
struct KnotRates {
  Vector3 v = Vector3::Zero();
  Vector3 a = Vector3::Zero();
};
[[nodiscard]] KnotRates parabola_rates(const Vector3& slope_before, double time_before,
                                       const Vector3& slope_after, double time_after) noexcept;

/// The knots that a curve can use: those after time 0, up to the first whose time does not increase
/// by kShortestSegment, at most `capacity`. Loaders refuse all others.
template <class Knot>
[[nodiscard]] std::span<const Knot> usable_knots(std::span<const Knot> knots,
                                                 std::size_t capacity) noexcept {
  std::size_t first = 0;
  while (first < knots.size() && !(knots[first].time >= kShortestSegment)) ++first;
  std::size_t count = first < knots.size() && capacity > 0 ? 1 : 0;
  while (count > 0 && count < capacity && first + count < knots.size() &&
         knots[first + count].time - knots[first + count - 1].time >= kShortestSegment)
    ++count;
  return knots.subspan(first, count);
}

/// A motion through given PointStates at given times: a quintic() between each two. Position,
/// velocity and acceleration are continuous (C2) for any choice of states.
///
/// Only reserve() allocates. A value: a copy has the same capacity, and assignment to a spline of
/// sufficient capacity does not allocate.
class QuinticSpline {
 public:
  QuinticSpline() = default;
  QuinticSpline(const QuinticSpline& other) { *this = other; }
  QuinticSpline(QuinticSpline&&) noexcept = default;
  QuinticSpline& operator=(const QuinticSpline& other);
  QuinticSpline& operator=(QuinticSpline&&) noexcept = default;
  ~QuinticSpline() = default;

  /// Allocates space for this many nodes.
  void reserve(std::size_t nodes) { nodes_.reserve(nodes); }
  [[nodiscard]] std::size_t capacity() const noexcept { return nodes_.capacity(); }

  /// Removes all nodes and adds one at time 0. Does nothing without capacity.
  void start(const PointState& state) noexcept;
  /// Adds a node. Does nothing if `time` is not after that of the last node by kShortestSegment, or
  /// the spline is full.
  void add(double time, const PointState& state) noexcept;

  /// Are all nodes within kLargestMotion? Then at() is finite at any time.
  [[nodiscard]] bool in_range() const noexcept;

  /// Time of the last node [s]; 0 without nodes.
  [[nodiscard]] double duration() const noexcept;
  /// @param t  clamped into [0, duration()] [s]
  /// @returns position, velocity and acceleration; zero without nodes
  [[nodiscard]] PointState at(double t) const noexcept;
  /// As at(), faster for times that increase: caches the polynomial of the present segment.
  [[nodiscard]] PointState along(double t) noexcept;

  struct Node {
    double time = 0.0;
    PointState state;
  };
  [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }
  /// Index of the node that starts the segment at t.
  /// @pre at least two nodes
  [[nodiscard]] std::size_t segment(double t) const noexcept;

 private:
  std::vector<Node> nodes_;
  Quintic piece_;  ///< cached, for [piece_begin_, piece_end_]; none if these are equal
  double piece_begin_ = 0.0, piece_end_ = 0.0;
};

}  // namespace hexagait
