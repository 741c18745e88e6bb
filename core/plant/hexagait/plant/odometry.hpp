// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/plant/robot_state.hpp>

namespace hexagait {

/// Where the base is, from the legs that stand: leg odometry.
///
/// The pose X_OB is the one that best explains the measured feet p_BF by footholds p_OF at rest:
///
///     X_OB = argmin Σ_i w_i ‖X_OB p_BF,i − p_OF,i‖²                                   (odometry 1)
///
/// w_i is the share of load that leg i carries (0 in the air, 1 in full support), less where the
/// foot slides: then its distances to most other feet on the ground change (odometry 3). A
/// spherical foot of radius ρ rolls on the ground without slipping, so its centre moves while its
/// contact stands:
///
///     ṗ_OF = ω_tibia × ρ n                                                            (odometry 2)
///
/// Leaving (2) out looks like slip: 5 mm for a tibia that turns by 15° on a foot of 2 cm.
/// Odometry sees no gravity: z is up by the assumption that the robot starts on level ground.
class Odometry {
 public:
  explicit Odometry(const RobotModel& model) : model_(&model) {}

  /// Puts the odom frame under the robot: z = 0 at the feet's mean lowest point, z normal to the
  /// plane through the feet, x and y those of the body.
  /// A robot that lies has z of odom along that of its body, and z = 0 at its origin.
  void reset(RobotState& state, RestsOn rests_on = RestsOn::feet);

  /// Fills X_OB, V_B and p_OF from q, trig and p_BF.
  /// @param footing  share of its load that each leg carries, 0 … 1; legs below 1 are anchored anew
  ///                 as they settle
  void update(RobotState& state, const LegArray<double>& footing, double dt) noexcept;

 private:
  [[nodiscard]] Pose pose_over_feet(const RobotState& state) const;
  void roll(RobotState& state, LegId leg, const Vector3& rotation_B, const Vector3& up_B) noexcept;

  const RobotModel* model_;
  LegArray<Vector3> anchor_O_;    ///< footholds [m]
  LegArray<LegJoints> q_before_;  ///< joints of the previous update [rad]
  LegArray<LegTrig> trig_before_;
  Pose X_OB_;
};

}  // namespace hexagait
