// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/sim/ground_truth.hpp>
#include <hexagait/sim2d/genghis_model.hpp>
#include <hexagait/sim2d/terrain2d.hpp>
#include <memory>

namespace hexagait::sim2d {

/// What Genghis senses: joint positions, motor currents, and its inclinometer.
struct GenghisMeasurement {
  double time = 0.0;          ///< [s]
  LegArray<GenghisJoints> q;  ///< [rad], [m]
  /// Of the lift motor: the force with which it presses the foot down, less what the leg weighs;
  /// mean over the control period [N].
  LegArray<double> load;
  double pitch = 0.0;  ///< positive nose up [rad]
};

/// Set points of the servos.
struct GenghisTargets {
  LegArray<GenghisJoints> q;      ///< [rad], [m]
  LegArray<GenghisJoints> q_dot;  ///< feed-forward [rad/s], [m/s]
};

struct GenghisWorldParams {
  double physics_dt = 0.0025;  ///< [s]
  double control_dt = 0.005;   ///< a whole number of physics steps [s]
  std::uint64_t seed = 1;      ///< of the terrain
  double gravity = 9.81;       ///< [m/s²]
  double foot_friction = 0.9, body_friction = 0.2;

  /// Servos: spring-dampers about the set points, with limits. Those of lift carry 16 N of robot on
  /// three feet or fewer; stiffer, and feet on uneven ground fight each other through the body.
  double lift_kp = 5000.0, lift_kd = 50.0, lift_limit = 12.0;  ///< [N/m], [N s/m], [N]
  /// In the side view swing carries the lever of the weight too; in the real robot it doesn't.
  double swing_kp = 12.0, swing_kd = 0.12, swing_limit = 0.8;  ///< [N m/rad], [N m s/rad], [N m]
};

/// Genghis in Box2D: bodies, joints, friction and contact in a vertical plane, left legs on the
/// left profile and right ones on the right. Left and right pass through each other; the body
/// touches both. There is no roll: a side view can't fall over sideways. Legs touch the ground with
/// their feet only.
///
/// Deterministic: same arguments, writes and binary give the same bits.
class GenghisWorld {
 public:
  /// @param q  initial joints. The body is level, its lowest foot on the ground, x = 0.
  /// @throws InvalidInput  listing every parameter that no world can be made from
  GenghisWorld(const GenghisModel& model, const TerrainSpec2d& terrain,
               const GenghisWorldParams& params, const LegArray<GenghisJoints>& q);
  ~GenghisWorld();
  GenghisWorld(GenghisWorld&&) noexcept;
  GenghisWorld& operator=(GenghisWorld&&) noexcept;

  void read(GenghisMeasurement& measurement) const;

  /// Sets the servos' set points and advances the world by a control period.
  void write(const GenghisTargets& targets);

  /// For the referee alone. The plane of the physics is that of x and z: the base stays at y = 0
  /// and without roll or yaw, feet are beside it as the model says. base_touches_ground is never
  /// set: that is a fall, and Genghis may slide on its underside.
  [[nodiscard]] const GroundTruth& truth() const;
  [[nodiscard]] double pitch() const;  ///< positive nose up [rad]
  [[nodiscard]] bool underside_touches() const;
  [[nodiscard]] const Terrain2d& terrain() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hexagait::sim2d
