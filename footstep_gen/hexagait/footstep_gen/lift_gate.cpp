// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/lift_gate.hpp>
#include <limits>
#include <optional>

namespace hexagait::footstep_gen {
namespace {

constexpr double kSwayWeight = 0.2, kAlongWeight = 0.02;  // of (crawl 1)
constexpr double kDetour = 2.0;   // of the sway across the path, over the shortest one
constexpr double kSpacing = 0.8;  // of T over the number of legs in the air
constexpr double kBeyond = 1.2;   // the base goes farther than the gate asks, of the margin

// The shortest displacement along ± `direction` after which a point is `margin` inside all edges, if
// there is one.
std::optional<Vector2> way_across(const SupportPolygon& polygon, const Vector2& point,
                                  const Vector2& direction, double margin) {
  double least = -std::numeric_limits<double>::infinity(), most = -least;
  for (int k = 0; k < polygon.size; ++k) {
    const PolygonEdge edge = edge_of(polygon, k);
    const double lack = margin - edge.inwards.dot(point - edge.from);
    const double gain = edge.inwards.dot(direction);
    if (gain > 0.0)
      least = std::max(least, lack / gain);
    else if (gain < 0.0)
      most = std::min(most, lack / gain);
    else if (lack > 0.0)
      return std::nullopt;
  }
  if (least > most) return std::nullopt;
  return direction * std::clamp(0.0, least, most);
}

// Displacement of a point that is then `margin` inside all edges; if there is no such point, one
// that is equally far inside of those that matter. By turns onto each edge.
Vector2 way_inside(const SupportPolygon& polygon, const Vector2& point, double margin) {
  constexpr int kRounds = 12;
  Vector2 there = point;
  for (int round = 0; round < kRounds; ++round) {
    for (int k = 0; k < polygon.size; ++k) {
      const PolygonEdge edge = edge_of(polygon, k);
      there += std::max(0.0, margin - edge.inwards.dot(there - edge.from)) * edge.inwards;
    }
  }
  return there - point;
}

Vector2 sway_for(const LiftGateInput& in, const SupportPolygon& rest, double margin) {
  const Vector2 shortest = way_inside(rest, in.p_M, margin);
  const double length = in.path.norm();
  if (!(length > 0.0)) return shortest;
  const auto across = way_across(rest, in.p_M, perpendicular(in.path) / length, margin);
  return across && across->norm() < kDetour * shortest.norm() ? *across : shortest;
}

SupportPolygon without_leg(const LiftGateInput& in, LegId leg) {
  LegSet rest = in.support;
  rest.erase(leg);
  return support_polygon(in.feet, rest);
}

}  // namespace

LiftGateDecision LiftGate::update(const LiftGateInput& in) noexcept {
  if (next >= 0 && !(in.may_step.contains(next) && in.support.contains(next))) next = -1;
  if (next < 0) {
    double best = -std::numeric_limits<double>::infinity();
    for (LegId i = 0; i < in.feet.size(); ++i) {
      if (!in.may_step.contains(i) || !in.support.contains(i)) continue;
      const SupportPolygon rest = without_leg(in, i);
      if (rest.size < 3) continue;
      const double way = sway_for(in, rest, in.margin).norm();
      const double merit = in.lag[i] - kSwayWeight * way - kAlongWeight * in.along[i];
      if (merit <= best) continue;
      best = merit;
      next = i;
    }
  }
  LiftGateDecision decision;
  if (next < 0) return decision;
  const SupportPolygon rest = without_leg(in, next);
  if (rest.size < 3) return decision;
  if (stability_margin(rest, in.p_M) >= in.margin) decision.open.insert(next);
  decision.sway = sway_for(in, rest, kBeyond * in.margin);
  return decision;
}

LegId hindmost(LegSet legs, const LegArray<double>& lag) noexcept {
  LegId most = -1;
  for (LegId i = 0; i < lag.size(); ++i)
    if (legs.contains(i) && (most < 0 || lag[i] > lag[most])) most = i;
  return most;
}

LegSet steady_lifts(const LegArray<Vector3>& feet, const Vector2& p_M, LegSet support, LegSet legs,
                    const LegArray<double>& lag, double margin) noexcept {
  const auto stands = [&](LegSet lifted) {
    const SupportPolygon rest = support_polygon(feet, without(support, lifted));
    return rest.size > 2 && stability_margin(rest, p_M) > margin;
  };
  if (stands(legs)) return legs;
  LegSet some;
  while (!legs.empty()) {
    const LegId next = hindmost(legs, lag);
    legs.erase(next);
    some.insert(next);
    if (!stands(some)) some.erase(next);
  }
  return some;
}

double lift_spacing(const LegArray<double>& step_time, LegSet lost, int most) noexcept {
  double shortest = std::numeric_limits<double>::infinity();
  for (LegId i = 0; i < step_time.size(); ++i)
    if (!lost.contains(i)) shortest = std::min(shortest, step_time[i]);
  return kSpacing * shortest / most;
}

LegSet BalanceWait::update(const BalanceWaitInput& in) noexcept {
  since = std::max(since, in.last_lift);
  if (!in.waits.empty() && in.time - since > in.patience) {
    first.hold(in.waits, in.ring);
    since = in.time;
  }
  const LegSet stand = in.ring.present() & in.support;
  first.release(without(first.held(), stand));
  if (without(stand, first.update(stand, in.ring)).empty()) first = {};
  return first.held();
}

Vector2 way_over(const LegArray<Vector3>& feet, const Vector2& p_M, LegSet legs,
                 double margin) noexcept {
  const SupportPolygon polygon = support_polygon(feet, legs);
  return polygon.size > 2 ? way_inside(polygon, p_M, margin) : Vector2(Vector2::Zero());
}

void sway(BaseAutoCommand& base, const Vector2& sway) noexcept {
  base.sway = sway;
  base.min_advance = 0.0;
  base.max_braking = 0.0;  // a sway is off the path on purpose
  if (base.path.v.dot(sway) < 0.0) base.max_advance = 0.0;
}

}  // namespace hexagait::footstep_gen
