// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/text/violations.hpp>
#include <hexagait/urdf/detail/body_frame.hpp>
#include <hexagait/urdf/detail/feet.hpp>
#include <hexagait/urdf/detail/rounded.hpp>
#include <hexagait/urdf/detail/symmetry.hpp>

namespace hexagait {
namespace {

constexpr double kMuchFlatter = 3.0;
constexpr double kOffPlane = 0.02, kOffMiddle = 0.25;  // of the layout's radius
constexpr double kOffHeight = 0.5;                     // of a leg's length

std::string point_in_words(const Vector3& p) {
  std::string text = "(";
  return text.append(in_words(p.x()))
      .append(", ")
      .append(in_words(p.y()))
      .append(", ")
      .append(in_words(p.z()))
      .append(")");
}

struct Bounds {
  Vector3 least = Vector3::Constant(1e300), greatest = Vector3::Constant(-1e300);
  void include(const Vector3& p) {
    least = least.cwiseMin(p);
    greatest = greatest.cwiseMax(p);
  }
  void include(const std::vector<Vector3>& points) {
    for (const Vector3& p : points) include(p);
  }
  [[nodiscard]] bool empty() const { return least.x() > greatest.x(); }
  [[nodiscard]] Vector3 size() const { return greatest - least; }
  [[nodiscard]] Vector3 middle() const { return 0.5 * (least + greatest); }
};

Bounds hips_of(const RobotTree& tree) {
  Bounds bounds;
  for (const SerialChain& chain : tree.chains) bounds.include(chain.joints.front().p_BJ0);
  return bounds;
}

std::string axis_name(const Vector3& axis) {
  Eigen::Index i = 0;
  axis.cwiseAbs().maxCoeff(&i);
  std::string name(1, axis[i] < 0.0 ? '-' : '+');
  return name.append(1, "xyz"[i]);
}

}  // namespace

Matrix3 upright(const RobotTree& tree, const UrdfOptions& options,
                std::vector<Substitution>& substitutions) {
  Vector3 up = Vector3::UnitZ();
  const Vector3 extent = hips_of(tree).size();
  Eigen::Index flattest = 0;
  extent.minCoeff(&flattest);
  if (options.up) {
    up = *options.up;
  } else if (extent.z() > kMuchFlatter * extent[flattest] && extent.z() > 1e-3) {
    double hanging = 0.0;
    for (const SerialChain& chain : tree.chains)
      hanging += chain.foot->p_BF0[flattest] - chain.joints.front().p_BJ0[flattest];
    up = Vector3::Unit(flattest) * (hanging > 0.0 ? -1.0 : 1.0);
  }
  if (up == Vector3::UnitZ()) return Matrix3::Identity();
  substitutions.push_back({options.up ? Origin::given : Origin::derived, "robot", 0, "up", "+z",
                           axis_name(up).append(" of the file"), "--up"});
  const Vector3 forward = std::abs(up.x()) > 0.5 ? Vector3(0, 0, 1) : Vector3(1, 0, 0);
  Matrix3 R_RB;
  R_RB << forward, up.cross(forward), up;
  return R_RB.transpose();
}

Pose body_frame(const RobotTree& tree, const UrdfOptions& options,
                std::vector<Substitution>& substitutions) {
  std::vector<Vector2> hips;
  double length = 0.0;
  for (const SerialChain& chain : tree.chains) {
    hips.emplace_back(chain.joints.front().p_BJ0.head<2>());
    length = std::max(length, length_of(chain, chain.foot->p_BF0));
  }
  Symmetry symmetry = options.front ? symmetry_along(hips, *options.front) : find_symmetry(hips);
  const bool whole = symmetry.num_paired() == static_cast<int>(hips.size());
  if (!whole && !options.front) symmetry = symmetry_along(hips, 0.0);
  if (options.front || symmetry.front != 0.0 || !whole)
    substitutions.push_back({options.front ? Origin::given : Origin::derived, "robot", 0, "front",
                             "0°",
                             degrees(symmetry.front) + " from x of the file" +
                                 (whole ? options.front ? "" : ", the long axis of mirror symmetry"
                                  : options.front ? ""
                                                  : "; no plane mirrors all hips"),
                             "--front"});

  const double radius = layout_radius(hips);
  const Vector2 along = unit_vector(symmetry.front), left = perpendicular(along);
  const Vector3 middle = hips_of(tree).middle();
  const double forward = along.dot(middle.head<2>()), sideways = symmetry.offset;
  Vector3 p_RB = Vector3::Zero();
  if (symmetry.num_paired() > 0 && std::abs(sideways) > kOffPlane * radius)
    p_RB.head<2>() += sideways * left;
  if (std::abs(forward) > kOffMiddle * radius) p_RB.head<2>() += forward * along;
  if (std::abs(middle.z()) > kOffHeight * length) p_RB.z() = middle.z();
  if (!p_RB.isZero())
    substitutions.push_back({Origin::derived, "robot", 0, "origin of the body", "(0, 0, 0)",
                             point_in_words(p_RB) + " m in the file's root frame", ""});
  const Matrix3 R_RB = symmetry.front == 0.0 ? Matrix3::Identity() : rotation_z(symmetry.front);
  return Pose{R_RB, p_RB}.inverse();
}

void settle_body_shape(const UrdfFile& file, Meshes& meshes, RobotTree& tree,
                       std::vector<Substitution>& substitutions) {
  if (!tree.base.shapes.empty()) return;
  constexpr double kThickness = 0.15;  // of the hips' longer extent
  Bounds bounds;
  std::string of = "meshes";
  for (const LinkParts::Solid& solid : tree.base_parts.collisions)
    bounds.include(outline(solid, meshes));
  if (bounds.empty()) {
    of = "visuals";
    for (const LinkParts::Solid& solid : tree.base_parts.visuals)
      bounds.include(outline(solid, meshes));
  }
  if (bounds.empty()) {
    of = "hips";
    bounds = hips_of(tree);
    const double half = 0.5 * kThickness * bounds.size().head<2>().maxCoeff();
    bounds.least.z() -= half;
    bounds.greatest.z() += half;
  }
  const Vector3 size = bounds.size().cwiseMax(1e-3);
  tree.base.shapes.push_back({Shape::Kind::box, size, {Matrix3::Identity(), bounds.middle()}});
  const FileLink& link = tree.base_parts.link_in(file);
  substitutions.push_back({Origin::substituted, "link " + link.name, link.line, "shape of the body",
                           "none",
                           "the bounding box of its " + of + ", " + in_words(size.x()) + " × " +
                               in_words(size.y()) + " × " + in_words(size.z()) + " m",
                           ""});
}

}  // namespace hexagait
