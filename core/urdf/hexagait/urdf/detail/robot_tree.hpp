// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <hexagait/urdf/detail/urdf_file.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <optional>

namespace hexagait {

/// A revolute joint where it stands when all joints are zero.
struct TreeJoint {
  std::string name;
  Vector3 p_BJ0 = Vector3::Zero();     ///< a point on its axis [m]
  Vector3 axis_B0 = Vector3::UnitZ();  ///< unit vector
  JointLimits limits;
  int index = -1;  ///< of the file's joint
};

/// What a link with all that is fixed to it consists of in the file; frames in that link's L.
struct LinkParts {
  struct Part {
    int link = -1;  ///< index into the file's
    Pose X_LP;
    bool is_end = false;  ///< nothing else hangs from it
  };
  struct Solid {
    int link = -1;
    const FileShape* shape = nullptr;
    Pose X_LS;
  };
  std::vector<Part> parts;  ///< the link itself first
  std::vector<Solid> collisions, visuals;
  bool has_inertia = false;  ///< some part of it says what its inertia is

  /// The link itself, in the file.
  [[nodiscard]] const FileLink& link_in(const UrdfFile& file) const {
    return file.link(parts.front().link);
  }
};

/// Links one behind the other, hanging from the base: joints[i] moves links[i].
struct SerialChain {
  std::vector<TreeJoint> joints;
  std::vector<LinkModel> links;
  struct Foot {
    Vector3 p_BF0 = Vector3::Zero();  ///< centre, joints at zero [m]
    double radius = 0.0;              ///< [m]
  };
  std::optional<Foot> foot;
  std::vector<LinkParts> parts;  ///< of each link
};

/// A robot as its URDF describes it: a base and chains. All else is fixed to the link it hangs from.
struct RobotTree {
  LinkModel base;
  LinkParts base_parts;
  std::vector<SerialChain> chains;
};

/// Joints one behind the other, from the body outwards: indices into the file's.
using JointChain = std::vector<int>;

/// The tree in which the joints of the chains move, and all others are held at zero. Frames are those
/// of the file's root. Links keep their masses, be they zero; meshes are only in the parts; joints
/// have the ranges of range_of(), and speeds and efforts of 0 where the file says nothing. Feet are
/// not looked for.
[[nodiscard]] RobotTree assemble(const UrdfFile& file, const std::vector<JointChain>& chains,
                                 const UrdfOptions& options);

/// Expresses a tree in another frame. The base's own frame becomes that frame.
void move(RobotTree& tree, const Pose& X_BR);

/// A cylinder about the way from the origin of a link to a point of it.
[[nodiscard]] Shape rod(const Vector3& end_L, double radius, double length);

/// Inertia of a point mass about the origin [kg m²].
[[nodiscard]] Matrix3 point_mass_inertia(double mass, const Vector3& p);

}  // namespace hexagait
