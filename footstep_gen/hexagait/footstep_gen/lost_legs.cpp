// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/lift_gate.hpp>
#include <hexagait/footstep_gen/lost_legs.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <hexagait/model/kinematics.hpp>
#include <limits>
#include <numbers>

namespace hexagait::footstep_gen {
namespace {

using gait_state::Ring;

constexpr double kFarthest = 0.6;         // of the smallest workspace radius
constexpr int kRadii = 12, kAngles = 16;  // of the grid of shifts
constexpr double kEnough = 0.9;           // of the greatest margin

constexpr LegSet kLeft(0x555U), kRight(0xAAAU);

// All legs to the same side.
LegArray<Vector3> shifted(const LegArray<Vector3>& p_BC, const Vector2& shift) noexcept {
  LegArray<Vector3> moved = p_BC;
  for (Vector3& p : moved) p.head<2>() += shift;
  return moved;
}

// Radius of the disc about a centre that a leg reaches, at most `most`: by bisection.
double disc_about(const LegModel& leg, const Vector3& p_BC, double most) noexcept {
  constexpr int kDirections = 24, kHalvings = 7;
  const LegSolution centre = inverse_kinematics(leg, p_BC);
  if (!centre.reachable) return 0.0;
  for (int k = 0; k < kDirections; ++k) {
    Vector3 way_B = Vector3::Zero();
    way_B.head<2>() = unit_vector(2.0 * std::numbers::pi * k / kDirections);
    const auto reaches = [&](double s) {
      return inverse_kinematics(leg, p_BC + s * way_B, centre.q).reachable;
    };
    if (reaches(most)) continue;
    double inside = 0.0;
    for (double step = 0.5 * most; step > most * std::ldexp(1.0, -kHalvings); step *= 0.5)
      if (reaches(inside + step)) inside += step;
    most = inside;
  }
  return most;
}

}  // namespace

bool may_walk_without(LegSet lost, int legs) noexcept {
  const LegSet left = without(LegSet::all(legs), lost);
  return lost.empty() ||
         (left.size() >= 4 && (left & kLeft).size() >= 2 && (left & kRight).size() >= 2);
}

double least_margin(const LegArray<Vector3>& p_BC, const Vector2& p_BM, LegSet lost) noexcept {
  const Ring ring(p_BC.size(), lost);
  const int lifts = must_crawl(ring.size()) ? 0 : ring.size() / 2;
  double least = std::numeric_limits<double>::infinity();
  for (gait_state::RingBits bits = 0; bits <= gait_state::ring_mask(ring.size()); ++bits) {
    const LegSet air = gait_state::legs_at(bits, ring);
    if (air.size() != lifts || gait_state::breaks_rule_1(air, ring)) continue;
    const SupportPolygon polygon = support_polygon(p_BC, without(ring.present(), air));
    least = std::min(least, stability_margin(polygon, p_BM));
  }
  return least;
}

Stance stance_without(LegSet lost, const RobotModel& model, const Stance& stance,
                      const Vector2& p_BM) noexcept {
  const double radius = *std::ranges::min_element(stance.radius);
  Vector2 best = Vector2::Zero();
  double greatest = least_margin(stance.p_BC, p_BM, lost);
  // From the smallest shift on: a greater one has to be worth it.
  for (int k = 1; k <= kRadii; ++k)
    for (int j = 0; j < kAngles; ++j) {
      const Vector2 shift =
          kFarthest * radius * k / kRadii * unit_vector(2.0 * std::numbers::pi * j / kAngles);
      const double margin = least_margin(shifted(stance.p_BC, shift), p_BM, lost);
      if (kEnough * margin <= greatest) continue;
      greatest = margin;
      best = shift;
    }
  Stance moved{shifted(stance.p_BC, best), stance.radius};
  for (LegId i = 0; i < model.num_legs(); ++i) {
    if (lost.contains(i)) moved.p_BC[i] = stance.p_BC[i];
    if (!lost.contains(i))
      moved.radius[i] = disc_about(model.legs[i], moved.p_BC[i], stance.radius[i]);
  }
  return moved;
}

}  // namespace hexagait::footstep_gen
