// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/recording/figures/detail/robot_tables.hpp>
#include <hexagait/recording/figures/robot_view.hpp>

namespace hexagait::recording::detail {

using figures::Csv;

namespace {

// In a plane of the body: x and y, or x and z.
Vector2 seen(const Vector3& p, int axis) { return {p.x(), p[axis]}; }

void add_box(Csv& csv, const Shape& shape, int axis) {
  std::array<Vector2, 8> points;
  std::ranges::transform(corners(shape), points.begin(),
                         [&](const Vector3& p) { return seen(p, axis); });
  add_hull(csv, support_polygon(points));
}

// A circle about z of the shape, as it is seen.
void add_circle(Csv& csv, const Shape& shape, double z, int axis) {
  constexpr int kCorners = 48;
  for (int k = 0; k <= kCorners; ++k) {
    const Vector2 rim = shape.size.x() * unit_vector(2.0 * std::numbers::pi * k / kCorners);
    csv.row(seen(shape.X_LS * Vector3(rim.x(), rim.y(), z), axis));
  }
  csv.gap();
}

}  // namespace

LegJoints stance_of(const LegModel& leg) { return inverse_kinematics(leg, leg.p_BC).q; }

Csv body_table(const RobotModel& robot, int axis) {
  Csv csv(axis == 1 ? "x_m,y_m" : "x_m,z_m");
  for (const Shape& shape : robot.base.shapes) {
    if (shape.kind == Shape::Kind::box) add_box(csv, shape, axis);
    if (shape.kind == Shape::Kind::sphere) {
      Shape ball = shape;  // a circle from wherever it is seen
      ball.X_LS.R = axis == 1 ? Matrix3(Matrix3::Identity())
                              : rotation(Vector3(0.5 * std::numbers::pi, 0.0, 0.0));
      add_circle(csv, ball, 0.0, axis);
    }
    if (shape.kind != Shape::Kind::cylinder) continue;
    const Vector3 half = 0.5 * shape.size.y() * shape.X_LS.R.col(2);
    const Vector2 along = seen(half, axis);
    const Vector2 across = along.norm() > 1e-9
                               ? Vector2(shape.size.x() * perpendicular(along.normalized()))
                               : Vector2(Vector2::Zero());
    const Vector2 middle = seen(shape.X_LS.p, axis);
    add_hull(csv, support_polygon(
                      std::array<Vector2, 4>{middle + along + across, middle + along - across,
                                             middle - along - across, middle - along + across}));
    for (const double z : {-0.5, 0.5}) add_circle(csv, shape, z * shape.size.y(), axis);
  }
  return csv;
}

Csv legs_table(const RobotModel& robot) {
  Csv csv("leg,x_m,y_m,z_m,foot");
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const LegModel& leg = robot.legs[i];
    const auto line = leg_line(leg, stance_of(leg), Pose{}, leg.p_BC);
    for (const Vector3& p : line) csv.row(i, p, &p == &line.back() ? 1 : 0);
    csv.gap();
  }
  return csv;
}

figures::Box bounds(const RobotModel& robot, int axis) {
  figures::Box box;
  for (const Shape& shape : robot.base.shapes)
    for (const Vector3& p : corners(shape)) box.include(seen(p, axis));
  for (const LegModel& leg : robot.legs) {
    for (const Vector3& p : leg_line(leg, stance_of(leg), Pose{}, leg.p_BC))
      box.include(seen(p, axis));
    const Vector3 disc(leg.workspace_radius, leg.workspace_radius, 0.0);
    box.include(seen(leg.p_BC + disc, axis));
    box.include(seen(leg.p_BC - disc, axis));
  }
  return box;
}

}  // namespace hexagait::recording::detail
