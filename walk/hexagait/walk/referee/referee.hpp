// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/gait_state/tripod_gait.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/sim/ground_truth.hpp>
#include <hexagait/walk/referee/path_judge.hpp>
#include <hexagait/walk/referee/reference_path.hpp>
#include <hexagait/walk/referee/summary.hpp>
#include <optional>
#include <vector>

namespace hexagait::walk {

using gait_state::first_tripod_gait;
using gait_state::TimedLift;

/// Judges a walk by ground truth, tick by tick. Sees what the controller can't, and tells it
/// nothing.
class Referee {
 public:
  /// @param params  what is kDerived follows from the robot's model
  Referee(const RobotModel& model, const GroundTruth& truth, double control_dt,
          const RefereeParams& params = {});

  /// From now on the walk is judged by this path instead of the commanded curves: distance, deviation,
  /// ideal pose, progress. Before the first observe().
  /// @param task  must outlive the referee
  void follow(const path_following::PathTask& task) { path_judge_.emplace(task, start_); }

  /// After every tick of the controller and step of the plant.
  void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth);

  [[nodiscard]] const RobotModel& robot() const { return *model_; }
  [[nodiscard]] const ReferencePath::Deviation& deviation() const { return deviation_; }
  /// Where the base should be, on the commanded curve or on the path.
  [[nodiscard]] PlanarPose ideal() const {
    return path_judge_ ? path_judge_->ideal() : path_.ideal();
  }
  [[nodiscard]] bool fell() const { return summary_.fell; }
  [[nodiscard]] bool stuck() const { return summary_.stuck; }
  [[nodiscard]] double distance() const { return distance_before_ + deviation_.progress; }
  [[nodiscard]] double turned() const { return turned_; }

  [[nodiscard]] Summary summary() const;

 private:
  /// A foot's present stance, by the truth alone.
  struct Stance {
    bool stands = false;
    Vector3 slip_before = Vector3::Zero();  ///< reading of its slip before the first touch [m]
    double off = 0.0;                       ///< time since it last touched [s]
    double z = 0.0;                         ///< height of the foot a tick ago [m]
    double descent = 0.0;                   ///< its downward speed then [m/s]
  };
  /// A leg's present support, as the controller has it.
  struct Support {
    double age = 0.0;               ///< [s]
    bool lost = false;              ///< it has no contact
    bool is_real = false;           ///< it has been without for long, or has gone far
    double off = 0.0;               ///< time without [s]
    Vector3 p_W = Vector3::Zero();  ///< where the foot last touched [m]
  };

  void follow_curve(const footstep_gen::TickRecord& record, const GroundTruth& truth);
  void follow_path(const footstep_gen::TickRecord& record, const GroundTruth& truth);
  void watch_posture(const GroundTruth& truth);
  void watch_stances(const GroundTruth& truth);
  void watch_support(const footstep_gen::TickRecord& record, const GroundTruth& truth);
  void watch_rule1(const footstep_gen::TickRecord& record, const GroundTruth& truth);
  [[nodiscard]] Hindrance hindrance(const footstep_gen::TickRecord& record) const;
  void watch_legs(const footstep_gen::TickRecord& record);
  void watch_progress(const footstep_gen::TickRecord& record);

  const RobotModel* model_;
  double dt_;
  RefereeParams params_;
  PlanarPose start_;
  ReferencePath path_;
  std::optional<PathJudge> path_judge_;
  heading_control::Heading heading_ = heading_control::Heading::stop();
  ReferencePath::Deviation deviation_;
  double distance_before_ = 0.0;
  double lateral_sum_ = 0.0;
  long ticks_ = 0, lateral_ticks_ = 0;
  LegArray<Stance> stances_;
  LegArray<Vector3> slip_before_touch_;
  LegArray<Support> supports_;
  std::vector<double> slips_, touchdowns_, margins_, swing_times_;
  LegArray<double> lift_time_;
  std::vector<TimedLift> lifts_;
  double idle_ = 0.0, progress_seen_ = 0.0;
  Vector2 p_WB_seen_ = Vector2::Zero();  ///< on a path: where it was when it last got on [m]
  double turned_ = 0.0, turned_before_ = 0.0, yaw_before_ = 0.0;
  LegArray<double> not_standing_, not_stepping_;  ///< for how long each leg [s]
  LegArray<int> no_ground_;                       ///< how often, since the robot last got on
  double outer_ = 0.0;                            ///< the farthest workspace centre [m]
  Summary summary_;
  int tries_ = 0;              ///< of the present deadlock
  double work_before_, work_;  ///< of the joints, before the walk and now [J]
  Pose odometry_, truth_;
};

/// Sets what is kDerived to what follows from the robot's model.
[[nodiscard]] RefereeParams completed(const RefereeParams& params, const RobotModel& model);

/// Nearest-rank percentile of values; NaN, which no bound contains, if there are none.
/// @param share  0 … 1
[[nodiscard]] double percentile(std::vector<double> values, double share);

}  // namespace hexagait::walk
