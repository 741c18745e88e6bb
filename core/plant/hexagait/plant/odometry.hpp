// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/params/robot_params.hpp>
#include <hexagait/plant/robot_state.hpp>

namespace hexagait {

/// Leg odometry: the pose of the base from the legs that stand.
///
/// The pose X_OB is the one that best fits the measured feet p_BF to footholds p_OF at rest:
///
///     X_OB = argmin Σ_i w_i ‖X_OB p_BF,i − p_OF,i‖²                                   (odometry 1)
///
/// w_i is the fraction of its load that leg i carries (0 in the air, 1 in full support), reduced
/// for a foot that slides, which shows in its distances to the other feet on the ground
/// (odometry 3). A spherical foot of radius ρ rolls without slipping, so its centre moves while its
/// contact point stands:
///
///     ṗ_OF = ω_tibia × ρ n                                                            (odometry 2)
///
/// Joints are noisy, and a foot must not seem to slide for that: ε grows with the noise of the feet,
/// which shows in the second differences of those that stand,
///
///     ε² = ε₀² + 25 · ⅔ σ²,   σ² ← mean of |p_k − 2 p_k₋₁ + p_k₋₂|² / 6                (odometry 4)
///
/// Without it, footholds that seem to slide follow the noise, and the pose strays with them.
/// Without (odometry 2), a tibia that turns by 15° on a foot of 2 cm would look like 5 mm of slip.
/// Odometry does not sense gravity: it assumes that the robot starts on level ground. If feet lose the
/// ground until those that stand are in a row, how the body tilts about that row is not seen, and the
/// footholds of the legs that come down then make the error last. Where up is measured, level() sets it right. An inclinometer
/// takes it back slowly: odom turns about the body's origin by the measured less the estimated roll and
/// pitch, as much as is measured,
///
///     dφ/dt = (φ_measured − φ) / τ                                                    (odometry 5)
///
/// with τ a few steps, over which the noise of the inclinometer and the body's swaying average out.
/// The robot model must outlive the odometry.
class Odometry {
 public:
  /// @param tolerance  what is kDerived follows from the model
  explicit Odometry(const RobotModel& model, const ToleranceParams& tolerance = {});
  explicit Odometry(const RobotModel&&, const ToleranceParams& = {}) = delete;

  /// Complete.
  [[nodiscard]] const ToleranceParams& tolerance() const { return tolerance_; }

  /// Places the odom frame under the robot: z normal to the plane through the feet, z = 0 at their
  /// mean lowest point, x and yaw of the body. Feet in a row do not say how the ground slopes across
  /// it: it is taken as level with the body there. For a robot that rests on its belly, odom is the
  /// body frame.
  void reset(RobotState& state, RestsOn rests_on = RestsOn::feet);

  /// Turns body and footholds about the middle of the feet that stand, so that the measured direction of
  /// up is z of odom. Yaw, and where those feet are on average, stay as they are.
  /// @param up_B     unit vector upwards, body frame
  /// @param footing  as in update()
  void level(RobotState& state, const Vector3& up_B, const LegArray<double>& footing) noexcept;

  /// Updates X_OB, V_B, p_OF, print_O and slide_O from q, trig and p_BF.
  /// @param footing  fraction of its load that each leg carries, 0 … 1; the footholds of legs below
  ///                 1 follow the feet as they settle
  /// @param dt       time since the previous update [s]
  void update(RobotState& state, const LegArray<double>& footing, double dt) noexcept;

 private:
  [[nodiscard]] Pose pose_over_feet(const RobotState& state) const;
  void lean(RobotState& state, double dt) noexcept;
  void turn(RobotState& state, const Pose& about) noexcept;
  void measure_noise(const RobotState& state, const LegArray<double>& footing) noexcept;
  [[nodiscard]] double slide_tolerance2() const noexcept;
  void roll(const RobotState& state, LegId leg, const Vector3& rotation_B) noexcept;

  const RobotModel* model_;
  ToleranceParams tolerance_;
  LegArray<Vector3> anchor_O_;      ///< footholds [m]
  LegArray<Vector3> off_anchor_O_;  ///< from them to the feet [m]
  LegArray<LegJoints> q_before_;    ///< joints of the previous update [rad]
  LegArray<LegTrig> trig_before_;
  LegArray<Vector3> p_before_, step_before_;  ///< feet in the body, and their last way [m]
  double noise2_ = 0.0;                       ///< σ² of (odometry 4) [m²]
  long noise_samples_ = 0;                    ///< that it is the mean of
  Pose X_OB_;
};

}  // namespace hexagait
