// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <hexagait/recording/genghis_recording.hpp>
#include <ostream>

namespace hexagait::recording {
namespace {

using sim2d::GenghisRecord;
using sim2d::GenghisTruth;
using sim2d::kGenghisLegs;

constexpr double kSampling = 0.02;  // [s]

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

const char* to_string(sim2d::LegPhase phase) {
  constexpr std::array<const char*, 5> kNames = {"support", "raise", "advance", "retreat",
                                                 "descend"};
  return kNames[static_cast<std::size_t>(phase)];
}

}  // namespace

const char* genghis_leg_name(LegId leg) {
  constexpr std::array<const char*, kGenghisLegs> kNames = {"LF", "RF", "LM", "RM", "LR", "RR"};
  return kNames[static_cast<std::size_t>(leg)];
}

void GenghisRecording::observe(const GenghisRecord& record, const GenghisTruth& truth) {
  if (std::isnan(start_)) start_ = truth.time;
  const double time = truth.time - start_;
  if (samples_.empty() || time >= samples_.back().time + kSampling - 1e-9) {
    samples_.push_back({time, truth.p_WB, truth.pitch, LegArray<Vector2>(kGenghisLegs)});
    for (LegId i = 0; i < kGenghisLegs; ++i) samples_.back().p_WF[i] = truth.feet[i].p_WF;
  }
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    if (record.legs[i].touched_down) {
      const auto step =
          std::find_if(steps_.rbegin(), steps_.rend(), [i](const Step& s) { return s.leg == i; });
      if (step != steps_.rend() && std::isnan(step->land)) {
        step->land = time;
        step->p_WF = truth.feet[i].p_WF;
      }
    }
    if (record.decision.lifts.contains(i)) steps_.push_back({.leg = i, .lift = time});
  }
  const int ccn = record.decision.gait.ccn_before_adjustment;
  const gait_state::GaitType type = gait_state::type_of(record.decision.gait.state);
  if (gait_.empty() || gait_.back().ccn != ccn || gait_.back().type != type)
    gait_.push_back({time, time, ccn, type});
  else
    gait_.back().to = time;
}

void GenghisRecording::write_body(std::ostream& out) const {
  out << "time_s,x_m,z_m,pitch_deg\n";
  for (const Sample& s : samples_)
    out << fmt::format("{:.4f},{:.5f},{:.5f},{:.4f}\n", s.time, s.p_WB.x(), s.p_WB.y(),
                       degrees(s.pitch));
}

void GenghisRecording::write_steps(std::ostream& out) const {
  out << "leg,name,row,lift_s,land_s,x_m,z_m\n";
  for (const Step& s : steps_) {
    // Left legs above right ones, the front ones first.
    const int row = s.leg % 2 == 0 ? s.leg / 2 : kGenghisLegs / 2 + s.leg / 2;
    const bool landed = !std::isnan(s.land);
    out << fmt::format("{},{},{},{:.4f},{:.4f},", s.leg, genghis_leg_name(s.leg), row, s.lift,
                       landed ? s.land : samples_.back().time);
    out << (landed ? fmt::format("{:.5f},{:.5f}\n", s.p_WF.x(), s.p_WF.y()) : ",\n");
  }
}

void GenghisRecording::write_gait(std::ostream& out) const {
  out << "from_s,to_s,ccn_before_adjustment,type,type_index\n";
  constexpr std::string_view kTypes = "-ABCD";
  for (const GaitSpan& s : gait_) {
    const auto index = static_cast<std::size_t>(s.type);
    out << fmt::format("{:.4f},{:.4f},{},{},{}\n", s.from, s.to, s.ccn, kTypes[index], index);
  }
}

void write_genghis_trace_header(std::ostream& out) {
  out << "time_s,x_m,z_m,pitch_rad,body_touches_ground,ccn_before_adjustment,gait_state,"
         "advance_goal_m,to_come_m,body_vx_m_s,body_vz_m_s,pitch_rate_rad_s";
  for (LegId i = 0; i < kGenghisLegs; ++i)
    out << fmt::format(
        ",{0}_phase,{0}_lag_m,{0}_load_n,{0}_swing_rad,{0}_lift_m,{0}_x_m,{0}_z_m,"
        "{0}_normal_force_n",
        genghis_leg_name(i));
  out << '\n';
}

void write_genghis_trace_row(std::ostream& out, const GenghisRecord& record,
                             const GenghisTruth& truth) {
  std::string row =
      fmt::format("{:.4f},{:.6f},{:.6f},{:.6f},{:d},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}",
                  record.measurement.time, truth.p_WB.x(), truth.p_WB.y(), truth.pitch,
                  truth.body_touches_ground, record.decision.gait.ccn_before_adjustment,
                  gait_state::to_string(record.decision.gait.state), record.advance_goal,
                  record.to_come, record.v_body.x(), record.v_body.y(), record.pitch_rate);
  for (LegId i = 0; i < kGenghisLegs; ++i) {
    const sim2d::GenghisJoints& q = record.measurement.q[i];
    const sim2d::GenghisFoot& foot = truth.feet[i];
    fmt::format_to(std::back_inserter(row), ",{},{:.6f},{:.3f},{:.6f},{:.6f},{:.6f},{:.6f},{:.3f}",
                   to_string(record.legs[i].phase), record.gait_input.lag[i],
                   record.measurement.load[i], q.swing, q.lift, foot.p_WF.x(), foot.p_WF.y(),
                   foot.normal_force);
  }
  out << row << '\n';
}

}  // namespace hexagait::recording
