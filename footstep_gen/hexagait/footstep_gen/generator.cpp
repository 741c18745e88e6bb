// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/footstep_gen/detail/stance_from_above.hpp>
#include <hexagait/footstep_gen/generator.hpp>
#include <hexagait/footstep_gen/lift_gate.hpp>
#include <hexagait/math/quintic.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/posture/arc_optimum.hpp>
#include <hexagait/posture/clearance.hpp>
#include <hexagait/posture/plane_fit.hpp>

namespace hexagait::footstep_gen {
namespace {

using heading_control::PathArc;

// p_B → p_G, where they are not the same.
class FromBody {
 public:
  explicit FromBody(const Pose* X_BG) : same_(!X_BG) {
    if (X_BG) X_GB_ = X_BG->inverse();
  }
  Vector3 operator()(const Vector3& p_B) const { return same_ ? p_B : Vector3(X_GB_ * p_B); }

 private:
  bool same_;
  Pose X_GB_;
};

// A leg on a foothold that does not hold steps before all others; if all do not, on ice, nothing changes.
void leave_bad_footholds(gait_state::GaitInput& input, const Executor& executor) {
  const LegSet bad = executor.bad_footholds();
  if (bad.empty()) return;
  const auto [least, most] = std::ranges::minmax(input.lag);
  for (LegId i = 0; i < input.lag.size(); ++i)
    if (bad.contains(i)) input.lag[i] += most - least + executor.stance().radius[i];
}

// Stability margins that a sharp change of heading leaves: the legs in the air change their way as well, and take the
// zero-moment point with them.
constexpr double kBrakingMargin = 1.5;

// Fraction of its workspace radius that a support leg may use before the base waits for it.
constexpr double kUsableShare = 0.98;

// [PC04] 4 in closed form: the zero of the gradient along the arc; for height and tilt, the plane
// through the footprints (docs/theory.md 3 explains why not the printed gradients), and the clearance
// over them. The ground is at least as high as a foot that has met an obstacle on its way. A crawling robot needs
// its legs' reach for its sway.
BaseGoal pose_adaptation(const BaseAutoCommand& command, const PoseAdaptationInput& in) {
  const LegSet legs = without(LegSet::all(in.p_BC.size()), in.lost);
  const posture::PlaneFit plane = posture::plane_fit(in.footprint_BF, in.p_BC, legs);
  LegArray<Vector3> ground_BF = in.footprint_BF;
  for (LegId i = 0; i < ground_BF.size(); ++i)
    if (in.blocked.contains(i) && in.p_BF[i].z() > ground_BF[i].z()) ground_BF[i] = in.p_BF[i];
  const double clearance =
      must_crawl(legs.size()) ? 0.0 : posture::clearance(ground_BF, in.p_BC, plane, legs);
  const double advance = posture::arc_optimum(in.p_BF, in.p_BC, in.support, command.path).advance;
  return {advance, plane.height + clearance, plane.roll, plane.pitch};
}

// Path until the foot, which moves backwards along the arc, leaves the disc about its centre [m].
// The arc is replaced by its tangent: short by less than 4 % of the stroke at r = 0.3 m. Of a
// correction: the share of it.
struct WorkspaceLeft {
  double ahead = std::numeric_limits<double>::infinity();
  double back = std::numeric_limits<double>::infinity();  // if it moves the other way
};
WorkspaceLeft workspace_left(const Vector2& offset, const Vector2& direction, double radius) {
  const double speed2 = direction.squaredNorm();
  if (speed2 <= 0.0) return {};
  const double b = offset.dot(direction) / speed2;
  const double square = b * b - (offset.squaredNorm() - radius * radius) / speed2;
  const double root = square <= 0.0 ? 0.0 : std::sqrt(square);
  return {std::max(0.0, b + root), std::max(0.0, -b + root)};
}

// An edge of the support polygon, and how far inside of it the centre of mass is [m].
struct Edge {
  Vector2 inwards;
  double distance;
};

// The support polygon seen along gravity: axes of odom, origin at the body's.
struct SupportEdges {
  InlineArray<Edge, kMaxLegs> edges;
  Vector2 along = Vector2::Zero();  // way of the centre of mass per metre of path
  double height = 0.0;              // of the centre of mass over the feet that stand [m]

