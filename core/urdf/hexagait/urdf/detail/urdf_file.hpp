// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/geometry.hpp>
#include <hexagait/text/violations.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hexagait {

// A URDF as it is written, before anyone asks what it means: plain values, each with its line.

struct FileInertial {
  int line = 0;
  Pose X_LM;
  std::optional<double> mass;        ///< [kg]
  std::optional<Matrix3> inertia_M;  ///< about the centre of mass, axes of M [kg m²]
};

/// A collision or a visual.
struct FileShape {
  enum class Kind : std::uint8_t { box, cylinder, sphere, mesh };
  int line = 0;
  Kind kind = Kind::box;
  Vector3 size = Vector3::Zero();  ///< as in Shape [m]; of a mesh its scale
  std::string mesh;                ///< file name as it is written
  Pose X_LS;
};

struct FileLink {
  std::string name;
  int line = 0;
  std::optional<FileInertial> inertial;
  std::vector<FileShape> collisions, visuals;
  int parent_joint = -1;          ///< index into the joints; −1: a root
  std::vector<int> child_joints;  ///< in the order of the file
};

struct FileJoint {
  enum class Type : std::uint8_t { fixed, revolute, continuous, prismatic, floating, planar };
  std::string name;
  int line = 0;
  Type type = Type::fixed;
  int parent = -1, child = -1;  ///< indices into the links
  Pose X_PJ;
  Vector3 axis = Vector3::UnitX();
  std::optional<double> lower, upper, velocity, effort;
  std::string mimics;  ///< the joint that it follows; empty: none

  [[nodiscard]] bool turns() const { return type == Type::revolute || type == Type::continuous; }
};

struct UrdfFile {
  std::string name;
  std::vector<FileLink> links;
  std::vector<FileJoint> joints;
  int root = -1;  ///< index into the links

  [[nodiscard]] const FileLink& link(int i) const { return links[static_cast<std::size_t>(i)]; }
  [[nodiscard]] FileLink& link(int i) { return links[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const FileJoint& joint(int i) const { return joints[static_cast<std::size_t>(i)]; }
};

/// Reads the text of a URDF: a tree of links from one root, all numbers finite, sizes positive.
/// @param violations  receives everything that is wrong, with its line
/// @returns nothing if there is any
[[nodiscard]] std::optional<UrdfFile> read_urdf_file(const std::string& xml,
                                                     Violations& violations);

}  // namespace hexagait
