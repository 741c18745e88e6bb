// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/plant/plant.hpp>
#include <hexagait/sim/ground_truth.hpp>
#include <hexagait/sim/imperfection.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace hexagait::sim3d {

/// A fixed box with edges along the axes: an obstacle that the terrain does not include.
struct Block {
  Vector3 centre = Vector3::Zero();       ///< [m]
  Vector3 size = Vector3::Constant(0.1);  ///< edges [m]
};

/// Parameters of a World. What is kDerived follows from the robot's model.
struct WorldParams : PlantParams {
  /// Physics step h [s]; if it is kDerived, physics_step_for(control_dt, longest_step).
  double physics_dt = kDerived;

  /// Control period, by which write() advances the world [s]. A multiple of physics_dt.
  double control_dt = 0.002;

  /// Seed of the terrain, and of the masses of mass_error.
  std::uint64_t seed = 1;

  double gravity = kStandardGravity;  ///< [m/s²], along −z

  /// The drives keep to the model's velocity limits, as motors with so much voltage do: no torque
  /// drives a joint beyond them, and what is moved faster from outside is braked.
  bool velocity_limits = true;

  /// Dry friction of every drive and its gear, which opposes any motion of the joint [N m]. Not
  /// part of the servo's effort and its limit. Too high: joints stick, and stop beside their targets.
  double drive_friction = 0.0;

  /// Play of every gear [rad]: a position servo holds its side of the gear, and within half of this
  /// to either side nothing holds the joint but the friction of its drive. The joint's sensor is
  /// behind the gear.
  double backlash = 0.0;

  /// Inertia of every drive's rotor as seen at the joint, its own times the square of the gear
  /// ratio [kg m²]. It does not turn with the link: the robot's mass and inertia are unchanged.
  double armature = 0.0;

  /// Time constant T of servos that follow their targets late [s]: they hold to q̃, of which
  /// T dq̃/dt = q* − q̃, and the same of q̇* and τ*.
  double servo_lag = 0.0;

  /// Masses and inertias of all links differ from the model's by this share, each up or down by lot
  /// (of `seed`). The controller's model does not.
  double mass_error = 0.0;

  /// The robot has an inertial measurement unit at the body's origin. It feels the mean acceleration over a
  /// control period, and the rate at its end.
  bool imu = false;

  /// Coefficient μ of Coulomb friction between robot and ground; a pyramid: at most μ · normal
  /// force in each of two directions along the ground.
  double friction = 0.9;

  /// The ground is slightly soft. Each step removes the fraction `erp` of the penetration, at most
  /// at contact_correcting_speed, and a force F penetrates at the speed `cfm` · F, with cfm in
  /// m/(N s): contact_cfm. So a foot with load F stands h · cfm/erp · F deep: 5 µm at 80 N and cfm
  /// 1e-5. Harder ground: impacts at touchdown.
  double contact_erp = 0.3;

  /// The same for the hinges, with hinge_cfm.
  double hinge_erp = 0.4;

  /// Pose of the base in the plane at the start. The terrain has a flat pad around the origin.
  PlanarPose start;

  /// Least height of the base's origin above the ground at the start [m], for a robot on its belly.
  double start_height = -std::numeric_limits<double>::infinity();

  /// Obstacles on the terrain. Terrain::height_at() does not include them.
  std::vector<Block> blocks;

  /// Fixes the base where it starts, with the legs hanging from it, as on a test stand.
  bool base_on_stand = false;
};

/// Sets what is kDerived to what follows from the robot's model.
[[nodiscard]] WorldParams completed(WorldParams params, const RobotModel& robot);

/// The longest physics step, of at most `longest`, of which a control period is a multiple [s].
[[nodiscard]] double physics_step_for(double control_dt, double longest);

/// Those of the parameters that say how far the robot and the ground are from ideal ones.
[[nodiscard]] std::span<const Imperfection<WorldParams>> imperfections();

/// A robot in a rigid-body world: a Plant that also gives a referee the ground truth.
///
/// Every joint has the same position servo, an implicit spring-damper with feed-forward,
///
///     τ = Kp (q* − q₊) + Kd (q̇* − q̇₊) + τ*,   |τ| ≤ effort limit
///
/// with q*, q̇*, τ* the targets and q₊, q̇₊ the state, all at the end of the physics step. Within the
/// control period q* moves at q̇* and is the target position at its end: on the line from the last
/// target to this one. Position targets are clamped to the joint limits, which are the
/// only stops that joints have. Legs can also be driven by velocity or by effort
/// (JointTargets::mode); a joint that reaches its limit is then held there by the position servo.
/// Before the first write() the servos hold the initial joint positions.
///
/// With a velocity limit v the drive's torque is bounded by the steep lines of a motor at its limit,
///
///     G (−v − q̇₊) ≤ τ ≤ G (v − q̇₊)
///
/// in which G is ten times the greatest gain of a servo: far above what the load asks for.
///
/// Feet are the spheres at the legs' foot centres. All other shapes collide with the ground too,
/// but have no sensor. Links of the robot do not collide with each other. The ground is unbounded:
/// see Terrain.
///
/// Deterministic: the same model, terrain, parameters, writes and binary give the same bits,
/// whatever else runs in the process. Worlds may run on different threads, each on the one that
/// made it.
class World : public Plant {
 public:
  /// The base starts level, with the lowest foot start_clearance above the ground.
  /// @param q  initial joint positions [rad]
  /// @throws InvalidInput  listing all invalid parameters and links
  World(const RobotModel& robot, const TerrainSpec& terrain, const WorldParams& params,
        const LegArray<LegJoints>& q);
  ~World() override;
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Present joint positions; contact if a sensor was closed in any physics step of the last
  /// write(), none before the first write(). Returns at once: `fresh`, or `closed` once the physics
  /// has diverged.
  PlantStatus read(Measurement& measurement) override;

  /// Sets the servos' targets and advances the world by one control period. Targets that are not
  /// finite close the plant.
  /// @pre `targets` has the robot's number of legs
  void write(const JointTargets& targets) override;

  /// Applies a force at the base link's centre of mass for some time, rounded to physics steps;
  /// replaces an earlier push.
  /// @param force_W  world axes [N]
  /// @param seconds  duration [s]
  void push(const Vector3& force_W, double seconds);

  /// Cuts a leg off at its first joint: from now on it is not there. Its joints read what they read
  /// last, and its foot touches nothing.
  void cut(LegId leg);

  /// Leaves a joint's servo this share of the effort limit that it has in the model.
  void weaken(LegId leg, int joint, double share);

  /// For referees only.
  [[nodiscard]] const GroundTruth& truth() const;

  /// For referees only: effort of each servo in the last physics step [N m].
  [[nodiscard]] const LegArray<LegJoints>& efforts() const;

  [[nodiscard]] const Terrain& terrain() const;

  /// How far it is to the ground or to a block, the robot itself left out: for simulated sensors and
  /// for referees.
  /// @param from_W       world axes [m]
  /// @param direction_W  of length 1
  /// @returns [m]; ∞ if it is farther than `longest`
  [[nodiscard]] double range(const Vector3& from_W, const Vector3& direction_W,
                             double longest) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hexagait::sim3d
