// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/recording/recording.hpp>
#include <ostream>

namespace hexagait::recording {
namespace {

constexpr double kSampling = 0.02;  // [s]

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

// No value is an empty field.
std::string seconds(double time) { return std::isnan(time) ? "" : fmt::format("{:.4f}", time); }

}  // namespace

void Recording::observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
                        const walk::Referee& referee) {
  if (std::isnan(start_)) start_ = truth.time;
  const double time = truth.time - start_;
  watch_body(time, truth, referee);
  watch_steps(time, record, truth);
  if (record.fault == footstep_gen::Fault::none) watch_gait(time, record.gait);
}

void Recording::watch_body(double time, const GroundTruth& truth, const walk::Referee& referee) {
  if (!samples_.empty() && time < samples_.back().time + kSampling - 1e-9) return;
  const Vector3& p = truth.X_WB.p;
  samples_.push_back({time, truth.X_WB, referee.ideal(), referee.deviation().lateral,
                      terrain_.height_at(p.x(), p.y()), LegArray<Vector3>(truth.feet.size())});
  for (LegId i = 0; i < truth.feet.size(); ++i) samples_.back().p_WF[i] = truth.feet[i].p_WF;
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

void Recording::write_body(std::ostream& out) const {
  out << "time_s,x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg,ideal_x_m,ideal_y_m,ideal_yaw_deg,"
         "lateral_error_m,ground_m\n";
  for (const Sample& s : samples_) {
    const Vector3 rpy = roll_pitch_yaw(s.X_WB.R);
    out << fmt::format(
        "{:.4f},{:.5f},{:.5f},{:.5f},{:.4f},{:.4f},{:.4f},{:.5f},{:.5f},{:.4f},{:.5f},{:.4f}\n",
        s.time, s.X_WB.p.x(), s.X_WB.p.y(), s.X_WB.p.z(), degrees(rpy.x()), degrees(rpy.y()),
        degrees(rpy.z()), s.ideal.shift.x(), s.ideal.shift.y(), degrees(s.ideal.angle), s.lateral,
        s.ground);
  }
}

void Recording::write_steps(std::ostream& out, const RobotModel& robot) const {
  const int half = robot.num_legs() / 2;
  out << "leg,name,row,lift_s,land_s,x_m,y_m,z_m\n";
  for (const Step& s : steps_) {
    // Left legs above right ones, the front ones first; even indices are left legs.
    const int row = s.leg % 2 == 0 ? s.leg / 2 : half + s.leg / 2;
    const double end = std::isnan(s.land) && !samples_.empty() ? samples_.back().time : s.land;
    out << fmt::format("{},{},{},{},{}", s.leg, robot.legs[s.leg].name, row, seconds(s.lift),
                       seconds(end));
    out << (std::isnan(s.land)
                ? std::string(",,,\n")
                : fmt::format(",{:.5f},{:.5f},{:.5f}\n", s.p_WF.x(), s.p_WF.y(), s.p_WF.z()));
  }
}

void Recording::write_gait(std::ostream& out) const {
  out << "from_s,to_s,ccn_before_adjustment,type,type_index\n";
  constexpr std::string_view kTypes = "-ABCD";
  for (const GaitSpan& s : gait_) {
    const auto index = static_cast<std::size_t>(s.type);
    out << fmt::format("{:.4f},{:.4f},{},{},{}\n", s.from, s.to, s.ccn, kTypes[index], index);
  }
}

std::string row_names(const RobotModel& robot) {
  std::string names;
  for (int row = 0; row < robot.num_legs(); ++row) {
    const int half = robot.num_legs() / 2;
    const LegId leg = row < half ? 2 * row : 2 * (row - half) + 1;
    names += fmt::format("\"{}\" {}, ", robot.legs[leg].name, row);
  }
  return names + fmt::format("\"state\" {}", robot.num_legs());
}

}  // namespace hexagait::recording
