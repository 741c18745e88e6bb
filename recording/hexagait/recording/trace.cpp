// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/recording/trace.hpp>
#include <iterator>
#include <ostream>

namespace hexagait::recording {
namespace {

void append(std::string& row, const Pose& pose) {
  const Vector3 rpy = roll_pitch_yaw(pose.R);
  fmt::format_to(std::back_inserter(row), ",{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}", pose.p.x(),
                 pose.p.y(), pose.p.z(), rpy.x(), rpy.y(), rpy.z());
}

}  // namespace

void write_trace_header(std::ostream& out, const RobotModel& robot) {
  out << "time_s,x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad,"
         "odom_x_m,odom_y_m,odom_z_m,odom_roll_rad,odom_pitch_rad,odom_yaw_rad,"
         "ideal_x_m,ideal_y_m,ideal_yaw_rad,lateral_error_m,heading_error_rad,"
         "ccn_before_adjustment,gait_state,base_vx_m_s,base_vy_m_s,base_wz_rad_s,advance_goal_m,"
         "path_to_come_m";
  for (const LegModel& leg : robot.legs)
    out << fmt::format(",{0}_phase,{0}_contact,{0}_normal_force_n,{0}_lag_m", leg.name);
  out << '\n';
}

void write_trace_row(std::ostream& out, const footstep_gen::TickRecord& record,
                     const GroundTruth& truth, const walk::Referee& referee) {
  std::string row = fmt::format("{:.4f}", record.state.time);
  append(row, truth.X_WB);
  append(row, record.state.X_OB);
  const PlanarPose& ideal = referee.ideal();
  const auto to = std::back_inserter(row);
  fmt::format_to(to, ",{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}", ideal.shift.x(), ideal.shift.y(),
                 ideal.angle, referee.deviation().lateral, referee.deviation().heading);
  fmt::format_to(to, ",{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}", record.gait.ccn_before_adjustment,
                 gait_state::to_string(record.gait.state), record.base.planar.v.x(),
                 record.base.planar.v.y(), record.base.planar.w, record.base_goal.advance,
                 record.path_to_come);
  const int legs = std::min({record.legs.size(), truth.feet.size(), record.gait_input.lag.size(),
                             record.measurement.contact.size()});
  for (LegId i = 0; i < legs; ++i)
    fmt::format_to(to, ",{},{:d},{:.2f},{:.6f}", to_string(record.legs[i].phase),
                   record.measurement.contact[i], truth.feet[i].normal_force,
                   record.gait_input.lag[i]);
  out << row << '\n';
}

}  // namespace hexagait::recording
