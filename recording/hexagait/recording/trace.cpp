// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/recording/trace.hpp>
#include <iterator>
#include <ostream>

namespace hexagait::recording {
namespace {

/// A row of cells; what is not known is an empty one.
class Row {
 public:
  explicit Row(double time) : text_(fmt::format("{:.4f}", time)) {}

  template <class... Values>
  void add(const Values&... values) {
    (cell(values), ...);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void cell(double value) {
    text_ += ',';
    if (!std::isnan(value)) fmt::format_to(std::back_inserter(text_), "{:.6f}", value);
  }
  void cell(const Vector2& p) { add(p.x(), p.y()); }
  void cell(const Vector3& p) { add(p.x(), p.y(), p.z()); }
  void cell(const Pose& pose) {
    add(pose.p, Vector3(pose.p.allFinite() ? roll_pitch_yaw(pose.R) : pose.p));
  }
  void cell(int value) { text_ += ',' + std::to_string(value); }
  void cell(const std::string& value) { text_ += ',' + value; }

  std::string text_;
};

}  // namespace

void write_trace_header(std::ostream& out, const RobotModel& robot) {
  out << "time_s,x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad,"
         "odom_x_m,odom_y_m,odom_z_m,odom_roll_rad,odom_pitch_rad,odom_yaw_rad,"
         "ideal_x_m,ideal_y_m,ideal_yaw_rad,lateral_error_m,heading_error_rad,"
         "ccn_before_adjustment,gait_state,base_vx_m_s,base_vy_m_s,base_wz_rad_s,advance_goal_m,"
         "path_to_come_m";
  for (const LegModel& leg : robot.legs) {
    out << fmt::format(
        ",{0}_phase,{0}_contact,{0}_normal_force_n,{0}_lag_m,{0}_x_m,{0}_y_m,{0}_z_m", leg.name);
    for (const char* quantity : {"", "_target", "_effort"})
      for (int k = 0; k < leg.num_joints(); ++k) out << ',' << leg.joint_names[k] << quantity;
  }
  out << '\n';
}

void write_trace_row(std::ostream& out, const footstep_gen::TickRecord& record,
                     const GroundTruth& truth, const walk::Referee& referee) {
  const PlanarPose& ideal = referee.ideal();
  const PlanarTwist& base = record.base.planar;
  Row row(record.state.time);
  row.add(truth.X_WB, record.state.X_OB, ideal.shift, ideal.angle, referee.deviation().lateral,
          referee.deviation().heading, record.gait.ccn_before_adjustment,
          gait_state::to_string(record.gait.state), base.v, base.w, record.base_goal.advance,
          record.path_to_come);
  const RobotModel& robot = referee.robot();
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const FootTruth& foot = truth.feet[i];
    const double lag = i < record.gait_input.lag.size() ? record.gait_input.lag[i] : std::nan("");
    row.add(std::string(to_string(record.legs[i].phase)), record.measurement.contact[i] ? 1 : 0,
            foot.normal_force, lag, foot.p_WF);
    for (const auto& joints : {record.measurement.q, record.targets.q, record.targets.effort})
      for (int k = 0; k < robot.legs[i].num_joints(); ++k)
        row.add(i < joints.size() ? joints[i][k] : std::nan(""));
  }
  out << row.text() << '\n';
}

}  // namespace hexagait::recording
