// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/urdf/detail/meshes.hpp>
#include <hexagait/urdf/detail/robot_tree.hpp>
#include <hexagait/urdf/urdf.hpp>

namespace hexagait {

/// Points that stand for a shape: corners, points of rims, vertices [m, frame of the link]; none of a
/// mesh that can't be read.
[[nodiscard]] std::vector<Vector3> outline(const LinkParts::Solid& solid, Meshes& meshes);

/// Where a chain's foot is, in the frame L of its last link.
struct FoundFoot {
  enum class Rule : std::uint8_t {
    given,      ///< by --foot
    sphere,     ///< the outermost collision sphere of the last link
    end_shape,  ///< the middle of the shape of a link that is fixed to it
    end_link,   ///< the origin of such a link without a shape
    far_end,    ///< the outermost point of its collisions, else of its visuals
    mass,       ///< twice as far as its centre of mass
  };
  Rule rule = Rule::sphere;
  /// The centre; of the rules end_link, far_end and mass the point that touches the ground [m].
  Vector3 p_LF = Vector3::Zero();
  std::optional<double> radius;      ///< of the rules sphere and end_shape [m]
  const FileShape* shape = nullptr;  ///< that it is taken from
  int line = 0;
};

/// The first rule that applies. A sphere or an end link counts if it is not much nearer to the last
/// joint than the outermost point of all.
[[nodiscard]] std::optional<FoundFoot> find_foot(const UrdfFile& file, const SerialChain& chain,
                                                 Meshes& meshes, const UrdfOptions& options);

/// From the first axis to the last and on to a point [m].
[[nodiscard]] double length_of(const SerialChain& chain, const Vector3& p_BF0);

}  // namespace hexagait
