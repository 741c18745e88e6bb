// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/serial_stance.hpp>
#include <hexagait/model/workspace.hpp>

namespace hexagait {
namespace {

constexpr double kLargestRadius = 1.0 / 3.0;  // of femur + tibia

double hip_to_foot(const LegModel& leg, double knee) {
  const double f = leg.femur, t = leg.tibia;
  return std::sqrt(f * f + t * t + 2.0 * f * t * portable::cos(knee));
}

/// Distance that the foot can move from p_BC along a direction, at most `farthest` [m].
double reach_along(const LegModel& leg, const Vector3& direction_B, double farthest) {
  LegJoints near = leg.q_nominal;
  const auto reachable = [&](double s) {
    const LegSolution solution = inverse_kinematics(leg, leg.p_BC + s * direction_B, near);
    if (solution.reachable) near = solution.q;
    return solution.reachable;
  };
  // Steps outwards, so as not to miss a gap; then bisects the step that contains the end. Coarser
  // for serial legs, whose inverse kinematics are slower.
  const bool serial = leg.kind == LegKind::serial;
  const int steps = serial ? 20 : 50, halvings = serial ? 15 : 40;
  double inside = 0.0, outside = farthest;
  for (int k = 1; k <= steps; ++k) {
    const double s = farthest * k / steps;
    outside = s;
    if (!reachable(s)) break;
    inside = s;
  }
  for (int k = 0; k < halvings && inside < outside; ++k) {
    const double middle = 0.5 * (inside + outside);
    (reachable(middle) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace

Reach leg_reach(const LegModel& leg) {
  const JointLimits& knee = leg.limits[2];
  const double length = leg.femur + leg.tibia, margin = kSingularMargin * length;

  // Canonical knee interval, shifted by multiples of 2π so that its middle is nearest to π/2.
  const double bent = 0.5 * std::numbers::pi, half = 0.5 * (knee.upper - knee.lower);
  const double centre = leg.joint_sign[2] * (knee.lower + half) + leg.joint_offset[2];
  const double middle = bent + wrap_angle(centre - bent);
  const double straightest = std::max(middle - half, 0.0);
  const double most_bent = std::min(middle + half, std::numbers::pi);
  if (straightest > most_bent) return {.min = length, .max = 0.0};

  return {.min = std::max(hip_to_foot(leg, most_bent), std::abs(leg.femur - leg.tibia) + margin),
          .max = std::min(hip_to_foot(leg, straightest), length - margin)};
}

Vector3 nominal_foot(const LegModel& leg) {
  return leg.X_BH * Vector3(leg.coxa + leg.femur, 0.0, -(leg.femur + leg.tibia) / kHeightRatio);
}

double reachable_radius(const LegModel& leg) {
  const bool serial = leg.kind == LegKind::serial;
  const int directions = serial ? 24 : 120;
  const SerialLengths lengths = serial ? serial_lengths(leg) : SerialLengths{};
  double radius = kLargestRadius * (serial ? lengths.upper + lengths.rest : leg.femur + leg.tibia);
  for (int k = 0; k < directions; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / directions;
    Vector3 direction_H = Vector3::Zero();
    direction_H.head<2>() = unit_vector(angle);
    radius = std::min(radius, reach_along(leg, leg.X_BH.R * direction_H, radius));
  }
  return radius;
}

}  // namespace hexagait
