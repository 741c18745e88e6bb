// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/sim3d/detail/ground.hpp>
#include <limits>

namespace hexagait::sim3d::detail {
namespace {

constexpr double kDepth = 1.0;        // of the ground below the lowest level [m]
constexpr int kPatchSamples = 257;    // along an edge of the heightfield patch
constexpr double kRayPiece = 0.25;    // [m]
constexpr double kRayOverlap = 1e-6;  // [m]

double width(const CellAxis& axis, int i) {
  return axis.odd > 0.0 ? axis.edge(i + 1) - axis.edge(i) : axis.even;
}

// The contacts of two shapes, as many as fit.
int collide_pair(dGeomID geom, dGeomID other, std::span<dContactGeom> contacts) {
  const int room = std::min(static_cast<int>(contacts.size()), Ground::kContactsPerPair);
  if (room == 0) return 0;
  return dCollide(geom, other, room, contacts.data(), sizeof(dContactGeom));
}

}  // namespace

Ground::Ground(const Terrain& terrain, std::span<const Block> blocks)
    : terrain_(terrain), ray_(dCreateRay(nullptr, 1.0)) {
  switch (terrain.surface()) {
    case Terrain::Surface::plane:
      geom_.reset(dCreatePlane(nullptr, 0, 0, 1, 0));
      break;
    case Terrain::Surface::cells:
      geom_.reset(dCreateBox(nullptr, width(terrain.x_axis(), 0), width(terrain.y_axis(), 0),
                             box_height()));
      break;
    case Terrain::Surface::samples:
      create_heightfield();
      break;
  }
  for (const Block& block : blocks) {
    blocks_.emplace_back(dCreateBox(nullptr, block.size.x(), block.size.y(), block.size.z()));
    dGeomSetPosition(blocks_.back().get(), block.centre.x(), block.centre.y(), block.centre.z());
  }
}

double Ground::box_height() const { return terrain_.highest() - terrain_.lowest() + kDepth; }

int Ground::collide(dGeomID geom, std::span<dContactGeom> contacts) {
  const int count = collide_terrain(geom, contacts);
  return count + collide_blocks(geom, contacts.subspan(static_cast<std::size_t>(count)));
}

double Ground::range(const Vector3& from, const Vector3& direction, double longest) {
  // In short pieces, each of which is above few cells. They overlap: a ray that began in a box, by
  // rounding, would meet its far side.
  std::array<dContactGeom, 64> contacts;
  for (double begin = 0.0; begin < longest; begin += kRayPiece) {
    const Vector3 p = from + begin * direction;
    dGeomRaySetLength(ray_.get(), std::min(kRayPiece, longest - begin) + kRayOverlap);
    dGeomRaySet(ray_.get(), p.x(), p.y(), p.z(), direction.x(), direction.y(), direction.z());
    const auto count = static_cast<std::size_t>(collide(ray_.get(), contacts));
    if (count == 0) continue;
    const auto met = std::span(contacts).first(count);
    const double range = begin + std::ranges::min_element(met, {}, &dContactGeom::depth)->depth;
    if (range <= longest) return range;
  }
  return std::numeric_limits<double>::infinity();
}

int Ground::collide_terrain(dGeomID geom, std::span<dContactGeom> contacts) {
  // Most shapes are above the highest point of the terrain.
  Aabb aabb;
  dGeomGetAABB(geom, aabb.data());
  if (aabb[4] > terrain_.highest()) return 0;

  switch (terrain_.surface()) {
    case Terrain::Surface::plane:
      return collide_pair(geom, geom_.get(), contacts);
    case Terrain::Surface::cells:
      return collide_cells(geom, aabb, contacts);
    case Terrain::Surface::samples:
      return collide_patch(geom, aabb, contacts);
  }
  return 0;
}

int Ground::collide_blocks(dGeomID geom, std::span<dContactGeom> contacts) {
  int count = 0;
  for (const GeomPtr& block : blocks_)
    count += collide_pair(geom, block.get(), contacts.subspan(static_cast<std::size_t>(count)));
  return count;
}

int Ground::collide_cells(dGeomID geom, const Aabb& aabb, std::span<dContactGeom> contacts) {
  const CellAxis &x = terrain_.x_axis(), &y = terrain_.y_axis();
  const bool unlike = x.odd > 0.0 || y.odd > 0.0;
  const int i_last = x.index(aabb[1]), j_last = y.index(aabb[3]);
  int count = 0;

  // One box, placed in each cell under the shape in turn.
  for (int i = x.index(aabb[0]); i <= i_last; ++i) {
    for (int j = y.index(aabb[2]); j <= j_last; ++j) {
      const double level = terrain_.level(i, j);
      if (aabb[4] > level) continue;
      if (unlike) dGeomBoxSetLengths(geom_.get(), width(x, i), width(y, j), box_height());
      dGeomSetPosition(geom_.get(), x.middle(i), y.middle(j), level - 0.5 * box_height());
      count += collide_pair(geom, geom_.get(), contacts.subspan(static_cast<std::size_t>(count)));
    }
  }
  return count;
}

int Ground::collide_patch(dGeomID geom, const Aabb& aabb, std::span<dContactGeom> contacts) {
  // The patch of samples, centred on the shape.
  const double spacing = terrain_.sample_spacing();
  const auto nearest = [spacing](double x) { return static_cast<int>(std::floor(x / spacing)); };
  patch_a_ = nearest(0.5 * (aabb[0] + aabb[1])) - kPatchSamples / 2;
  patch_b_ = nearest(0.5 * (aabb[2] + aabb[3])) - kPatchSamples / 2;

  const double to_middle = 0.5 + 0.5 * (kPatchSamples - 1);
  dGeomSetPosition(geom_.get(), (patch_a_ + to_middle) * spacing, (patch_b_ + to_middle) * spacing,
                   0.0);
  return collide_pair(geom, geom_.get(), contacts);
}

void Ground::create_heightfield() {
  const double edge = (kPatchSamples - 1) * terrain_.sample_spacing();
  heightfield_data_.reset(dGeomHeightfieldDataCreate());
  dGeomHeightfieldDataBuildCallback(heightfield_data_.get(), this, &Ground::patch_height, edge,
                                    edge, kPatchSamples, kPatchSamples, 1.0, 0.0, kDepth, 0);
  dGeomHeightfieldDataSetBounds(heightfield_data_.get(), terrain_.lowest(), terrain_.highest());

  // ODE's heightfields have y up: turn y to z, and z to −y.
  geom_.reset(dCreateHeightfield(nullptr, heightfield_data_.get(), 1));
  const Matrix3 upright = (Matrix3() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
  dGeomSetRotation(geom_.get(), OdeRotation(upright).m.data());
}

dReal Ground::patch_height(void* ground, int column, int row) {
  const Ground& self = *static_cast<const Ground*>(ground);
  return self.terrain_.sample(self.patch_a_ + column, self.patch_b_ + kPatchSamples - 1 - row);
}

}  // namespace hexagait::sim3d::detail
