// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <hexagait/figures/csv.hpp>
#include <hexagait/sim2d/terrain2d.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/walk/referee/referee.hpp>
#include <limits>
#include <vector>

namespace hexagait::recording {

/// What of a walk is drawn, in either simulator: the robot every 20 ms, every step, every change of
/// the gait state.
class Recording {
 public:
  static constexpr double kSampling = 0.02;  ///< [s]

  /// The robot at one instant.
  struct Sample {
    double time = 0.0;       ///< [s]
    Pose X_WB;               ///< true
    PlanarPose ideal;        ///< on the commanded curve
    double direction = 0.0;  ///< of the commanded curve there, from x of the world [rad]
    double along = 0.0;      ///< path along the commanded curves so far [m]
    double lateral = 0.0;    ///< [m]
    double ground = 0.0;     ///< height of the ground below the base's origin [m]
    LegArray<Vector3> p_WF;
    LegSet in_contact;
    LegArray<LegJoints> q;  ///< measured
  };
  /// One step of one leg.
  struct Step {
    LegId leg = 0;
    double lift = 0.0;                                       ///< [s]
    double land = std::numeric_limits<double>::quiet_NaN();  ///< [s]; NaN if it did not
    Vector3 p_WF = Vector3::Zero();                          ///< where it landed
    double along = 0.0;                                      ///< the same, as Sample::along [m]
  };
  /// A time in which the gait state had one CCN before adjustment and one type.
  struct GaitSpan {
    double from = 0.0, to = 0.0;  ///< [s]
    int ccn = 0;
    gait_state::GaitType type = gait_state::GaitType::none;
  };

  explicit Recording(const sim3d::Terrain& terrain)
      : cell_(drawn_cell(terrain)),
        highest_(std::isfinite(terrain.highest()) ? terrain.highest() : 1.0),
        height_([terrain](double x, double y) { return terrain.height_at(x, y); }) {}
  explicit Recording(const sim2d::Terrain2d& terrain)
      : cell_(0.02), highest_(terrain.spec().height), height_([terrain](double x, double y) {
          return terrain.height_at(y < 0.0 ? sim2d::Side::right : sim2d::Side::left, x);
        }) {}

  void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
               const walk::Referee& referee);

  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<GaitSpan>& gait() const { return gait_; }
  [[nodiscard]] double height_at(double x, double y) const { return height_(x, y); }
  [[nodiscard]] double cell() const { return cell_; }        ///< in which the ground is drawn [m]
  [[nodiscard]] double highest() const { return highest_; }  ///< ground: 0 … this [m]

  /// As tables, with units in the header.
  [[nodiscard]] figures::Csv body_table() const;
  [[nodiscard]] figures::Csv steps_table(const RobotModel& robot) const;
  [[nodiscard]] figures::Csv gait_table() const;

 private:
  // A square that is level, or small.
  [[nodiscard]] static double drawn_cell(const sim3d::Terrain& terrain) {
    using enum sim3d::TerrainKind;
    constexpr double kSmall = 0.05;
    const auto& parts = terrain.spec().parts;
    const auto edge = [](const sim3d::TerrainPart& part) {
      if (part.kind == step) return sim3d::kCellEdge;
      return part.kind == boxes || part.kind == steps ? part.extent : kSmall;
    };
    const double first = parts.empty() ? sim3d::kCellEdge : edge(parts[0]);
    const auto same = [&](const sim3d::TerrainPart& part) { return edge(part) == first; };
    return std::ranges::all_of(parts, same) ? first : kSmall;
  }
  void watch_steps(double time, const footstep_gen::TickRecord& record, const GroundTruth& truth);
  void watch_gait(double time, const gait_state::GaitDecision& gait);

  double cell_, highest_;
  std::function<double(double, double)> height_;
  double start_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<Sample> samples_;
  std::vector<Step> steps_;
  std::vector<GaitSpan> gait_;
};

/// How far ahead of the base's origin a point is, along the commanded curve [m].
[[nodiscard]] double ahead(const Recording::Sample& sample, const Vector3& p_W);

/// The row of a leg in a gait diagram: left legs above right ones, the front ones first.
[[nodiscard]] int gait_row(LegId leg, int num_legs);

/// These rows as tics of gnuplot: the legs' names, and below them the gait state.
[[nodiscard]] std::string row_names(const RobotModel& robot);

}  // namespace hexagait::recording