  [[nodiscard]] bool has_inside() const { return edges.size() > 2; }
};

SupportEdges support_edges(const PathArc& arc, const Executor& executor, LegSet support,
                           const Matrix3& R_OB) {
  const auto [feet, p_M] = stance_from_above(executor, R_OB);
  const SupportPolygon polygon = support_polygon(feet, support);

  const Vector2 along = direction_at(arc, executor.p_BM());
  SupportEdges edges{InlineArray<Edge, kMaxLegs>(polygon.size)};
  edges.along = (R_OB * Vector3(along.x(), along.y(), 0.0)).head<2>();
  for (int k = 0; k < polygon.size; ++k) {
    const auto [from, inwards] = edge_of(polygon, k);
    edges.edges[k] = {inwards, inwards.dot(p_M - from)};
  }
  double feet_z = 0.0;
  for (LegId i = 0; i < feet.size(); ++i)
    if (support.contains(i)) feet_z += feet[i].z();
  edges.height = (R_OB.row(2) * executor.p_BM()).value() - feet_z / support.size();
  return edges;
}

// How many times `way` the centre of mass may go until it is only `margin` inside of an edge; not less
// than 0.
double times_inside(const SupportEdges& polygon, const Vector2& way, double margin) {
  double times = std::numeric_limits<double>::infinity();
  for (const Edge& edge : polygon.edges)
    if (const double approach = -edge.inwards.dot(way); approach > 0.0)
      times = std::min(times, (edge.distance - margin) / approach);
  return std::max(0.0, times);
}

// Path, ahead (sense 1) or back (−1), until the centre of mass comes closer than `margin` to an edge
// of the support polygon [m].
// The body turns little within a step, so its path is taken to be straight. Two feet hold the body
// for as long as it stays near the line between them: a negative margin is beyond it.
double stability_left(const SupportEdges& polygon, double margin, double sense) {
  if (polygon.edges.size() < 2) return 0.0;
  return times_inside(polygon, sense * polygon.along, margin);
}

// (base 3). The body tilts towards a foot that searches, and takes the centre of mass with it.
double lowering_within(const SupportEdges& polygon, double margin) {
  constexpr double kMargins = 2.0;
  if (!polygon.has_inside() || !(margin > 0.0)) return 1.0;
  const double distance = std::ranges::min(polygon.edges, {}, &Edge::distance).distance;
  return std::clamp(distance / (kMargins * margin), 0.0, 1.0);
}

// Displacement in the body frame that gives a centre of mass its margin back, where it has lost it:
// braking, or because the feet under it are others now [m].
Vector2 back_over_the_feet(const SupportEdges& polygon, const Matrix3& R_OB, double margin) {
  Vector2 back = Vector2::Zero();
  if (!polygon.has_inside()) return back;
  for (const Edge& edge : polygon.edges)
    if (edge.distance < margin) back += (margin - edge.distance) * edge.inwards;
  return R_OB.topLeftCorner<2, 2>().transpose() * back;
}

// The deceleration of a motion [m/s²] with which the zero-moment point, which is ahead of the centre of
// mass by its height × deceleration / g, comes as close as `margin` to an edge of the support polygon.
double braking_within(const SupportEdges& polygon, const Matrix3& R_OB, const Vector2& motion,
                      double margin, double gravity) {
  const double speed = motion.norm();
  if (!polygon.has_inside() || !(speed > 0.0) || !(polygon.height > 0.0)) return 0.0;
  const Vector2 ahead = R_OB.topLeftCorner<2, 2>() * motion / speed;
  return times_inside(polygon, ahead, margin) * gravity / polygon.height;
}

// A correction must not take a centre of mass that is at an edge farther out.
Vector2 kept_inside(const Vector2& correction, const SupportEdges& polygon, const Matrix3& R_OB,
                    double margin) {
  if (!polygon.has_inside()) return correction;
  Vector2 way = R_OB.topLeftCorner<2, 2>() * correction;
  for (const Edge& edge : polygon.edges) {
    const double out = -edge.inwards.dot(way), room = std::max(0.0, edge.distance - margin);
    if (out > room) way += (out - room) * edge.inwards;
  }
  return R_OB.topLeftCorner<2, 2>().transpose() * way;
}

// Is a place for the foot beyond the end of a first joint that ends near the workspace? Where it turns
// farther, footholds that are so far off are so for a moment only, while the body turns.
bool beyond_first_joint(const LegModel& leg, const Vector3& p_BC, double radius,
                        const Vector3& p_BF) {
  constexpr double kNear = 1.5;  // of the workspace radius, from its centre
  const LegSolution solution = inverse_kinematics(leg, p_BF);
  const JointLimits& limits = leg.limits[0];
  const bool at_end = solution.q[0] <= limits.lower || solution.q[0] >= limits.upper;
  if (solution.reachable || !at_end) return false;
  LegJoints q = inverse_kinematics(leg, p_BC).q;
  q[0] = solution.q[0];
  const Vector3 end_BF = foot_position(leg, leg_trig(leg, q));
  return (end_BF - p_BC).norm() < kNear * radius;
}

// The farthest point on the way from one to the other to which the leg's first joint turns from where
// the body is now. The body advances under a step, but it may have to wait for the foot.
Vector3 within_reach(const LegModel& leg, const Vector3& p_BC, double radius,
                     const Vector3& to_BF) {
  if (!beyond_first_joint(leg, p_BC, radius, to_BF)) return to_BF;
  constexpr int kHalvings = 6;
  double reached = 0.0, step = 0.5;
  for (int k = 0; k < kHalvings; ++k, step *= 0.5)
    if (!beyond_first_joint(leg, p_BC, radius, p_BC + (reached + step) * (to_BF - p_BC)))
      reached += step;
  return p_BC + reached * (to_BF - p_BC);
}

// [m of path]
double half_step_of(const Stance& stance, LegId leg, double half_step) {
  return std::min(half_step, 0.5 * stance.radius[leg]);
}

}  // namespace

double nominal_step_time(const SwingParams& swing, const StepParams& step) noexcept {
  const double lift = std::max(swing.lift_time, kMinimumJerkPeak * step.height / swing.max_rise);
  const double rise = 0.43 * lift;
  const double sideways = swing.transfer_time - swing.overlap_time;
  const double down =
      step.height / swing.descent_speed + swing.touchdown_margin / swing.touchdown_speed;
  return swing.unload_time + rise + sideways + down + swing.confirm_time;
}

gait_state::GaitInput gait_input(const PathArc& arc, const Executor& executor,
                                 const StepParams& params, const Pose* X_BG) noexcept {
  const Stance& stance = executor.stance();
  const int n = stance.p_BC.size();
  const FromBody from_body(X_BG);
  gait_state::GaitInput input{LegArray<double>(n, 0.0), LegSet(), LegSet(), executor.lost()};
  const LegSet support = executor.support();
  for (LegId i = 0; i < n; ++i) {
    if (input.lost.contains(i)) continue;
    const Vector3 p_GF = from_body(executor.legs()[i].p_BF);
    input.lag[i] = lag(arc, i, p_GF);
    input.airborne.set(i, !support.contains(i));
    const double behind = arc.direction[i].dot((stance.p_BC[i] - p_GF).head<2>());
    input.urgent.set(i, behind > params.urgent_share * stance.radius[i]);
  }
  if (!X_BG) leave_bad_footholds(input, executor);
  return input;
}

double path_to_come(const PathArc& arc, const Executor& executor, double half_step,
                    const Pose* X_BG) noexcept {
  const LegSet support = executor.support();
  const FromBody from_body(X_BG);
  LegArray<Vector3> p_GF = arc.p_BC;  // of lost legs: no lag
  for (LegId i = 0; i < p_GF.size(); ++i) {
    if (executor.lost().contains(i)) continue;
    p_GF[i] = support.contains(i) ? from_body(executor.legs()[i].p_BF) : aep(arc, i, half_step);
  }
  return std::max(0.0, posture::arc_optimum(p_GF, arc.p_BC, support, arc.per_metre).advance);
}

FootstepCommand footstep(const RobotModel& model, const Stance& stance, const PathArc& arc,
                         const RobotState& state, LegId leg, double half_step, double to_come,
                         const StepParams& params, const Pose* X_BG) noexcept {
  const Vector3 aep_GF = aep(arc, leg, half_step_of(stance, leg, half_step) + to_come);
  const Vector3 aep_BF = X_BG ? *X_BG * aep_GF : aep_GF;
  const double start_z = state.print_O[leg].z();
  double highest_z = start_z;
  for (const Vector3& print : state.print_O) highest_z = std::max(highest_z, print.z());

  const Vector3 p_BF = within_reach(model.legs[leg], stance.p_BC[leg], stance.radius[leg], aep_BF);
  FootstepCommand step{leg, state.X_OB * p_BF, 0.0};
  step.p_OT.z() = start_z;
  step.profile_height =
      std::min(params.max_height, params.height + params.roughness_gain * (highest_z - start_z));
  step.haste = params.haste;
  step.descent = params.descent;
  step.touchdown = params.touchdown;
  step.slow_way = params.slow_way;
  return step;
}

double to_come_coming_down(const Stance& stance, LegId leg, double half_step, double to_come,
                           const StepParams& params) noexcept {
  const double inside = stance.radius[leg] - half_step_of(stance, leg, half_step);
  return to_come - (1.0 - params.overreach) * std::max(0.0, to_come - inside);
}

BaseAutoCommand base_auto(const RobotModel& model, const PathArc& arc, const Executor& executor,
                          const Pose& X_OB, const PlanarTwist& deviation, const StepParams& params,
                          double margin) noexcept {
  const LegSet support = executor.support();
  const SupportEdges polygon = support_edges(arc, executor, support, X_OB.R);
  const Stance& stance = executor.stance();
  BaseAutoCommand base;
  base.adaptation = pose_adaptation;
  base.path = arc.per_metre;
  // On two feet there is no inside.
  const double inside =
      polygon.has_inside() ? std::max(margin, params.stability_margin) : -params.stability_margin;
  const Vector2 back_in = back_over_the_feet(polygon, X_OB.R, params.stability_margin);
  const Vector2 farther_in = back_over_the_feet(polygon, X_OB.R, inside) - back_in;
  const PlanarTwist correction{kept_inside(deviation.v, polygon, X_OB.R, inside) + farther_in,
                               deviation.w};
  double share = 1.0;  // of the correction, until a standing foot leaves its workspace
  double ahead = stability_left(polygon, inside, 1.0);
  double back = stability_left(polygon, inside, -1.0);
  for (LegId i = 0; i < model.num_legs(); ++i) {
    if (!support.contains(i)) continue;
    const Vector3& p_BF = executor.legs()[i].p_BF;
    const Vector2 offset = (p_BF - stance.p_BC[i]).head<2>();
    const Vector2 corrected = correction.v + correction.w * perpendicular(p_BF.head<2>());
    const Vector2 direction = direction_at(arc, p_BF);
    const double radius = kUsableShare * stance.radius[i];
    const WorkspaceLeft left = workspace_left(offset, direction, radius);
    ahead = std::min(ahead, left.ahead);
    back = std::min(back, left.back);
    share = std::min(share, workspace_left(offset, corrected, radius).ahead);
  }
  // A base that goes on rolls a foot on an edge farther off it.
  if (!(executor.giving_way() & support).empty()) ahead = 0.0;
  const ExecutorParams& limits = executor.params();
  const PlanarTwist off = off_path(executor.base(), arc.per_metre, limits.base.outer_radius);
  base.max_braking = braking_within(polygon, X_OB.R, off.v,
                                    kBrakingMargin * params.stability_margin, limits.gravity);
  base.lowering = lowering_within(polygon, params.stability_margin);
  base.max_advance = ahead;
  base.min_advance = -back;
  base.correction = {share * correction.v + back_in, share * correction.w};
  return base;
}

}  // namespace hexagait::footstep_gen
