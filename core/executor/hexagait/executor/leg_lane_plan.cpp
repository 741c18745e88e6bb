// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/executor/detail/phase_change.hpp>
#include <hexagait/executor/leg_lane.hpp>
#include <hexagait/executor/tick_motion.hpp>

// A leg that follows a plan.
namespace hexagait {
namespace {

// (plan 1)
void follow_curve(LegLane& lane, LegPlan& plan, const Pose& X_OB, double dt, double rate,
                  const SwingParams& params) {
  const PointState to = plan.foot.along(lane.time);
  const double back = decay_share(params.follow_rate * dt);
  if (plan.in_body) {
    lane.p_BF += to.p - lane.p_plan + back * (lane.p_plan - lane.p_BF);
    lane.v_O = X_OB.R * (rate * to.v);
    lane.a_O = X_OB.R * (rate * to.a);
  } else {
    const Vector3 way_O = to.p - lane.p_plan + back * (lane.p_plan - X_OB * lane.p_BF);
    lane.p_BF += X_OB.R.transpose() * way_O;
    lane.v_O = rate * to.v;
    lane.a_O = rate * to.a;
  }
  lane.p_plan = to.p;
}

}  // namespace

void command(LegLane& lane, const LegPlan& plan, const Pose& X_OB) noexcept {
  const bool stood = lane.on_ground();
  lane.normal_O = plan.normal_O;
  lane.with_body = plan.with_body();
  lane.lost = lane.exhausted = false;
  lane.after_unload = LegPhase::follow;
  lane.p_plan = plan.foot.at(0.0).p;
  begin_step(lane, stood ? LegPhase::unload : LegPhase::follow, X_OB);
  lane.cleared = !stood;
}

void follow(LegLane& lane, LegPlan& plan, const LegSensed& sensed, const Pose& X_OB, double dt,
            double rate, const SwingParams& params) noexcept {
  lane.lifted = false;
  ramp(lane.load, 0.0, dt, params.unload_time);
  lane.cleared = lane.cleared || !sensed.contact;
  lane.time = std::min(lane.time + rate * dt, plan.duration);
  if (plan.kind == LegPlan::Kind::foot) follow_curve(lane, plan, X_OB, dt, rate, params);
  if (plan.kind == LegPlan::Kind::keep) lane.v_O.setZero();
  if (plan.kind != LegPlan::Kind::foot) lane.a_O.setZero();

  const bool ended = lane.time >= plan.duration;
  const bool coming_down = lane.v_O.dot(lane.normal_O) < 0.0 || lane.time > 0.5 * plan.duration;
  if (plan.lands && sensed.contact && (ended || (lane.cleared && coming_down)))
    return land(lane, dt, params);
  if (!ended) return;
  enter(lane, plan.lands ? LegPhase::search : LegPhase::hold);
}

// A leg that was unloading goes back to support, which contact must confirm anew. A leg that has
// not left the ground yet lands at the first contact.
void interrupt(LegLane& lane, bool to_stand) noexcept {
  if (lane.phase == LegPhase::unload) {
    enter(lane, LegPhase::support);
    lane.with_contact = lane.without_contact = 0.0;
    lane.touching = true;
    lane.confirmed = false;
  }
  if (lane.phase != LegPhase::follow) return;
  lane.cleared = true;
  enter(lane, to_stand ? LegPhase::search : LegPhase::hold);
}

}  // namespace hexagait
