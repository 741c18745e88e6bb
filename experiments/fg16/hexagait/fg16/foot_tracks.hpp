// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/script/action_runner.hpp>
#include <hexagait/sim/ground_truth.hpp>
#include <vector>

namespace hexagait::experiments {

/// How the feet of a robot that carries out an action follow it, by ground truth. The map is the
/// world. What is commanded was brought from the map into odom when its step began ([FG16] III-C),
/// and is brought back by the same transform: if odometry drifts within the step, it shows.
class FootTracks {
 public:
  struct Sample {
    double time = 0.0;                  ///< [s]
    int step = 0;                       ///< of the action
    LegSet swinging;                    ///< feet that don't stand, to the controller's knowledge
    LegArray<Vector3> commanded;        ///< feet in the map [m]
    LegArray<Vector3> reached;          ///< where they truly are [m]
    LegArray<Vector3> by_localisation;  ///< where the robot would say they are [m] …
    LegArray<Vector3> by_odometry;      ///< … and if it had only known its place at the start [m]
    Pose X_MB;                          ///< base, truly
  };
  struct Touchdown {
    double time = 0.0;  ///< [s]
    LegId leg = 0;
    Vector3 foothold = Vector3::Zero();  ///< that was commanded, in the map [m]
    Vector3 reached = Vector3::Zero();   ///< where the foot came to stand [m]
    /// Across the plumb line: heights are the ground's.
    [[nodiscard]] double error() const { return (reached - foothold).head<2>().norm(); }
  };

  /// After every tick.
  /// @param X_OM  as the localisation has it now
  void observe(const ActionRunner& runner, const Pose& X_OM, const GroundTruth& truth);

  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<Touchdown>& touchdowns() const { return touchdowns_; }

  /// Distances between commanded and reached of all feet that swing, at all samples [m].
  [[nodiscard]] std::vector<double> swing_errors() const;

  /// Largest way of a foot in one tick beyond its commanded velocity times the time [m]: of where
  /// it is commanded to be, in odom; and of where localisation has it.
  [[nodiscard]] double commanded_jump() const { return commanded_jump_; }
  [[nodiscard]] double localised_jump() const { return localised_jump_; }

 private:
  [[nodiscard]] Sample sample(const ActionRecord& record, const Pose& X_OM,
                              const GroundTruth& truth) const;
  void watch_landings(const ActionRunner& runner, const Sample& now);
  void watch_jumps(const ActionRecord& record, const Sample& now);

  std::vector<Sample> samples_;  ///< every kEvery ticks
  std::vector<Touchdown> touchdowns_;
  long ticks_ = 0;
  Sample last_;
  LegArray<Vector3> commanded_O_;  ///< in the tick before
  Pose X_MO_start_, X_MO_step_;    ///< when the action, and its step, began
  double commanded_jump_ = 0.0, localised_jump_ = 0.0;
};

}  // namespace hexagait::experiments
