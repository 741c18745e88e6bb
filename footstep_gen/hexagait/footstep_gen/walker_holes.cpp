// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/footstep_gen/walker.hpp>
#include <limits>
#include <optional>

/// What a Walker learns about holes, and how its footholds keep clear of them.
namespace hexagait::footstep_gen {
namespace {

// Of the workspace radius.
constexpr double kHole = 0.5, kBeside = 1.0, kInPlace = 0.25;
constexpr double kHalfStone = 0.2;  // half the width of a hole between stepping stones
constexpr double kShows = 0.25;     // from a foot on a stone to the holes beside it
constexpr double kWithin = 1.1;     // in which feet stay
// Of the robot's outer radius: the way after which holes are forgotten, and that they are ditches.
constexpr double kForgets = 2.0, kForgetsDitches = 6.0;
// Of the foot's radius: so even is ground on which edges are felt, and so deep a hole between stones is searched.
constexpr double kEven = 0.5, kShallow = 2.0;

}  // namespace

// In odom.
Vector2 Walker::along_path(LegId leg) const noexcept {
  const Vector2 way = record_.arc.direction[leg];
  const Vector3 way_O = record_.state.X_OB.R * Vector3(way.x(), way.y(), 0.0);
  const double length = way_O.head<2>().norm();
  return length > 0.0 ? Vector2(way_O.head<2>() / length) : Vector2::UnitX();
}

// Of its path.
bool Walker::on_the_left(LegId leg) const noexcept {
  const Vector3 centre_O = record_.state.X_OB.R * executor_.stance().p_BC[leg];
  return perpendicular(along_path(leg)).dot(centre_O.head<2>()) > 0.0;
}

void Walker::learn_holes() noexcept {
  const Vector2 base_O = record_.state.X_OB.p.head<2>();
  const double size = params_.executor.base.outer_radius;
  if (holes_.empty()) beside_.forget(base_O, kForgetsDitches * size);
  holes_.forget_beyond(base_O, kForgets * size);
  // A robot that does not get on in spite of what it knows begins anew.
  if (record_.escape.phase == EscapePhase::moves && !beside_.any()) holes_ = {};
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    const LegLane& lane = executor_.legs()[i];
    const double radius = executor_.stance().radius[i];
    const double near = holes_.empty() ? 0.0 : kInPlace * radius;
    if (lane.touched_down) {
      const Vector2 print_O = record_.state.print_O[i].head<2>();
      in_place_.landed(i, print_O, near);
      beside_.landed(i, on_the_left(i), holes_.beside(print_O, along_path(i), kShows * radius));
    }
    if (lane.found_no_ground) {
      beside_.failed(i, on_the_left(i), base_O);
      holes_.add((record_.state.X_OB * lane.p_BF).head<2>());
    }
  }
  if (!holes_.empty()) print_plane_ = plane_through(record_.state.print_O);
  holes_.set_half_width(beside_.any() ? kHalfStone * executor_.stance().radius[0]
                                      : std::numeric_limits<double>::infinity());
}

// (step 5), (step 13)
void Walker::keep_clear_of_holes(FootstepCommand& step, double to_come) const noexcept {
  SearchDepth& depth = step.depth;
  depth.at_end = params_.step.max_height;
  depth.edge = edge_depth(felt_spread_, model_->foot_radius);
  depth.edge_end = model_->foot_radius;
  depth.presses = params_.sensors.joint_feedback && depth.edge < SearchDepth::kNever;
  if (holes_.empty()) return;
  const LegId i = step.leg;
  const double radius = executor_.stance().radius[i];
  const auto along_arc = [&](double way) {
    return Vector2((record_.state.X_OB * aep(record_.arc, i, way)).head<2>());
  };
  const bool left = on_the_left(i);
  const Vector2 outwards = (left ? radius : -radius) * perpendicular(along_path(i));
  const Vector2 aside = beside_.outwards(left) * outwards;
  const bool stones = beside_.any();
  const Foothold place =
      clear_of(holes_, record_.state.print_O[i].head<2>(), step.p_OT.head<2>() + aside,
               along_arc(radius + to_come) + aside, kHole * radius * in_place_.caution(i),
               stones ? std::optional<Disc>({along_arc(to_come), kWithin * radius}) : std::nullopt);
  step.p_OT.head<2>() = place.p_O;
  // Beside a hole an edge counts, also where feet that stand on edges make the prints differ, or odometry tilts.
  if (print_plane_.off < kEven * model_->foot_radius) {
    step.p_OT.z() = print_plane_.at(place.p_O);
    depth.edge = edge_depth(print_plane_.off, model_->foot_radius);
    depth.presses = params_.sensors.joint_feedback;
  }
  if (stones || place.off < kBeside * radius) depth.beside_hole = params_.step.height;
  if (stones && depth.presses) depth.beside_hole = kShallow * model_->foot_radius;
}

}  // namespace hexagait::footstep_gen
