// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/executor/executor.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>

/// Legs that take no part any more.
namespace hexagait {
namespace {

// By how much the robot's centre of mass moves when the leg in its nominal stance is taken off.
Vector3 shift_without(const LegModel& leg, const RobotModel& model) {
  const LegJoints q = inverse_kinematics(leg, leg.p_BC).q;
  double mass = 0.0;
  for (int k = 0; k < leg.num_joints(); ++k) mass += leg.links[k].mass;
  const Vector3 moment_B = leg_weight(leg, q, Vector3::Zero()).moment_B - mass * model.p_BM;
  const double rest = model.mass - mass;
  return rest > 0.0 ? Vector3(-moment_B / rest) : Vector3(Vector3::Zero());
}

}  // namespace

void Executor::lose(LegId leg) noexcept {
  if (lost_.contains(leg)) return;
  lost_.insert(leg);
  const Vector3 p_BF = legs_[leg].p_BF;
  legs_[leg] = {};
  legs_[leg].phase = LegPhase::hold;
  legs_[leg].p_BF = p_BF;
  legs_[leg].load = 0.0;
  legs_[leg].touching = legs_[leg].believed = legs_[leg].confirmed = false;
  plans_[leg].kind = LegPlan::Kind::keep;
  displacement_.legs.erase(leg);
  lost_shift_ += 0.5 * shift_without(model_->legs[leg], *model_);
}

void Executor::put_down(LegSet legs) noexcept {
  for (LegId i = 0; i < legs_.size(); ++i) {
    LegLane& lane = legs_[i];
    if (!legs.contains(i) || !is_up(lane.phase)) continue;
    lane.phase = LegPhase::descend;
    lane.time = lane.reach_fraction = lane.beside = 0.0;
    lane.cleared = true;
  }
}

// Over where it would stand, as high as its workspace is wide, at the speed of a search.
void Executor::tuck(LegId leg, double dt) noexcept {
  const Vector3 up(0.0, 0.0, stance_.radius[leg]);
  const Vector3 way = stance_.p_BC[leg] + up - legs_[leg].p_BF;
  const double length = way.norm(), step = params_.swing.search_speed * dt;
  legs_[leg].p_BF += length > step ? Vector3(step / length * way) : way;
}

}  // namespace hexagait
