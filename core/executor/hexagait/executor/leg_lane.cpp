// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/executor/detail/foot_motion.hpp>
#include <hexagait/executor/detail/phase_change.hpp>
#include <hexagait/executor/detail/reflexes.hpp>
#include <hexagait/executor/leg_lane.hpp>
#include <hexagait/executor/tick_motion.hpp>

namespace hexagait {
namespace {

// Of the way by which a foot is off its set point when it is blocked: it carries load.
constexpr double kCarries = 0.1;
// Deceleration of a foot that coasts, of that of the descent: as hard as a swing brakes at the end of its
// way, so that it does not run into the end of a joint beyond.
constexpr double kCoasting = 2.0;

// The parameters of the present step.
SwingParams params_here(const LegLane& lane, const SwingParams& at_ease) {
  SwingParams params = hastened(at_ease, lane.haste);
  params.descent_speed = faster(params.descent_speed, lane.step.descent, at_ease.max_rise);
  return params;
}

// Does it carry load without contact? Its shin stands on something, or its sensor is wrong.
bool carries(const LegSensed& sensed, const Pose& X_OB, const SwingParams& params) {
  return sensed.off.dot(Vector3(X_OB.R.row(2))) > kCarries * params.blocked_error;
}

// (swing 6). Else a foot that has bounced hangs a fraction of a millimetre above its ground until it counts as lost.
void go_after_ground(LegLane& lane, const LegSensed& sensed, double dt, const Pose& X_OB,
                     const SwingParams& params) {
  if (sensed.contact || !sensed.reachable || carries(sensed, X_OB, params)) {
    lane.v_O.setZero();
    lane.a_O.setZero();
    return;
  }
  const AxisMotion down =
      slewing_tick(-lane.v_O.z(), sensed.pursuit, params.vertical_acceleration, dt);
  lane.v_O.z() = -down.v;
  lane.a_O.z() = -down.a;
  lane.p_BF -= down.way * Vector3(X_OB.R.row(2));
}

void support(LegLane& lane, const LegSensed& sensed, double dt, const Pose& X_OB,
             const SwingParams& params) {
  const bool lost = lane.without_contact > params.lost_time;
  // What touched for an instant only was not the ground: the step goes on.
  if (!lane.believed && lost) {
    if (!params.reflexes) return enter(lane, LegPhase::search);
    // A foot that touches again and again without finding hold has none there.
    if (++lane.bounces < params.max_bounces || gives_up(lane, params) ||
        (lane.regains && sensed.needed))
      return enter(lane, LegPhase::descend);
    return retreat_closer(lane, {}, X_OB, params);
  }

  ramp(lane.load, lost && !sensed.needed ? 0.0 : 1.0, dt, params.load_time);
  if (params.reflexes) go_after_ground(lane, sensed, dt, X_OB, params);
  if (lane.without_contact > (lane.confirmed ? params.regain_time : params.lost_time)) {
    begin_step(lane, params.reflexes ? LegPhase::descend : LegPhase::search, X_OB);
    lane.cleared = lane.lost = lane.regains = true;
    lane.step.p_OT = lane.p_OL;
    lane.apex_z = lane.p_OL.z() + lane.step.profile_height;
  }
}

// The set point goes to where the foot is, across gravity.
void stop_pushing(LegLane& lane, const LegSensed& sensed, const Pose& X_OB) {
  const Vector3 up_B = X_OB.R.row(2);
  lane.p_BF += sensed.off - up_B.dot(sensed.off) * up_B;
}

// A foot that still touches above where it stood rises along a wall: it stops pushing against it, or it would
// push the robot over.
void stop_leaning(LegLane& lane, const LegSensed& sensed, const Pose& X_OB,
                  const SwingParams& params) {
  const double risen = foot_height(lane, sensed, X_OB) - lane.stood_at;
  if (sensed.contact && risen >= params.touchdown_margin) stop_pushing(lane, sensed, X_OB);
}

void unload(LegLane& lane, const LegSensed& sensed, double dt, const Pose& X_OB,
            const SwingParams& params) {
  ramp(lane.load, 0.0, dt, params.unload_time);
  if (lane.load > 0.0) return;
  if (lane.after_unload != LegPhase::lift) return enter(lane, lane.after_unload);
  rise_from_here(lane, X_OB);
  lane.stood_at = foot_height(lane, sensed, X_OB);
  lane.apex_z = std::max(lane.p_OL.z(), lane.step.p_OT.z()) + lane.step.profile_height;
  enter(lane, LegPhase::lift);
}

Vector3 swing(LegLane& lane, const LegSensed& sensed, double dt, const Pose& X_OB,
              const SwingParams& params) {
  if (lane.phase == LegPhase::lift) stop_leaning(lane, sensed, X_OB, params);
  const double height = height_of(lane, X_OB);
  const Vector2 way = way_to_go(lane, X_OB);
  // What happens between two ticks counts in the tick that is nearer to it: half a tick ahead.
  const double risen = height + 0.5 * dt * lane.v_O.z() - lane.p_OL.z();
  const bool sideways = lane.transfer_clock > 0.0 ||
                        risen > params.clearance_share * lane.step.profile_height ||
                        elapsed(lane.time, rise_time(lane, params));
  const double up = rise_left(lane, sensed, height);
  lane.cleared = lane.cleared || !sensed.contact;

  Vector3 way_O = Vector3::Zero();
  if (sideways) move_sideways(lane, way, sensed.turn, dt, params, way_O);
  move_to(lane, 2, up, rise_time(lane, params) - (lane.time - dt), dt, way_O);

  const bool blocked = (sensed.contact && elapsed(lane.with_contact, params.touch_time)) ||
                       sensed.tracking_error > params.blocked_error;
  // Also a foot that has been touching something since it stood: what it has risen along is a wall.
  if (sideways && blocked && !gives_up(lane, params)) {
    retreat(lane, sensed, X_OB, params);
    return Vector3::Zero();
  }
  if (sideways && blocked && sensed.contact) {  // it is back where it stood: that is its ground
    land(lane, dt, params);
    return Vector3::Zero();
  }
  const Vector2 left = way - way_O.head<2>();  // when the next tick begins
  if (lane.phase == LegPhase::lift && sideways) {
    lane.phase = LegPhase::transfer;  // without enter(): lane.time still paces the rise
  } else if (lane.phase == LegPhase::transfer && !sensed.contact &&
             std::max(time_to_go(lane, left, params), sensed.turn) < params.overlap_time &&
             up < 0.3 * lane.step.profile_height) {
    enter(lane, LegPhase::descend);
  }
  return way_O;
}

// (step 12). The set point begins where the foot is.
void begin_probe(LegLane& lane, const LegSensed& sensed, const Pose& X_OB) {
  const Vector3 up_B = X_OB.R.row(2);
  lane.probes = true;
  lane.probed_at = foot_height(lane, sensed, X_OB);
  lane.p_BF += up_B.dot(sensed.off) * up_B;
}

// Slowly down, and in a long period no farther than until it carries load.
Vector3 press(LegLane& lane, double dt, const SwingParams& params) {
  const double most = kCarries * params.blocked_error / dt;
  lane.v_O = -std::min(params.touchdown_speed, most) * Vector3::UnitZ();
  lane.a_O.setZero();
  return dt * lane.v_O;
}

Vector3 descend(LegLane& lane, const LegSensed& sensed, double dt, const Pose& X_OB,
                const SwingParams& params) {
  const double height = height_of(lane, X_OB);
  Vector3 way_O = Vector3::Zero();
  lane.cleared = lane.cleared || !sensed.contact;
  const double below = lane.step.p_OT.z() - height;
  // Contact this far down is that with the wall of a hole.
  const SearchDepth& depth = lane.step.depth;
  const bool wall = depth.hole_known() && below > params.commit_height && !gives_up(lane, params);
  const bool found = sensed.contact && lane.cleared;
  if (found && wall) return climb_out(lane, sensed, X_OB), way_O;
  if (found && is_edge(lane, sensed, X_OB)) return leave_edge(lane, sensed, X_OB, params), way_O;
  if (found && may_be_wall(lane, sensed, X_OB, params)) {
    if (!lane.probes) return begin_probe(lane, sensed, X_OB), press(lane, dt, params);
    const double sunk = lane.probed_at - foot_height(lane, sensed, X_OB);
    if (sunk > depth.edge) return climb_out(lane, sensed, X_OB), way_O;
    if (!carries(sensed, X_OB, params)) return press(lane, dt, params);
  }
  if (found) return land(lane, dt, params), way_O;
  const bool blocked = sensed.tracking_error > params.blocked_error;
  // It lost contact but not its load: it stays as it is while the robot needs it.
  const bool bears = blocked || carries(sensed, X_OB, params);
  if (lane.regains && sensed.needed && sensed.reachable && bears) {
    stop(lane, dt, way_O);
    return way_O;
  }
  const bool deep = below > depth.beside_hole || (!sensed.reachable && below > depth.at_end);
  if (deep && !blocked) return climb_out(lane, sensed, X_OB), way_O;
  // What is in the way is not pushed: the robot would stand on its shin.
  if (blocked || !sensed.reachable) return retreat_closer(lane, sensed, X_OB, params), way_O;

  // Straight down over the last centimetres, so that the foot does not slide.
  const bool committed = height < lane.step.p_OT.z() + params.commit_height;
  if (committed) {
    stop_sideways(lane, dt, way_O);
  } else {
    const Vector2 way = way_to_go(lane, X_OB);
    move_sideways(lane, way, time_to_turn(lane, way, params), dt, params, way_O);
  }
  move_down(lane, height, dt, params, way_O);
  return way_O;
}

// Moves against the surface normal until there is contact. Contact is known up to two periods late,
// and a foot that presses until then lifts others, which search in their turn: where the ground is
// expected, just below where the search begins, it takes at least six periods.
Vector3 search(LegLane& lane, const LegSensed& sensed, double dt, const SwingParams& params) {
  lane.cleared = lane.cleared || !sensed.contact;
  const bool found = lane.cleared || elapsed(lane.with_contact, params.touch_time);
  if (sensed.contact && found) return land(lane, dt, params), Vector3::Zero();
  if (!sensed.reachable || lane.time > params.search_time) {
    lane.exhausted = true;
    return enter(lane, LegPhase::hold), Vector3::Zero();
  }
  constexpr double kPeriodsAtTheGround = 6.0;
  const double time_there = kPeriodsAtTheGround * dt;
  const bool there = lane.time < time_there;
  const double speed = there ? std::min(params.search_speed, params.touchdown_margin / time_there)
                             : params.search_speed;
  // The velocity changes along a straight line.
  const Vector3 before = lane.v_O, change = -speed * lane.normal_O - before;
  const double size = change.norm();
  if (size <= 0.0) return dt * before;
  const AxisMotion along = slewing_tick(0.0, size, params.vertical_acceleration, dt);
  lane.v_O = before + change * (along.v / size);
  lane.a_O = change * (along.a / size);
  return dt * before + change * (along.way / size);
}

// A wall behind it, or a shin that is caught: it only goes up, and pulls no harder than what counts as blocked, or
// the robot would be thrown over.
void give_way(LegLane& lane, const LegSensed& sensed, const Pose& X_OB, const SwingParams& params) {
  stop_pushing(lane, sensed, X_OB);
  lane.back_O = (X_OB * lane.p_BF).head<2>();
  lane.v_O.head<2>().setZero();
  lane.a_O.head<2>().setZero();
  const Vector3 up_B = X_OB.R.row(2);
  const double too_high = -up_B.dot(sensed.off) - params.blocked_error;
  if (too_high <= 0.0) return;
  lane.p_BF -= too_high * up_B;
  lane.v_O.z() = lane.a_O.z() = 0.0;
}

Vector3 step_back(LegLane& lane, const LegSensed& sensed, double dt, const Pose& X_OB,
                  const SwingParams& params) {
  if (sensed.tracking_error > params.blocked_error) give_way(lane, sensed, X_OB, params);
  const Vector2 way = lane.back_O - (X_OB * lane.p_BF).head<2>();
  const double T = params.retreat_time - (lane.time - dt);
  Vector3 way_O = Vector3::Zero();
  for (int k = 0; k < 2; ++k) move_to(lane, k, way[k], T, dt, way_O);
  move_to(lane, 2, rise_left(lane, sensed, height_of(lane, X_OB)), T, dt, way_O);
  if (elapsed(lane.time, params.retreat_time)) {
    enter(lane, LegPhase::transfer);
    lane.cleared = false;
  }
  return way_O;
}

}  // namespace

double turning_time(const LegLane& lane, const Pose& X_OB, const SwingParams& at_ease) noexcept {
  if (lane.phase != LegPhase::transfer) return 0.0;
  return time_to_turn(lane, way_to_go(lane, X_OB), params_here(lane, at_ease));
}

double hastened_max_speed(const SwingParams& params, double haste) noexcept {
  return faster(params.max_speed, haste, params.hasty_speed);
}

SwingParams hastened(SwingParams params, double haste) noexcept {
  params.lift_time /= haste;
  params.transfer_time /= haste;
  params.overlap_time /= haste;
  params.max_speed = hastened_max_speed(params, haste);
  params.descent_speed = faster(params.descent_speed, haste, params.max_rise);
  params.touchdown_speed *= haste;
  params.vertical_acceleration *= haste * haste;
  return params;
}

void sense(LegLane& lane, bool contact, double dt, const SwingParams& params) noexcept {
  lane.touched_down = false;
  lane.with_contact = contact && lane.touching ? lane.with_contact + dt : 0.0;
  lane.touching = contact;
  if (lane.phase != LegPhase::support) return;
  lane.without_contact = contact ? 0.0 : lane.without_contact + dt;
  lane.believed = lane.believed || elapsed(lane.with_contact, params.touch_time);
  if (lane.confirmed) return;
  const bool loaded = lane.fully_loaded();
  lane.confirmed = lane.touched_down = loaded && elapsed(lane.with_contact, params.confirm_time);
}

void command(LegLane& lane, const FootstepCommand& step, const Pose& X_OB) noexcept {
  const bool starts = lane.phase == LegPhase::support;
  lane.step = step;
  if (!starts) return;
  lane.after_unload = LegPhase::lift;
  lane.v_O.setZero();
  lane.a_O.setZero();
  begin_step(lane, LegPhase::unload, X_OB);
  lane.haste = step.haste;
}

void advance(LegLane& lane, const LegSensed& sensed, const Pose& X_OB, double dt,
             const SwingParams& at_ease) noexcept {
  const SwingParams params = params_here(lane, at_ease);
  lane.lifted = lane.phase == LegPhase::unload && lane.time == 0.0;
  lane.found_no_ground = false;
  lane.time += dt;
  Vector3 way_O = Vector3::Zero();  // displacement over the ground in this tick
  switch (lane.phase) {
    case LegPhase::support:
      return support(lane, sensed, dt, X_OB, params);
    case LegPhase::unload:
      return unload(lane, sensed, dt, X_OB, params);
    case LegPhase::lift:
    case LegPhase::transfer:
      way_O = swing(lane, sensed, dt, X_OB, params);
      break;
    case LegPhase::descend:
      way_O = descend(lane, sensed, dt, X_OB, params);
      break;
    case LegPhase::retreat:
      way_O = step_back(lane, sensed, dt, X_OB, params);
      break;
    case LegPhase::search:
      way_O = search(lane, sensed, dt, params);
      break;
    case LegPhase::follow:  // see follow()
    case LegPhase::hold:
      lane.v_O.setZero();
      lane.a_O.setZero();
      break;
  }
  const bool bears = lane.phase == LegPhase::support || (lane.regains && sensed.needed);
  if (!bears) ramp(lane.load, 0.0, dt, params.unload_time);
  lane.p_BF += X_OB.R.transpose() * way_O;
}

void coast(LegLane& lane, const Pose& X_OB, double dt, const SwingParams& at_ease) noexcept {
  const SwingParams params = hastened(at_ease, lane.haste);
  lane.lifted = lane.touched_down = lane.found_no_ground = false;
  lane.a_O *= 1.0 - decay_share(dt / kMinTimeToGo);
  const double speed = lane.v_O.norm();
  if (lane.on_ground() || speed <= 0.0) return;
  const AxisMotion motion = slewing_tick(speed, 0.0, kCoasting * params.vertical_acceleration, dt);
  lane.p_BF += X_OB.R.transpose() * (lane.v_O * (motion.way / speed));
  lane.v_O *= motion.v / speed;
}

}  // namespace hexagait
