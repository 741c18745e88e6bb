// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/recording/figures/robot_view.hpp>

namespace hexagait::recording {
namespace {

using figures::Csv;
using Sample = Recording::Sample;

Vector2 from_above(const Vector3& p_W) { return p_W.head<2>(); }

}  // namespace

std::array<Vector3, 8> corners(const Shape& shape) {
  Vector3 edges = shape.size;
  if (shape.kind == Shape::Kind::sphere) edges.setConstant(2.0 * shape.size.x());
  if (shape.kind == Shape::Kind::cylinder)
    edges = {2.0 * shape.size.x(), 2.0 * shape.size.x(), shape.size.y()};
  std::array<Vector3, 8> points;
  for (unsigned k = 0; k < 8; ++k) {
    const Vector3 sign((k & 1U) != 0 ? 0.5 : -0.5, (k & 2U) != 0 ? 0.5 : -0.5,
                       (k & 4U) != 0 ? 0.5 : -0.5);
    points[k] = shape.X_LS * Vector3(sign.cwiseProduct(edges));
  }
  return points;
}

std::vector<Vector3> leg_line(const LegModel& leg, const LegJoints& q, const Pose& X_WB,
                              const Vector3& p_WF) {
  std::vector<Vector3> points = {X_WB * leg.X_BH.p};
  for (int k = 1; k < leg.p_BJ0.size(); ++k) {
    const Vector3 p_LJ = leg.links[k - 1].X_BL0.inverse() * leg.p_BJ0[k];
    points.push_back(X_WB * (link_pose(leg, k - 1, q) * p_LJ));
  }
  points.push_back(p_WF);
  return points;
}

void add_hull(Csv& csv, const SupportPolygon& hull) {
  for (int k = 0; k <= hull.size && hull.size > 0; ++k)
    csv.row(hull.vertices[static_cast<std::size_t>(k % hull.size)]);
  if (hull.size == 0) csv.row(Vector2(Vector2::Constant(std::nan(""))));
  csv.gap();
}

double RobotView::body_length() const {
  double length = 0.0;
  for (const Shape& shape : robot_.base.shapes) {
    const auto points = corners(shape);
    length = std::max(length, (points[7] - points[0]).cwiseAbs().maxCoeff());
  }
  for (const LegModel& leg : robot_.legs)
    length = std::max(length, 2.0 * leg.X_BH.p.head<2>().cwiseAbs().maxCoeff());
  return length;
}

Vector2 RobotView::from_side(std::size_t k, const Vector3& p_W) const {
  const Sample& sample = recording_.samples()[k];
  return {sample.along + ahead(sample, p_W), p_W.z()};
}

int RobotView::num_outlines() const { return static_cast<int>(robot_.base.shapes.size()); }

template <class Project>
Csv RobotView::outlines(const char* header, const std::vector<std::size_t>& samples,
                        Project project) const {
  Csv csv(header);
  for (const std::size_t k : samples)
    for (const Shape& shape : robot_.base.shapes) {
      std::array<Vector2, 8> points;
      std::ranges::transform(corners(shape), points.begin(), [&](const Vector3& p_B) {
        return project(k, recording_.samples()[k].X_WB * p_B);
      });
      add_hull(csv, support_polygon(points));
    }
  return csv;
}

Csv RobotView::side(const std::vector<std::size_t>& samples) const {
  return outlines("along_m,z_m", samples,
                  [this](auto k, const Vector3& p_W) { return from_side(k, p_W); });
}

Csv RobotView::above(const std::vector<std::size_t>& samples) const {
  return outlines("x_m,y_m", samples, [](auto, const Vector3& p_W) { return from_above(p_W); });
}

Csv RobotView::legs(const std::vector<std::size_t>& samples) const {
  Csv csv("leg,along_m,z_m,x_m,y_m,foot");
  for (const std::size_t k : samples) {
    const Sample& sample = recording_.samples()[k];
    for (LegId i = 0; i < robot_.num_legs(); ++i) {
      const auto line = leg_line(robot_.legs[i], sample.q[i], sample.X_WB, sample.p_WF[i]);
      for (const Vector3& p : line)
        csv.row(i, from_side(k, p), from_above(p), &p == &line.back() ? 1 : 0);
      csv.gap();
    }
  }
  return csv;
}

Csv RobotView::support(const std::vector<std::size_t>& samples) const {
  Csv csv("x_m,y_m");
  for (const std::size_t k : samples) {
    const Sample& sample = recording_.samples()[k];
    add_hull(csv, support_polygon(sample.p_WF, sample.in_contact));
  }
  return csv;
}

Csv RobotView::feet(const std::vector<std::size_t>& samples) const {
  Csv csv("leg,along_m,z_m,x_m,y_m");
  for (LegId i = 0; i < robot_.num_legs(); ++i) {
    for (const std::size_t k : samples) {
      const Vector3& p_WF = recording_.samples()[k].p_WF[i];
      csv.row(i, from_side(k, p_WF), from_above(p_WF));
    }
    csv.gap();
  }
  return csv;
}

Csv RobotView::profile() const {
  double left = 0.0, right = 0.0;
  for (const LegModel& leg : robot_.legs) {
    left = std::max(left, leg.p_BC.y());
    right = std::min(right, leg.p_BC.y());
  }
  Csv csv("along_m,left_m,right_m");
  const auto add = [&](const Sample& sample, double further) {
    const Vector2 forward = unit_vector(sample.direction);
    const auto height = [&](double aside) {
      const Vector2 p =
          sample.X_WB.p.head<2>() + further * forward + aside * perpendicular(forward);
      return recording_.height_at(p.x(), p.y());
    };
    csv.row(sample.along + further, height(left), height(right));
  };
  // Behind the start and beyond the end the path goes straight on.
  constexpr double kStep = 0.005;
  const double room = 3.0 * body_length();
  const auto& samples = recording_.samples();
  for (double s = -room; s < 0.0; s += kStep) add(samples.front(), s);
  for (const Sample& sample : samples) add(sample, 0.0);
  for (double s = 0.0; s < room; s += kStep) add(samples.back(), s);
  return csv;
}

Csv RobotView::cells(const figures::Box& shown) const {
  Csv csv("x_m,y_m,height_m");
  const double cell = recording_.cell();
  const auto first = [cell](double x) { return (std::floor(x / cell) + 0.5) * cell; };
  for (double x = first(shown.least.x()); x < shown.greatest.x() + cell; x += cell)
    for (double y = first(shown.least.y()); y < shown.greatest.y() + cell; y += cell)
      csv.row(x, y, recording_.height_at(x, y));
  return csv;
}

}  // namespace hexagait::recording
