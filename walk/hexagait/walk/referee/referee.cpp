// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/walk/referee/detail/state_hash.hpp>
#include <hexagait/walk/referee/referee.hpp>
#include <limits>

namespace hexagait::walk {
namespace {

using footstep_gen::TickRecord;

LegSet feet_in_contact(const GroundTruth& truth) {
  LegSet feet;
  for (LegId i = 0; i < truth.feet.size(); ++i) feet.set(i, truth.feet[i].in_contact);
  return feet;
}

// Angle between what two attitudes of the body take for up [rad].
double tilt_between(const Matrix3& R, const Matrix3& S) {
  const Vector3 a = R.row(2), b = S.row(2);
  return portable::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

RefereeParams completed(const RefereeParams& params, const RobotModel& model) {
  RobotParams all = none_derived();
  all.referee = params;
  return completed(all, model).referee;
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = static_cast<std::size_t>(
      std::max(0.0, std::ceil(share * static_cast<double>(values.size())) - 1.0));
  std::nth_element(values.begin(), values.begin() + static_cast<long>(rank), values.end());
  return values[rank];
}

Referee::Referee(const RobotModel& model, const GroundTruth& truth, double control_dt,
                 const RefereeParams& params)
    : model_(&model),
      dt_(control_dt),
      params_(completed(params, model)),
      start_(in_plane(truth.X_WB)),
      path_(start_),
      stances_(model.num_legs()),
      slip_before_touch_(model.num_legs(), Vector3::Zero()),
      supports_(model.num_legs()),
      lift_time_(model.num_legs(), 0.0),
      yaw_before_(start_.angle),
      not_standing_(model.num_legs(), 0.0),
      not_stepping_(model.num_legs(), 0.0),
      no_ground_(model.num_legs(), 0),
      work_before_(truth.work),
      work_(truth.work) {
  for (LegId i = 0; i < model.num_legs(); ++i) {
    outer_ = std::max(outer_, model.legs[i].p_BC.head<2>().norm());
    const FootTruth& foot = truth.feet[i];
    stances_[i] = {.stands = foot.in_contact, .slip_before = foot.slip, .z = foot.p_WF.z()};
    slip_before_touch_[i] = foot.slip;
  }
  summary_.height_min = summary_.height_max = truth.X_WB.p.z();
  summary_.state_hash = kFnv1aBasis;
}

void Referee::observe(const TickRecord& record, const GroundTruth& truth) {
  ++ticks_;
  follow_path(record, truth);
  watch_posture(truth);
  watch_stances(truth);
  watch_support(record, truth);
  watch_rule1(record, truth);
  watch_progress(record);
  summary_.state_hash = state_hash(*model_, truth, record.measurement, summary_.state_hash);
  work_ = truth.work;
  odometry_ = record.state.X_OB;
  truth_ = truth.X_WB;
  const double tilt = tilt_between(odometry_.R, truth_.R);
  if (!(tilt <= summary_.odometry_tilt))
    summary_.odometry_tilt = tilt;  // not a number: no odometry
  summary_.fault = record.fault;
}

void Referee::follow_curve(const TickRecord& record, const GroundTruth& truth) {
  const bool is_new = !(record.heading == heading_);
  if (is_new) {
    distance_before_ += deviation_.progress;
    heading_ = record.heading;
    path_.follow(heading_);
    turned_before_ = turned_;
  }
  deviation_ = path_.deviation(in_plane(truth.X_WB));
  // A base beside the last curve may be behind the beginning of the next one.
  if (is_new) progress_seen_ = deviation_.progress;
}

void Referee::follow_path(const TickRecord& record, const GroundTruth& truth) {
  if (path_judge_)
    deviation_ = path_judge_->observe(in_plane(truth.X_WB), in_plane(record.state.X_OB));
  else
    follow_curve(record, truth);
  if (path_judge_ && !path_judge_->on_path()) return;
  ++lateral_ticks_;
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
  const double tilt = truth.finite ? std::max(std::abs(rpy.x()), std::abs(rpy.y()))
                                   : std::numeric_limits<double>::quiet_NaN();
  const bool falls = !truth.finite || truth.base_touches_ground || tilt > kFallTilt;
  if (falls && !summary_.fell) summary_.fall_tilt = tilt;
  summary_.fell = summary_.fell || falls;

  LegArray<Vector3> p_WF(model_->num_legs());
  for (LegId i = 0; i < model_->num_legs(); ++i) p_WF[i] = truth.feet[i].p_WF;
  const Vector2 p_WM = (truth.X_WB * model_->p_BM).head<2>();
  const double margin = stability_margin(support_polygon(p_WF, feet_in_contact(truth)), p_WM);
  if (std::isfinite(margin)) margins_.push_back(margin);
}

// A stance is from the first touch to the last one before the foot is off the ground for `bounce`. In the tick of the
// first touch the ground has stopped the foot already.
void Referee::watch_stances(const GroundTruth& truth) {
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    const FootTruth& foot = truth.feet[i];
    Stance& stance = stances_[i];
    if (foot.in_contact) {
      if (!stance.stands) {
        if (stance.off > params_.bounce) touchdowns_.push_back(stance.descent);
        stance.stands = true;
        stance.slip_before = slip_before_touch_[i];
      }
      stance.off = 0.0;
    } else {
      stance.off += dt_;
    }
    if (stance.stands && stance.off > params_.bounce) {
      slips_.push_back((foot.slip - stance.slip_before).norm());
      stance.stands = false;
    }
    stance.descent = (stance.z - foot.p_WF.z()) / dt_;
    stance.z = foot.p_WF.z();
    slip_before_touch_[i] = foot.slip;
  }
  summary_.leg_touch_time += truth.leg_touches_ground ? dt_ : 0.0;
}

// What the controller takes for support, and is none.
void Referee::watch_support(const TickRecord& record, const GroundTruth& truth) {
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    const LegLane& lane = record.legs[i];
    Support& support = supports_[i];
    if (lane.touched_down) {
      support = {.p_W = truth.feet[i].p_WF};
      swing_times_.push_back(truth.time - lift_time_[i]);
    }
    if (record.lifts.contains(i)) lift_time_[i] = truth.time;
    support.age += dt_;
    const FootTruth& foot = truth.feet[i];
    if (foot.in_contact) support.p_W = foot.p_WF;
    if (lane.phase != LegPhase::support || !lane.confirmed) continue;
    const bool lost = !foot.in_contact && support.age > params_.settling;
    if (lost && !support.lost) {
      ++summary_.contact_losses;
      support.off = 0.0;
      support.is_real = false;
    }
    support.lost = lost;
    if (!lost || support.is_real) continue;
    support.off += dt_;
    support.is_real = support.off > params_.brief_loss + 1e-9 ||
                      (foot.p_WF - support.p_W).norm() > params_.near_loss;
    if (support.is_real) ++summary_.real_contact_losses;
  }
}

void Referee::watch_rule1(const TickRecord& record, const GroundTruth& truth) {
  const int n = model_->num_legs();
  for (LegId i = 0; i < n; ++i)
    if (record.lifts.contains(i)) lifts_.push_back({i, truth.time});
  summary_.steps += record.lifts.size();
  summary_.lost = record.lost;
  summary_.findings = record.findings;
  using footstep_gen::EscapePhase;
  const EscapePhase phase = record.escape.phase;
  summary_.escapes += phase == EscapePhase::moves && record.escape.tries > tries_ ? 1 : 0;
  tries_ = record.escape.tries;
  if (phase != EscapePhase::none) summary_.escape = record.escape;
  summary_.very_rough += record.very_rough ? dt_ : 0.0;
  summary_.refused = summary_.refused || record.refuses;
  const gait_state::Ring ring(n, record.lost);
  const LegSet in_air = without(ring.present(), feet_in_contact(truth));
  const LegSet beside = gait_state::neighbours_of(in_air | record.lifts, ring);
  summary_.rule1_violations += (record.lifts & beside).size();
  summary_.rule1_commanded += record.rule1_violations.size();
  if (gait_state::breaks_rule_1(in_air, ring)) summary_.neighbour_flight += dt_;
}

void Referee::watch_legs(const TickRecord& record) {
  for (LegId i = 0; i < model_->num_legs(); ++i) {
    const LegLane& lane = record.legs[i];
    const bool stands = lane.phase == LegPhase::support && lane.confirmed;
    const bool lost = record.lost.contains(i);
    not_standing_[i] = stands || lost ? 0.0 : not_standing_[i] + dt_;
    not_stepping_[i] = record.lifts.contains(i) || lost ? 0.0 : not_stepping_[i] + dt_;
    no_ground_[i] = idle_ > 0.0 ? no_ground_[i] + (lane.found_no_ground ? 1 : 0) : 0;
  }
}

// The leg that has been off the ground for longest, if that is longer than steps take; else the one that has found
// no ground most often; else the one that has not stepped for longest.
Hindrance Referee::hindrance(const TickRecord& record) const {
  const auto most = [](const auto& values) {
    return static_cast<LegId>(std::ranges::max_element(values) - values.begin());
  };
  constexpr double kLong = 0.25;  // of the patience
  const LegId off = most(not_standing_), searching = most(no_ground_);
  const bool is_off = not_standing_[off] > kLong * params_.patience;
  const int no_ground = is_off ? 0 : no_ground_[searching];
  const LegId leg = is_off ? off : no_ground > 0 ? searching : most(not_stepping_);
  const LegLane& lane = record.legs[leg];
  // Of a leg that touches for an instant and does not stand.
  const bool finds_none = no_ground > 0 || (is_off && lane.phase == LegPhase::support);
  return {leg, finds_none ? LegPhase::descend : lane.phase,
          is_off ? not_standing_[leg] : not_stepping_[leg], lane.retreats, no_ground};
}

void Referee::watch_progress(const TickRecord& record) {
  watch_legs(record);
  const bool spins = record.heading.rho() == 0.0;
  // A turn in place counts by the way of the feet.
  const double turned = outer_ * std::abs(turned_ - turned_before_);
  const double progress = spins ? turned : deviation_.progress;
  idle_ = record.heading.moving() ? idle_ + dt_ : 0.0;
  if (path_judge_) {
    // Where odometry drifts it gets on beside its path: what counts is that it goes, or turns.
    const double gone = (truth_.p.head<2>() - p_WB_seen_).norm();
    if (gone > params_.progress || turned > params_.progress) {
      p_WB_seen_ = truth_.p.head<2>();
      turned_before_ = turned_;
      idle_ = 0.0;
    }
  } else if (progress > progress_seen_ + params_.progress) {
    progress_seen_ = progress;
    idle_ = 0.0;
  }
  if (summary_.stuck || idle_ <= params_.patience) return;
  summary_.stuck = true;
  summary_.hindrance = hindrance(record);
}

Summary Referee::summary() const {
  Summary s = summary_;
  s.seconds = static_cast<double>(ticks_) * dt_;
  s.distance = distance();
  s.turned = turned_;
  s.speed = s.seconds > 0.0 ? s.distance / s.seconds : 0.0;
  if (s.distance > 0.0)
    s.cost_of_transport = (work_ - work_before_) / (model_->mass * kStandardGravity * s.distance);
  s.lateral_mean = lateral_ticks_ > 0 ? lateral_sum_ / static_cast<double>(lateral_ticks_) : 0.0;
  if (path_judge_) s.path = path_judge_->summary();

  // Odometry starts where the truth does.
  const PlanarPose odometry = start_ * in_plane(odometry_);
  s.odometry_position = (odometry.shift - truth_.p.head<2>()).norm();
  s.odometry_height = odometry_.p.z() - truth_.p.z();
  s.odometry_heading = wrap_angle(odometry.angle - in_plane(truth_).angle);

  // Stances that go on slide too.
  std::vector<double> slips = slips_;
  for (LegId i = 0; i < stances_.size(); ++i)
    if (stances_[i].stands)
      slips.push_back((slip_before_touch_[i] - stances_[i].slip_before).norm());
  s.stances = static_cast<int>(slips.size());
  s.slip_mean = slips.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  for (const double slip : slips) s.slip_mean += slip / static_cast<double>(slips.size());
  s.slip_p95 = percentile(slips, 0.95);
  s.touchdown_median = percentile(touchdowns_, 0.5);
  s.touchdown_p95 = percentile(touchdowns_, 0.95);
  s.margin_min = percentile(margins_, 0.0);
  s.margin_p5 = percentile(margins_, 0.05);
  s.tripod_after_steps =
      gait_state::first_tripod_gait(lifts_, model_->num_legs(), percentile(swing_times_, 0.5));
  return s;
}

}  // namespace hexagait::walk
