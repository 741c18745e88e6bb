// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/model/robot_model.hpp>
#include <hexagait/sim3d/detail/ode.hpp>
#include <hexagait/sim3d/detail/servos.hpp>
#include <hexagait/sim3d/world.hpp>
#include <vector>

namespace hexagait::sim3d::detail {

/// A shape of the robot that can touch the ground.
struct RobotShape {
  static constexpr LegId kNotAFoot = -1;

  GeomPtr geom;
  dBodyID body = nullptr;
  LegId foot_of = kNotAFoot;  ///< the leg whose foot this is
  bool of_base = false;       ///< belongs to the base link
};

/// Is this shape of the last link the leg's foot: a sphere about the foot's centre?
[[nodiscard]] bool is_foot(const Shape& shape, const LegModel& leg);

/// The robot as ODE bodies, hinges with servos, and shapes. Bodies and hinges belong to the ODE
/// world, which must outlive this.
class Robot {
 public:
  /// Builds the robot at X_WB with joint positions q.
  Robot(dWorldID world, const RobotModel& model, const WorldParams& params, const Pose& X_WB,
        const LegArray<LegJoints>& q);

  [[nodiscard]] Servos& servos() { return servos_; }
  [[nodiscard]] const Servos& servos() const { return servos_; }

  /// Takes one physics step of the world.
  /// @param to_come  time from the start of the step to the end of the control period [s]
  /// @param force_W  external force at the base's centre of mass, world axes [N]
  void step(double to_come, const Vector3& force_W);

  /// Takes a leg off: it stays where it is, is not moved any more and touches nothing.
  void cut(LegId leg);

  [[nodiscard]] const std::vector<RobotShape>& shapes() const { return shapes_; }
  [[nodiscard]] Pose X_WB() const;
  [[nodiscard]] Twist V_WB() const;             ///< axes of the base
  [[nodiscard]] Vector3 p_WF(LegId leg) const;  ///< foot centre [m]
  [[nodiscard]] bool is_sane() const;           ///< all positions and velocities are within bounds

 private:
  struct Link {
    dBodyID body = nullptr;
    Vector3 p_LM = Vector3::Zero();  // centre of mass, the origin of ODE's body
  };
  struct BodyState {
    Vector3 p, v, w;
    std::array<dReal, 4> rotation;
  };

  Link make_link(const LinkModel& model, const Pose& X_WB);
  void make_shapes(const LinkModel& model, const Link& link);
  void make_leg(LegId leg, const Pose& X_WB);
  void move_leg_to(LegId leg, const Pose& X_WB, const LegJoints& q);
  void step_world(const Vector3& force_W);
  void save_bodies();
  void restore_bodies();

  dWorldID world_;
  double h_;
  RobotModel model_;
  Servos servos_;
  Link base_;
  LegArray<JointArray<Link>> links_;
  std::vector<RobotShape> shapes_;
  std::vector<dBodyID> bodies_;
  std::vector<BodyState> saved_;  // of bodies_, before the step
};

}  // namespace hexagait::sim3d::detail
