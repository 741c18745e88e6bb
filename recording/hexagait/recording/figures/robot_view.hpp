// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/figures/csv.hpp>
#include <hexagait/figures/panel.hpp>
#include <hexagait/recording/recording.hpp>
#include <vector>

/// A recorded robot as it is drawn: from above in the plane of x and y, and from the side in the
/// plane of z and the path along the commanded curves, which unrolls an arc. Tables for gnuplot; a
/// blank line parts two curves.
namespace hexagait::recording {

/// The corners of a box about a shape, in the frame of its link [m].
[[nodiscard]] std::array<Vector3, 8> corners(const Shape& shape);

/// Hip, joints beyond the first, and the foot at p_WF, in the world [m].
[[nodiscard]] std::vector<Vector3> leg_line(const LegModel& leg, const LegJoints& q,
                                            const Pose& X_WB, const Vector3& p_WF);

/// Adds a closed line through the corners of a hull; one of no corners keeps its place by an empty row.
void add_hull(figures::Csv& csv, const SupportPolygon& hull);

/// What is drawn of one walk.
class RobotView {
 public:
  RobotView(const Recording& recording, const RobotModel& robot)
      : recording_(recording), robot_(robot) {}

  /// Longest edge of the base's shapes, or of the hips' bounds where it has none [m].
  [[nodiscard]] double body_length() const;

  /// A polygon per instant and per shape of the base, its outline: along_m,z_m and x_m,y_m.
  [[nodiscard]] figures::Csv side(const std::vector<std::size_t>& samples) const;
  [[nodiscard]] figures::Csv above(const std::vector<std::size_t>& samples) const;
  /// How many polygons these tables have of an instant.
  [[nodiscard]] int num_outlines() const;

  /// A line per instant and leg: hip, joints, foot.
  [[nodiscard]] figures::Csv legs(const std::vector<std::size_t>& samples) const;

  /// A polygon per instant: of the feet on the ground, from above.
  [[nodiscard]] figures::Csv support(const std::vector<std::size_t>& samples) const;

  /// A line per leg: where its foot has been.
  [[nodiscard]] figures::Csv feet(const std::vector<std::size_t>& samples) const;

  /// The ground under the outermost feet, to the left and to the right of the path.
  [[nodiscard]] figures::Csv profile() const;
  /// The ground from above, in cells.
  [[nodiscard]] figures::Csv cells(const figures::Box& shown) const;

  /// Sample k's point in the side view.
  [[nodiscard]] Vector2 from_side(std::size_t k, const Vector3& p_W) const;

 private:
  template <class Project>
  [[nodiscard]] figures::Csv outlines(const char* header, const std::vector<std::size_t>& samples,
                                      Project project) const;

  const Recording& recording_;
  const RobotModel& robot_;
};

}  // namespace hexagait::recording
