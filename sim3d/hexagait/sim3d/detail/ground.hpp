// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/sim3d/detail/ode.hpp>
#include <hexagait/sim3d/world.hpp>
#include <span>
#include <vector>

namespace hexagait::sim3d::detail {

/// Collision of ODE's shapes with the terrain.
///
/// The terrain is not part of ODE's world: for each query, a plane, box or heightfield patch is
/// placed under the shape. So the ground is unbounded and costs nothing away from the robot. Blocks
/// are fixed.
class Ground {
 public:
  explicit Ground(const Terrain& terrain, std::span<const Block> blocks = {});
  Ground(const Ground&) = delete;
  Ground& operator=(const Ground&) = delete;

  /// Contacts of `geom` with the ground, normals pointing out of the ground.
  /// @param contacts  receives them; at most kContactsPerPair for each box, patch or block touched
  /// @returns their number
  int collide(dGeomID geom, std::span<dContactGeom> contacts);

  /// How far it is to the ground, or to a block, along a ray.
  /// @param direction  of length 1
  /// @returns [m]; ∞ if it is farther than `longest`
  double range(const Vector3& from, const Vector3& direction, double longest);

  [[nodiscard]] const Terrain& terrain() const { return terrain_; }

  static constexpr int kContactsPerPair = 4;

 private:
  using Aabb = std::array<dReal, 6>;  // min x, max x, min y, …

  [[nodiscard]] double box_height() const;
  void create_heightfield();
  int collide_terrain(dGeomID geom, std::span<dContactGeom> contacts);
  int collide_cells(dGeomID geom, const Aabb& aabb, std::span<dContactGeom> contacts);
  int collide_patch(dGeomID geom, const Aabb& aabb, std::span<dContactGeom> contacts);
  int collide_blocks(dGeomID geom, std::span<dContactGeom> contacts);
  static dReal patch_height(void* ground, int column, int row);

  Terrain terrain_;
  int patch_a_ = 0, patch_b_ = 0;  // terrain sample at the heightfield patch's lowest corner
  HeightfieldDataPtr heightfield_data_;
  GeomPtr geom_;
  GeomPtr ray_;
  std::vector<GeomPtr> blocks_;
};

}  // namespace hexagait::sim3d::detail
