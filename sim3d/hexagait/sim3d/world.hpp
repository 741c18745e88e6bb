// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/plant/plant.hpp>
#include <hexagait/sim/ground_truth.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <limits>
#include <memory>
#include <vector>

namespace hexagait::sim3d {

/// A box that stands in the world, its edges along the axes, and does not move: what lies in the
/// way and nobody knows of.
struct Block {
  Vector3 centre = Vector3::Zero();       ///< [m]
  Vector3 size = Vector3::Constant(0.1);  ///< edges [m]
};

/// How a World is simulated. The defaults suit a robot of some 50 kg.
struct WorldParams {
  /// Physics step h [s]. At 4 ms the simulation is twice as fast and a walk much the same; smaller
  /// steps cost time and change little.
  double physics_dt = 0.002;

  /// Control period [s]: what write() advances. A whole number of physics steps.
  double control_dt = 0.002;

  /// Seed of the terrain's heights.
  std::uint64_t seed = 1;

  double gravity = 9.81;  ///< [m/s²], along −z

  /// Stiffness Kp [N m/rad] and damping Kd [N m s/rad] of every joint's servo. Too soft, and the
  /// body sags under its own weight; too stiff, and feet on uneven ground fight each other through
  /// the body and kick.
  double servo_kp = 4000.0;
  double servo_kd = 100.0;

  /// The same servos by velocity: τ = Kv (q̇* − q̇₊) + τ* [N m s/rad]. Too soft, and the leg's weight
  /// drives it.
  double servo_kv = 1000.0;

  /// And by effort: τ = τ* − D q̇₊, D the friction of the drive [N m s/rad].
  double servo_friction = 1.0;

  /// Coulomb friction μ between robot and ground: in each of two directions along the ground, at
  /// most μ · normal force (a pyramid).
  double friction = 0.9;

  /// A foot's contact sensor answers when the normal forces on it sum to more than this [N]. Too
  /// small, and a foot that brushes an edge counts as standing; too large, and a lightly loaded one
  /// does not.
  double contact_threshold = 5.0;

  /// The ground is slightly soft. Each step removes the fraction `erp` of the penetration, but no
  /// faster than the correcting speed [m/s], and a force F presses in at the speed `cfm` · F, with
  /// cfm in m/(N s). A foot loaded with F so stands h · cfm/erp · F deep: 5 µm at 80 N. Harder
  /// ground makes touchdowns kick.
  double contact_erp = 0.3;
  double contact_cfm = 1e-5;
  double contact_correcting_speed = 0.5;

  /// The same for the hinges: how fast they close and how much they give.
  double hinge_erp = 0.4;
  double hinge_cfm = 1e-8;

  /// Where the base starts: turned and shifted in the plane. The terrain's flat pad is about the
  /// origin.
  PlanarPose start;

  /// Height of the lowest foot above the ground at the start [m].
  double start_clearance = 1e-4;

  /// Least height of the base's origin above the ground below it at the start [m]: for a robot that
  /// lies on its belly.
  double start_height = -std::numeric_limits<double>::infinity();

  /// On the terrain, which knows nothing of them: Terrain::height_at() is the ground without.
  std::vector<Block> blocks;

  /// Clamps the base to a test stand: it stays where it starts and the legs hang from it.
  bool base_on_stand = false;
};

/// A robot in a rigid-body world: a Plant with a referee's view.
///
/// Every joint has the same position servo, an implicit spring-damper with feed-forward,
///
///     τ = Kp (q* − q₊) + Kd (q̇* − q̇₊) + τ*,   |τ| ≤ effort limit
///
/// with q*, q̇*, τ* the targets and q₊, q̇₊ the state, all at the end of the physics step; between
/// two writes q* moves on at q̇*. Position targets are kept within the joint's limits, which is the
/// only stop that joints have. Legs may also be driven by velocity or by effort
/// (JointTargets::mode); a joint that comes to its limit then is held there by the position servo.
/// Until the first write() the servos hold the initial joint positions.
///
/// Feet are the spheres at the legs' foot centres. All other shapes touch the ground too, but have
/// no sensor. Links of the robot pass through each other. The ground never ends: see Terrain.
///
/// Deterministic: same model, terrain, parameters, writes and binary give the same bits, whatever
/// else runs in the process. Worlds may run on different threads, each on the one that made it.
class World : public Plant {
 public:
  /// @param q  initial joint positions [rad]. The base is level, the lowest foot just off the
  /// ground
  /// @throws InvalidInput  listing every parameter or link that no world can be made from
  World(const RobotModel& robot, const TerrainSpec& terrain, const WorldParams& params,
        const LegArray<LegJoints>& q);
  ~World() override;
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Joint positions now; contact if it was felt in any physics step since the last write() began.
  /// Nothing is felt before the first write(). Simulated time does not wait: always `fresh`, or
  /// `closed` once the physics has blown up.
  PlantStatus read(Measurement& measurement) override;

  /// Sets the servos' targets and advances the world by one control period. Targets that are not
  /// finite close the plant.
  /// @pre targets for as many legs as the robot has
  void write(const JointTargets& targets) override;

  /// Somebody pushes the base: a force at the base link's centre of mass [N], world axes, for so
  /// long from now on [s], to whole physics steps. A later push takes the place of an earlier one.
  void push(const Vector3& force_W, double seconds);

  /// For the referee alone.
  [[nodiscard]] const GroundTruth& truth() const;

  /// For the referee alone: what each servo did in the last physics step [N m].
  [[nodiscard]] const LegArray<LegJoints>& efforts() const;

  [[nodiscard]] const Terrain& terrain() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hexagait::sim3d
