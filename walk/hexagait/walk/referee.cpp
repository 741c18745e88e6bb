// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <hexagait/walk/detail/state_hash.hpp>
#include <hexagait/walk/referee.hpp>
#include <limits>

namespace hexagait::walk {
namespace {

using footstep_gen::TickRecord;

constexpr double kSettling = 0.02;  // a stance younger than this may still lose contact [s]
constexpr double kFallTilt = std::numbers::pi / 3.0;

PlanarPose in_plane(const Pose& X_WB) { return {roll_pitch_yaw(X_WB.R).z(), X_WB.p.head<2>()}; }

LegSet feet_in_contact(const GroundTruth& truth) {
  LegSet feet;
  for (LegId i = 0; i < truth.feet.size(); ++i) feet.set(i, truth.feet[i].in_contact);
  return feet;
}

}  // namespace

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = static_cast<std::size_t>(
      std::max(0.0, std::ceil(share * static_cast<double>(values.size())) - 1.0));
  std::nth_element(values.begin(), values.begin() + static_cast<long>(rank), values.end());
  return values[rank];
}

Referee::Referee(const RobotModel& model, const GroundTruth& truth, double control_dt,
                 const Patience& patience)
    : model_(&model),
      dt_(control_dt),
      patience_(patience),
      start_(in_plane(truth.X_WB)),
      path_(start_),
      stances_(model.num_legs()),
      lift_time_(model.num_legs(), 0.0),
      yaw_before_(start_.angle) {
  for (LegId i = 0; i < model.num_legs(); ++i)
    stances_[i] = {.counting = true, .slip_before = truth.feet[i].slip};
  summary_.height_min = summary_.height_max = truth.X_WB.p.z();
  summary_.state_hash = kFnv1aBasis;
}

void Referee::observe(const TickRecord& record, const GroundTruth& truth) {
  ++ticks_;
  follow_path(record, truth);
  watch_posture(truth);
  watch_stances(record, truth);
  watch_rule1(record, truth);
  watch_progress(record);
  summary_.state_hash = state_hash(*model_, truth, record.measurement, summary_.state_hash);
  odometry_ = record.state.X_OB;
  truth_ = truth.X_WB;
  summary_.fault = record.fault;
}

void Referee::follow_path(const TickRecord& record, const GroundTruth& truth) {
  if (!(record.heading == heading_)) {
    distance_before_ += deviation_.progress;
    heading_ = record.heading;
    path_.follow(heading_);
    progress_seen_ = 0.0;
    turned_before_ = turned_;
  }
  deviation_ = path_.deviation(in_plane(truth.X_WB));
  const double lateral = std::abs(deviation_.lateral);
  lateral_sum_ += lateral;
  summary_.lateral_max = std::max(summary_.lateral_max, lateral);
  summary_.lateral_end = lateral;
  summary_.heading_max = std::max(summary_.heading_max, std::abs(deviation_.heading));
  summary_.heading_end = std::abs(deviation_.heading);
}

void Referee::watch_posture(const GroundTruth& truth) {
  const Vector3 rpy = roll_pitch_yaw(truth.X_WB.R);
  turned_ += wrap_angle(rpy.z() - yaw_before_);
  yaw_before_ = rpy.z();
  summary_.roll_max = std::max(summary_.roll_max, std::abs(rpy.x()));
  summary_.pitch_max = std::max(summary_.pitch_max, std::abs(rpy.y()));
  summary_.height_min = std::min(summary_.height_min, truth.X_WB.p.z());
  summary_.height_max = std::max(summary_.height_max, truth.X_WB.p.z());
  summary_.fell = summary_.fell || !truth.finite || truth.base_touches_ground ||
                  std::abs(rpy.x()) > kFallTilt || std::abs(rpy.y()) > kFallTilt;

  LegArray<Vector3> p_WF(model_->num_legs());
  for (LegId i = 0; i < model_->num_legs(); ++i) p_WF[i] = truth.feet[i].p_WF;
  const Vector2 p_WM = (truth.X_WB * model_->p_BM).head<2>();
  const double margin = stability_margin(support_polygon(p_WF, feet_in_contact(truth)), p_WM);
  if (std::isfinite(margin)) margins_.push_back(margin);
}

void Referee::watch_stances(const TickRecord& record, const GroundTruth& truth) {
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    const LegLane& lane = record.legs[i];
    const FootTruth& foot = truth.feet[i];
    Stance& stance = stances_[i];
    if (lane.touched_down) {
      stance = {.counting = true, .slip_before = foot.slip};
      swing_times_.push_back(truth.time - lift_time_[i]);
    }
    if (record.lifts.contains(i)) lift_time_[i] = truth.time;
    stance.age += dt_;

    if (lane.phase == LegPhase::support && lane.confirmed) {
      const bool lost = !foot.in_contact && stance.age > kSettling;
      if (lost && !stance.lost) ++summary_.contact_losses;
      stance.lost = lost;
    } else if (stance.counting && lane.phase != LegPhase::unload && !foot.in_contact) {
      slips_.push_back((foot.slip - stance.slip_before).norm());
      stance.counting = false;
    }
  }
}

void Referee::watch_rule1(const TickRecord& record, const GroundTruth& truth) {
  for (LegId i = 0; i < model_->num_legs(); ++i)
    if (record.lifts.contains(i)) lifts_.push_back({i, truth.time});
  summary_.steps += record.lifts.size();
  summary_.rule1_violations += record.rule1_violations.size();
  const LegSet in_air = without(LegSet::all(model_->num_legs()), feet_in_contact(truth));
  if (gait_state::breaks_rule_1(in_air, model_->num_legs())) summary_.neighbour_flight += dt_;
}

void Referee::watch_progress(const TickRecord& record) {
  const bool spins = record.heading.rho() == 0.0;
  const double progress = spins ? std::abs(turned_ - turned_before_) : deviation_.progress;
  idle_ = record.heading.moving() ? idle_ + dt_ : 0.0;
  if (progress > progress_seen_ + patience_.progress) {
    progress_seen_ = progress;
    idle_ = 0.0;
  }
  summary_.stuck = summary_.stuck || idle_ > patience_.seconds;
}

Summary Referee::summary() const {
  Summary s = summary_;
  s.seconds = static_cast<double>(ticks_) * dt_;
  s.distance = distance();
  s.turned = turned_;
  s.speed = s.seconds > 0.0 ? s.distance / s.seconds : 0.0;
  s.lateral_mean = ticks_ > 0 ? lateral_sum_ / static_cast<double>(ticks_) : 0.0;

  // Odometry starts where the truth does.
  const PlanarPose odometry = start_ * in_plane(odometry_);
  s.odometry_position = (odometry.shift - truth_.p.head<2>()).norm();
  s.odometry_heading = wrap_angle(odometry.angle - in_plane(truth_).angle);

  s.stances = static_cast<int>(slips_.size());
  for (const double slip : slips_) s.slip_mean += slip / static_cast<double>(slips_.size());
  s.slip_p95 = percentile(slips_, 0.95);
  s.margin_min = percentile(margins_, 0.0);
  s.margin_p5 = percentile(margins_, 0.05);
  s.tripod_after_steps =
      gait_state::first_tripod_gait(lifts_, model_->num_legs(), percentile(swing_times_, 0.5));
  return s;
}

}  // namespace hexagait::walk
