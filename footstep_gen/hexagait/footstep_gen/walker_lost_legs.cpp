// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/detail/stance_from_above.hpp>
#include <hexagait/footstep_gen/roughness.hpp>
#include <hexagait/footstep_gen/walker.hpp>

/// What a Walker does about legs that it loses, and without them.
namespace hexagait::footstep_gen {
namespace {

constexpr double kCatching = 2.5;  // times of a lift, after a leg is lost

}  // namespace

void Walker::lose_leg(LegId leg) noexcept {
  if (leg < 0 || leg >= model_->num_legs() || lost_legs().contains(leg)) return;
  executor_.lose(leg);
  record_.lost = lost_legs();
  catches_until_ =
      ticks_ + std::lround(kCatching * params_.executor.swing.lift_time / params_.control_dt);
  recentre();
}

// The stance for the legs that there are.
void Walker::recentre() noexcept {
  const LegSet lost = lost_legs();
  level_ = lost.empty() ? stance_of_all_
                        : stance_without(lost, *model_, stance_of_all_, executor_.p_BM().head<2>());
  executor_.set_stance(level_);
  record_.arc = arc_of(record_.heading);
  tracker_.follow(record_.arc.per_metre);
}

void Walker::find_faults() noexcept {
  leg_watch_.watch(*model_, executor_, record_.state, record_.measurement, params_.sensors,
                   stands_level() && !crawls(), params_.control_dt);
  record_.findings = leg_watch_.findings();
  for (LegId i = 0; !record_.findings.silent.empty() && i < model_->num_legs(); ++i)
    if (record_.findings.silent.contains(i)) lose_leg(i);
}

// Are the last prints about as high as each other?
bool Walker::stands_level() const noexcept {
  return print_spread_ <= kLevelUpTo * params_.step.height;
}

// Does the robot sink on a leg, or may one be gone? Level ground does not give way: where a foot there has lost its contact,
// and not found it for lost_time, its leg may be gone. Over rough ground feet lose their contact every so often.
bool Walker::loses_footing() const noexcept {
  if (!lost_legs().empty()) return false;
  if (!leg_watch_.sinking().empty()) return true;
  if (!stands_level()) return false;
  return std::ranges::any_of(executor_.legs(), [this](const LegLane& lane) {
    return lane.regains && lane.phase == LegPhase::descend && !lane.touching &&
           lane.time > params_.executor.swing.lost_time;
  });
}

// Feet that are up when a leg is lost may have left the centre of mass outside those that stand: it falls
// slowly, and they may be there first. A foot on its way to where the body falls to goes on: there it holds the body, and
// its swing there slows the fall.
void Walker::catch_fall() noexcept {
  const Pose& X_OB = record_.state.X_OB;
  const auto [feet, p_M] = stance_from_above(executor_, X_OB.R);
  const LegSet bear = without(executor_.support(), leg_watch_.sinking());
  const SupportPolygon polygon = support_polygon(feet, bear);
  if (stability_margin(polygon, p_M) >= -params_.step.stability_margin) return;
  LegSet down = LegSet::all(model_->num_legs());
  if (polygon.size > 1) {
    const Vector2 inwards = nearest_edge(polygon, p_M).inwards;
    for (LegId i = 0; i < model_->num_legs(); ++i) {
      const LegLane& lane = executor_.legs()[i];
      const Vector2 way = (lane.step.p_OT - X_OB.p - feet[i]).head<2>();
      const bool goes_out = inwards.dot(way) < -params_.step.stability_margin;
      if (lane.phase == LegPhase::transfer && goes_out) down.erase(i);
    }
  }
  executor_.put_down(down);
}

}  // namespace hexagait::footstep_gen
