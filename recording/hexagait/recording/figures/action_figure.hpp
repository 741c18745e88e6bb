// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/figure.hpp>
#include <hexagait/script/action_runner.hpp>
#include <hexagait/sim/ground_truth.hpp>
#include <vector>

namespace hexagait::recording {

/// What of an action is drawn: base, feet and stability every 20 ms, and its steps.
class ActionRecording {
 public:
  struct Sample {
    double time = 0.0;  ///< since the recording began [s]
    Vector3 base = Vector3::Zero();
    LegArray<Vector3> feet;  ///< [m]
    double margin = 0.0;     ///< of stability, to the controller's knowledge [m]
    LegSet support;
  };
  struct Step {
    int number = 0;               ///< from 1
    double from = 0.0, to = 0.0;  ///< [s]
  };

  /// As the controller has it: in odom.
  void observe(const ActionRecord& record);
  /// As it is true: in the world.
  void observe(const ActionRecord& record, const GroundTruth& truth);

  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }

 private:
  void add(const ActionRecord& record, const Vector3& base, const LegArray<Vector3>& feet);

  double start_ = -1.0;
  std::vector<Sample> samples_;
  std::vector<Step> steps_;
};

/// Draws an action in three panels: paths of base and feet from above and from the side, and the
/// stability margin over time with the limits of the steps. Writes the figure, and what it was made
/// of: stem.gp, stem-base.csv, stem-feet.csv, stem-steps.csv. The caller has registered
/// stem.suffix.
/// @throws std::runtime_error  if gnuplot fails
void draw_action(figures::StagedFiles& files, figures::Figure figure,
                 const ActionRecording& recording, const RobotModel& robot);

}  // namespace hexagait::recording
