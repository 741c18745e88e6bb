// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/urdf/detail/feet.hpp>

namespace hexagait {
namespace {

constexpr double kOutermost = 0.8;    // a foot is at least so far out, of the outermost point
constexpr double kSmallShape = 0.35;  // extent of the shape of a foot, of its distance
constexpr double kAboutFarthest = 0.97;
constexpr double kStump =
    0.05;  // a last link that is shorter than this share of the leg has no end

struct Farthest {
  Vector3 p_L = Vector3::Zero();
  const LinkParts::Solid* solid = nullptr;
};

/// The middle of what is about farthest of some points.
Vector3 tip_of(const std::vector<Vector3>& points) {
  double farthest = 0.0;
  for (const Vector3& p : points) farthest = std::max(farthest, p.norm());
  Vector3 sum = Vector3::Zero();
  for (const Vector3& p : points)
    if (p.norm() >= kAboutFarthest * farthest) sum += p;
  return sum.norm() > 0.0 ? Vector3(farthest * sum.normalized()) : sum;
}

Farthest farthest(const std::vector<LinkParts::Solid>& solids, Meshes& meshes) {
  Farthest best;
  for (const LinkParts::Solid& solid : solids) {
    const Vector3 tip = tip_of(outline(solid, meshes));
    if (tip.norm() > best.p_L.norm()) best = {tip, &solid};
  }
  return best;
}

std::optional<FoundFoot> given_foot(const UrdfFile& file, const LinkParts& parts,
                                    const UrdfOptions& options) {
  for (const LinkParts::Part& part : parts.parts) {
    const FileLink& link = file.link(part.link);
    const auto given = options.feet.find(link.name);
    if (given != options.feet.end())
      return FoundFoot{FoundFoot::Rule::given, part.X_LP * given->second, {}, nullptr, link.line};
  }
  return {};
}

std::optional<FoundFoot> sphere_foot(const LinkParts& parts, double outermost) {
  std::optional<FoundFoot> best;
  for (const LinkParts::Solid& solid : parts.collisions) {
    if (solid.shape->kind != FileShape::Kind::sphere) continue;
    const Vector3& p = solid.X_LS.p;
    const double radius = solid.shape->size.x();
    if (best && p.norm() <= best->p_LF.norm()) continue;
    if (p.norm() + 2.0 * radius < outermost) continue;
    best = FoundFoot{FoundFoot::Rule::sphere, p, radius, solid.shape, solid.shape->line};
  }
  return best;
}

/// The middle and half the least extent of the shape of one link, if it is small.
std::optional<FoundFoot> end_shape(const LinkParts& parts, int link, Meshes& meshes) {
  for (const auto* solids : {&parts.collisions, &parts.visuals})
    for (const LinkParts::Solid& solid : *solids) {
      if (solid.link != link) continue;
      const FileShape& shape = *solid.shape;
      Vector3 least = Vector3::Zero(), greatest = Vector3::Zero();
      if (shape.kind == FileShape::Kind::mesh) {
        const std::vector<Vector3> vertices = meshes.vertices(shape);
        if (vertices.empty()) continue;
        least = greatest = vertices.front();
        for (const Vector3& v : vertices)
          least = least.cwiseMin(v), greatest = greatest.cwiseMax(v);
      } else if (shape.kind == FileShape::Kind::box) {
        greatest = 0.5 * shape.size, least = -greatest;
      } else {
        const double r = shape.size.x();
        greatest << r, r, shape.kind == FileShape::Kind::sphere ? r : 0.5 * shape.size.y();
        least = -greatest;
      }
      const Vector3 middle = solid.X_LS * Vector3(0.5 * (least + greatest));
      const Vector3 extent = greatest - least;
      if (extent.maxCoeff() > kSmallShape * middle.norm()) continue;
      return FoundFoot{FoundFoot::Rule::end_shape, middle, 0.5 * extent.minCoeff(), &shape,
                       shape.line};
    }
  return {};
}

std::optional<FoundFoot> end_link_foot(const UrdfFile& file, const LinkParts& parts,
                                       double outermost, Meshes& meshes) {
  std::optional<FoundFoot> best;
  for (const LinkParts::Part& part : parts.parts) {
    if (!part.is_end || &part == &parts.parts.front()) continue;
    const FileLink& link = file.link(part.link);
    std::optional<FoundFoot> found = end_shape(parts, part.link, meshes);
    const bool is_bare = link.collisions.empty() && link.visuals.empty();
    if (!found && is_bare)
      found = FoundFoot{FoundFoot::Rule::end_link, part.X_LP.p, {}, nullptr, link.line};
    if (!found || found->p_LF.norm() < kOutermost * outermost) continue;
    if (!best || found->p_LF.norm() > best->p_LF.norm()) best = found;
  }
  return best;
}

}  // namespace

std::vector<Vector3> outline(const LinkParts::Solid& solid, Meshes& meshes) {
  const FileShape& shape = *solid.shape;
  const double r = shape.size.x();
  std::vector<Vector3> points;
  if (shape.kind == FileShape::Kind::box)
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 side(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      points.emplace_back(side.cwiseProduct(shape.size));
    }
  if (shape.kind == FileShape::Kind::cylinder)
    for (const double z : {-0.5 * shape.size.y(), 0.5 * shape.size.y()})
      for (const Vector2& rim : {Vector2(r, 0), Vector2(0, r), Vector2(-r, 0), Vector2(0, -r)})
        points.emplace_back(rim.x(), rim.y(), z);
  if (shape.kind == FileShape::Kind::sphere)
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-r, r}) points.emplace_back(sign * Vector3::Unit(axis));
  if (shape.kind == FileShape::Kind::mesh) points = meshes.vertices(shape);
  for (Vector3& point : points) point = solid.X_LS * point;
  return points;
}

std::optional<FoundFoot> find_foot(const UrdfFile& file, const SerialChain& chain, Meshes& meshes,
                                   const UrdfOptions& options) {
  const LinkParts& parts = chain.parts.back();
  if (const auto given = given_foot(file, parts, options)) return given;

  Farthest end = farthest(parts.collisions, meshes);
  if (end.solid == nullptr) end = farthest(parts.visuals, meshes);
  if (const auto foot = sphere_foot(parts, end.p_L.norm())) return foot;

  const LinkModel& tip = chain.links.back();
  const double stump = kStump * length_of(chain, tip.X_BL0.p);
  const auto foot = end_link_foot(file, parts, end.p_L.norm(), meshes);
  if (foot && foot->p_LF.norm() > stump) return foot;
  const int line = parts.link_in(file).line;
  if (end.p_L.norm() > stump)
    return FoundFoot{
        FoundFoot::Rule::far_end, end.p_L, {}, end.solid->shape, end.solid->shape->line};
  if (tip.mass > 0.0 && 2.0 * tip.p_LM.norm() > stump)
    return FoundFoot{FoundFoot::Rule::mass, 2.0 * tip.p_LM, {}, nullptr, line};
  return {};
}

double length_of(const SerialChain& chain, const Vector3& p_BF0) {
  double length = (p_BF0 - chain.joints.back().p_BJ0).norm();
  for (std::size_t i = 1; i < chain.joints.size(); ++i)
    length += (chain.joints[i].p_BJ0 - chain.joints[i - 1].p_BJ0).norm();
  return length;
}

}  // namespace hexagait
