// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/walk/trial.hpp>
#include <iosfwd>
#include <limits>
#include <vector>

namespace hexagait::recording {

/// What of a walk is drawn: the body every 20 ms, every step, every change of the gait state.
class Recording {
 public:
  /// The body at one instant.
  struct Sample {
    double time = 0.0;     ///< [s]
    Pose X_WB;             ///< true
    PlanarPose ideal;      ///< on the commanded curve
    double lateral = 0.0;  ///< [m]
    double ground = 0.0;   ///< height of the ground below the base's origin [m]
    LegArray<Vector3> p_WF;
  };
  /// One step of one leg.
  struct Step {
    LegId leg = 0;
    double lift = 0.0;                                       ///< [s]
    double land = std::numeric_limits<double>::quiet_NaN();  ///< [s]; NaN if it did not
    Vector3 p_WF = Vector3::Zero();                          ///< where it landed
  };
  /// A time in which the gait state had one CCN before adjustment and one type.
  struct GaitSpan {
    double from = 0.0, to = 0.0;  ///< [s]
    int ccn = 0;
    gait_state::GaitType type = gait_state::GaitType::none;
  };

  explicit Recording(const sim3d::Terrain& terrain) : terrain_(terrain) {}

  void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
               const walk::Referee& referee);

  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<GaitSpan>& gait() const { return gait_; }

  /// The tables as comma-separated values, with units in the header.
  void write_body(std::ostream& out) const;
  void write_steps(std::ostream& out, const RobotModel& robot) const;
  void write_gait(std::ostream& out) const;

 private:
  void watch_body(double time, const GroundTruth& truth, const walk::Referee& referee);
  void watch_steps(double time, const footstep_gen::TickRecord& record, const GroundTruth& truth);
  void watch_gait(double time, const gait_state::GaitDecision& gait);

  sim3d::Terrain terrain_;
  double start_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<Sample> samples_;
  std::vector<Step> steps_;
  std::vector<GaitSpan> gait_;
};

/// The rows of a gait diagram as tics of gnuplot: the legs' names, left ones first, as
/// write_steps() numbers them, and the gait state.
[[nodiscard]] std::string row_names(const RobotModel& robot);

}  // namespace hexagait::recording
