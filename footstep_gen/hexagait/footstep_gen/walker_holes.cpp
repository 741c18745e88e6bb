// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/footstep_gen/walker.hpp>

/// What a Walker learns about holes, and how its footholds keep clear of them.
namespace hexagait::footstep_gen {
namespace {

constexpr double kHole = 0.5, kBeside = 1.0, kInPlace = 0.25;  // of the workspace radius

}  // namespace

// A robot that does not get on in spite of what it knows begins anew.
void Walker::learn_holes() noexcept {
  if (record_.escape.phase == EscapePhase::moves) holes_ = {};
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    const LegLane& lane = executor_.legs()[i];
    const double near = holes_.empty() ? 0.0 : kInPlace * executor_.stance().radius[i];
    if (lane.touched_down) in_place_.landed(i, record_.state.print_O[i].head<2>(), near);
    if (lane.found_no_ground) holes_.add((record_.state.X_OB * lane.p_BF).head<2>());
  }
}

// (step 5)
void Walker::keep_clear_of_holes(FootstepCommand& step, double to_come) const noexcept {
  step.depth.at_end = params_.step.max_height;
  step.depth.edge = edge_depth(spread_, model_->foot_radius);
  step.depth.edge_end = model_->foot_radius;
  step.depth.presses = params_.sensors.joint_feedback && step.depth.edge < SearchDepth::kNever;
  if (holes_.empty()) return;
  const LegId i = step.leg;
  const double radius = executor_.stance().radius[i];
  const Vector3 end_O = record_.state.X_OB * aep(record_.arc, i, radius + to_come);
  const Foothold place = clear_of(holes_, record_.state.print_O[i].head<2>(), step.p_OT.head<2>(),
                                  end_O.head<2>(), kHole * radius * in_place_.caution(i));
  step.p_OT.head<2>() = place.p_O;
  if (place.off < kBeside * radius) step.depth.beside_hole = params_.step.height;
}

}  // namespace hexagait::footstep_gen
