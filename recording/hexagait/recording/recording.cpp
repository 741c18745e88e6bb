// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/recording/recording.hpp>

namespace hexagait::recording {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

}  // namespace

void Recording::observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
                        const walk::Referee& referee) {
  if (std::isnan(start_)) start_ = truth.time;
  const double time = truth.time - start_;
  if (samples_.empty() || time >= samples_.back().time + kSampling - 1e-9) {
    const Vector3& p = truth.X_WB.p;
    const PlanarPose& ideal = referee.ideal();
    samples_.push_back({.time = time,
                        .X_WB = truth.X_WB,
                        .ideal = ideal,
                        .direction = ideal.angle + record.heading.crab_angle(),
                        .along = referee.distance(),
                        .lateral = referee.deviation().lateral,
                        .ground = height_(p.x(), p.y()),
                        .p_WF = LegArray<Vector3>(truth.feet.size(), Vector3::Zero()),
                        .in_contact = {},
                        .q = record.measurement.q});
    for (LegId i = 0; i < truth.feet.size(); ++i) {
      samples_.back().p_WF[i] = truth.feet[i].p_WF;
      samples_.back().in_contact.set(i, truth.feet[i].in_contact);
    }
  }
  watch_steps(time, record, truth);
  if (record.fault == footstep_gen::Fault::none) watch_gait(time, record.gait);
}

void Recording::watch_steps(double time, const footstep_gen::TickRecord& record,
                            const GroundTruth& truth) {
  for (LegId i = 0; i < record.legs.size(); ++i) {
    if (record.legs[i].touched_down) {
      const auto step =
          std::find_if(steps_.rbegin(), steps_.rend(), [i](const Step& s) { return s.leg == i; });
      if (step == steps_.rend()) continue;
      step->land = time;
      step->p_WF = truth.feet[i].p_WF;
      step->along = samples_.back().along + ahead(samples_.back(), step->p_WF);
    }
    if (record.legs[i].lifted) steps_.push_back({.leg = i, .lift = time});
  }
}

void Recording::watch_gait(double time, const gait_state::GaitDecision& gait) {
  const int ccn = gait.ccn_before_adjustment;
  const gait_state::GaitType type = gait_state::type_of(gait.state);
  if (gait_.empty() || gait_.back().ccn != ccn || gait_.back().type != type)
    gait_.push_back({time, time, ccn, type});
  else
    gait_.back().to = time;
}

figures::Csv Recording::body_table() const {
  figures::Csv csv(
      "time_s,x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg,ideal_x_m,ideal_y_m,ideal_yaw_deg,along_m,"
      "lateral_error_m,ground_m");
  for (const Sample& s : samples_)
    csv.row(s.time, s.X_WB.p, Vector3(kDegrees * roll_pitch_yaw(s.X_WB.R)), s.ideal.shift,
            kDegrees * s.ideal.angle, s.along, s.lateral, s.ground);
  return csv;
}

figures::Csv Recording::steps_table(const RobotModel& robot) const {
  figures::Csv csv("leg,name,row,lift_s,land_s,x_m,y_m,z_m,along_m");
  const double end = samples_.empty() ? 0.0 : samples_.back().time;
  for (const Step& s : steps_) {
    const bool landed = !std::isnan(s.land);
    const Vector3 none = Vector3::Constant(s.land);
    csv.row(s.leg, robot.legs[s.leg].name, gait_row(s.leg, robot.num_legs()), s.lift,
            landed ? s.land : end, landed ? s.p_WF : none, landed ? s.along : s.land);
  }
  return csv;
}

figures::Csv Recording::gait_table() const {
  figures::Csv csv("from_s,to_s,ccn_before_adjustment,type,type_index");
  for (const GaitSpan& s : gait_) {
    const auto index = static_cast<std::size_t>(s.type);
    csv.row(s.from, s.to, s.ccn, "-ABCD"[index], index);
  }
  return csv;
}

double ahead(const Recording::Sample& sample, const Vector3& p_W) {
  const Vector2 from_base = (p_W - sample.X_WB.p).head<2>();
  return from_base.dot(unit_vector(sample.direction));
}

int gait_row(LegId leg, int num_legs) { return leg % 2 == 0 ? leg / 2 : num_legs / 2 + leg / 2; }

std::string row_names(const RobotModel& robot) {
  const int n = robot.num_legs();
  std::string names;
  for (LegId i = 0; i < n; ++i)
    names += fmt::format("\"{}\" {}, ", robot.legs[i].name, gait_row(i, n));
  return names + fmt::format("\"state\" {}", n);
}

}  // namespace hexagait::recording
