// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/recording/figures/detail/robot_tables.hpp>
#include <hexagait/recording/figures/detail/sheet.hpp>
#include <hexagait/recording/figures/robot.gp.hpp>
#include <hexagait/recording/figures/robot_figure.hpp>
#include <hexagait/recording/figures/robot_view.hpp>

namespace hexagait::recording {
namespace {

using detail::body_table;
using detail::bounds;
using detail::kHeight;
using detail::kWidth;
using detail::legs_table;
using detail::stance_of;
using figures::Box;
using figures::Csv;
using figures::Panel;

constexpr Panel kAbove = {0.05, 0.50, 0.07, 0.86}, kSide = {0.56, 0.985, 0.54, 0.86},
                kReach = {0.56, 0.985, 0.07, 0.42};

// A circle per leg.
Csv workspaces_table(const RobotModel& robot) {
  constexpr int kCorners = 72;
  Csv csv("leg,x_m,y_m,z_m");
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const LegModel& leg = robot.legs[i];
    for (int k = 0; k <= kCorners; ++k) {
      Vector3 p = leg.p_BC;
      p.head<2>() += leg.workspace_radius * unit_vector(2.0 * std::numbers::pi * k / kCorners);
      csv.row(i, p);
    }
    csv.gap();
  }
  return csv;
}

Csv support_table(const RobotModel& robot) {
  Csv csv("x_m,y_m");
  std::vector<Vector2> feet;
  for (const LegModel& leg : robot.legs) feet.emplace_back(leg.p_BC.head<2>());
  add_hull(csv, support_polygon(feet));
  return csv;
}

// In the vertical plane through a leg's hip and its foot: outwards from the hip, and up in the body.
Vector2 in_plane(const LegModel& leg, const Vector3& p_B) {
  const Vector2 out = (leg.p_BC - leg.X_BH.p).head<2>().normalized();
  return {out.dot((p_B - leg.X_BH.p).head<2>()), p_B.z()};
}

// The cells of that plane that a leg's foot reaches.
Csv reach_table(const LegModel& leg, double step) {
  Csv csv("out_m,z_m");
  const Vector2 out = (leg.p_BC - leg.X_BH.p).head<2>().normalized();
  const int cells = static_cast<int>(std::ceil(1.4 * leg.max_reach / step));
  for (int i = -cells / 3; i <= cells; ++i)
    for (int k = -cells; k <= cells; ++k) {
      Vector3 p = leg.X_BH.p;
      p.head<2>() += i * step * out;
      p.z() += k * step;
      if (inverse_kinematics(leg, p).reachable) csv.row(in_plane(leg, p));
    }
  return csv;
}

Csv leg_table(const LegModel& leg) {
  Csv csv("out_m,z_m");
  for (const Vector3& p : leg_line(leg, stance_of(leg), Pose{}, leg.p_BC))
    csv.row(in_plane(leg, p));
  return csv;
}

Box shown(const RobotModel& robot, int axis, const Panel& panel) {
  const Box box = bounds(robot, axis);
  return box.grown(0.06 * box.size().maxCoeff()).fitted(panel, kWidth, kHeight);
}

Box shown(const Csv& reach, const LegModel& leg) {
  Box box;
  for (const Csv::Row& row : reach.rows()) box.include({std::stod(row[0]), std::stod(row[1])});
  box.include(in_plane(leg, leg.X_BH.p));
  return box.grown(0.05 * leg.max_reach).fitted(kReach, kWidth, kHeight);
}

}  // namespace

void draw_robot(figures::StagedFiles& files, figures::Figure figure, const RobotModel& robot) {
  figure.width = kWidth;
  figure.height = kHeight;
  const LegModel& leg = robot.legs[0];
  const double cell = leg.max_reach / 60.0;
  const Csv reach = reach_table(leg, cell);
  figures::write_tables(files, figure.stem,
                        {{"above", body_table(robot, 1)},
                         {"side", body_table(robot, 2)},
                         {"legs", legs_table(robot)},
                         {"workspaces", workspaces_table(robot)},
                         {"support", support_table(robot)},
                         {"reach", reach},
                         {"leg", leg_table(leg)}});
  std::vector<std::string> names;
  std::vector<double> x, y;
  double front = 0.0, lowest = 0.0;
  for (const LegModel& each : robot.legs) {
    const Vector2 name = each.p_BC.head<2>() + 0.55 * each.workspace_radius *
                                                   (each.p_BC - robot.p_BM).head<2>().normalized();
    names.push_back(each.name);
    x.push_back(name.x());
    y.push_back(name.y());
    front = std::max(front, each.X_BH.p.head<2>().norm());
    lowest = std::min(lowest, each.p_BC.z() - robot.foot_radius);
  }
  draw_figure(files, figure,
              {{"above", kAbove},
               {"side", kSide},
               {"reach", kReach},
               {"above", shown(robot, 1, kAbove)},
               {"side", shown(robot, 2, kSide)},
               {"reach", shown(reach, leg)},
               {"leg_names", names},
               {"leg_x", x},
               {"leg_y", y},
               {"front", front},
               {"ground", lowest},
               {"cell", cell},
               {"first_leg", leg.name},
               {"com", std::vector<double>{robot.p_BM.x(), robot.p_BM.y(), robot.p_BM.z()}}},
              scripts::recording::robot);
}

}  // namespace hexagait::recording
