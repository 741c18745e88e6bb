// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/sim3d/detail/ground.hpp>
#include <hexagait/sim3d/detail/robot.hpp>
#include <span>

namespace hexagait::sim3d::detail {

/// A contact between a shape of the robot and the ground in one physics step.
struct Touch {
  const RobotShape* shape = nullptr;
  Vector3 p_MP_W;  ///< from the body's centre of mass to the contact point, world axes [m]
  Vector3 normal;  ///< out of the ground
  dJointFeedback feedback;

  /// Normal force of the ground, after the step [N].
  [[nodiscard]] double normal_force() const;

  /// Velocity of the body's material at the contact point along the ground, after the step [m/s].
  [[nodiscard]] Vector3 slip_velocity() const;
};

/// The contacts between robot and ground in the current physics step.
class Contacts {
 public:
  Contacts(dWorldID world, const WorldParams& params);
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;

  /// Replaces the contacts by those of the shapes at their present poses.
  void find(Ground& ground, std::span<const RobotShape> shapes);

  [[nodiscard]] std::span<const Touch> touches() const;

 private:
  // A fallen robot has about 60; contacts beyond this number are ignored.
  static constexpr std::size_t kMostContacts = 128;

  void give_way(const Terrain::Softness& soft, std::size_t contacts);
  void add(const RobotShape& shape, const dContactGeom& place);

  dWorldID world_;
  double h_;         ///< physics step [s]
  double friction_;  ///< where there is no ice
  dSurfaceParameters surface_{};
  JointGroupPtr joints_;
  std::array<Touch, kMostContacts> touches_;
  std::size_t count_ = 0;
};

}  // namespace hexagait::sim3d::detail
