// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/executor/detail/foot_motion.hpp>
#include <hexagait/executor/detail/phase_change.hpp>
#include <hexagait/executor/detail/reflexes.hpp>
#include <hexagait/executor/foothold_search.hpp>

namespace hexagait {
namespace {

// The next foothold that is tried, of the way there.
constexpr double kCloser = 0.6;
// Who has collided more often than this is before a high wall, and rises by so many times more.
constexpr int kLowTries = 2;
constexpr double kHigher = 2.0;
// After so many tries a foot stands on an edge all the same; beside a hole it would slide into it.
constexpr int kEdgeTries = 2, kEdgeTriesAtHole = 12;
// Of the search for a foothold, in times that a foot moves back in a retreat.
constexpr double kSearchWidth = 2.0;

void let_go(LegLane& lane, const LegSensed& sensed) {
  lane.p_BF += sensed.off;
  lane.v_O.setZero();
  lane.a_O.setZero();
  lane.transfer_clock = 0.0;
  lane.bounces = 0;
  lane.haste = 1.0;
}

// How far the foot is below the ground that is expected [m].
double depth_of(const LegLane& lane, const LegSensed& sensed, const Pose& X_OB) {
  return lane.step.p_OT.z() - foot_height(lane, sensed, X_OB);
}

void search_elsewhere(LegLane& lane, const SwingParams& params) {
  if (lane.retreats < params.max_retreats) return;
  if (lane.retreats == params.max_retreats) {
    lane.reach_fraction = 0.0;
    return;
  }
  const FootholdTry next = searched_foothold(lane.retreats - params.max_retreats - 1);
  lane.reach_fraction = next.along;
  lane.beside = next.beside * kSearchWidth * params.retreat_back;
}

}  // namespace

bool gives_up(const LegLane& lane, const SwingParams& params) noexcept {
  return lane.retreats >= params.max_retreats;
}

void retreat(LegLane& lane, const LegSensed& sensed, const Pose& X_OB,
             const SwingParams& params) noexcept {
  enter(lane, LegPhase::retreat);
  let_go(lane, sensed);
  const Vector2 p_OF = (X_OB * lane.p_BF).head<2>(), back = p_OF - lane.step.p_OT.head<2>();
  const double distance = back.norm();
  lane.back_O = p_OF;
  if (distance != 0.0) lane.back_O += back * (params.retreat_back / distance);  // NaN stays one
  ++lane.retreats;
  if (lane.retreats < params.max_retreats)
    lane.apex_z += params.retreat_up * (lane.retreats > kLowTries ? kHigher : 1.0);
  search_elsewhere(lane, params);
}

void retreat_closer(LegLane& lane, const LegSensed& sensed, const Pose& X_OB,
                    const SwingParams& params) noexcept {
  lane.reach_fraction *= kCloser;
  retreat(lane, sensed, X_OB, params);
}

bool is_edge(const LegLane& lane, const LegSensed& sensed, const Pose& X_OB) noexcept {
  const SearchDepth& depth = lane.step.depth;
  const double below = depth_of(lane, sensed, X_OB);
  const bool at_edge = depth.edge < below && below < depth.edge_end;
  const int tries = depth.hole_known() ? kEdgeTriesAtHole : kEdgeTries;
  return at_edge && lane.retreats < tries && !lane.regains;
}

void leave_edge(LegLane& lane, const LegSensed& sensed, const Pose& X_OB,
                const SwingParams& params) noexcept {
  if (lane.step.depth.hole_known())
    climb_out(lane, sensed, X_OB);
  else
    retreat_closer(lane, sensed, X_OB, params);
}

bool may_be_wall(const LegLane& lane, const LegSensed& sensed, const Pose& X_OB,
                 const SwingParams& params) noexcept {
  const SearchDepth& depth = lane.step.depth;
  const double below = depth_of(lane, sensed, X_OB);
  return depth.presses && below >= depth.edge_end && !lane.regains && !gives_up(lane, params);
}

void climb_out(LegLane& lane, const LegSensed& sensed, const Pose& X_OB) noexcept {
  enter(lane, LegPhase::lift);
  let_go(lane, sensed);
  lane.found_no_ground = true;
  lane.rises_from = lane.stood_at = height_of(lane, X_OB);
  ++lane.retreats;
  lane.reach_fraction = 1.0;
  lane.beside = 0.0;
}

}  // namespace hexagait
