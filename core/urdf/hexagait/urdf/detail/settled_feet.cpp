// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/urdf/detail/settled_feet.hpp>

namespace hexagait {
namespace {

using Rule = FoundFoot::Rule;
using Feet = std::vector<std::optional<FoundFoot>>;

constexpr double kSameRadius = 1e-6;     // [m]
constexpr double kRadiusByRule = 0.025;  // of the leg's length
constexpr double kRodToFoot = 0.7;       // radius of a rod, of the foot's
constexpr double kSamePlace = 1e-9;      // [m]

const FileLink& last_link(const UrdfFile& file, const SerialChain& chain) {
  return chain.parts.back().link_in(file);
}

void refuse_missing(const UrdfFile& file, const RobotTree& tree, const Feet& feet,
                    Violations& violations) {
  for (std::size_t i = 0; i < feet.size(); ++i) {
    if (feet[i]) continue;
    const FileLink& link = last_link(file, tree.chains[i]);
    violations.add(link.line, "link " + link.name,
                   "has no shape, no end link and no centre of mass that tell where its foot is; "
                   "give its centre in the frame of the link: --foot " +
                       link.name + "=X,Y,Z");
  }
}

/// The radius of those found by a rule: least and greatest.
struct Radii {
  double least = 1e300, greatest = 0.0;
  std::size_t first = 0, last = 0;  ///< whose they are
};

Radii radii(const Feet& feet, Rule rule) {
  Radii radii;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    if (!feet[i] || feet[i]->rule != rule || !feet[i]->radius) continue;
    const double radius = *feet[i]->radius;
    if (radius < radii.least) radii.least = radius, radii.first = i;
    if (radius > radii.greatest) radii.greatest = radius, radii.last = i;
  }
  return radii;
}

double common_radius(const UrdfFile& file, const UrdfOptions& options, const RobotTree& tree,
                     const Feet& feet, Violations& violations) {
  if (options.foot_radius) return *options.foot_radius;
  const Radii spheres = radii(feet, Rule::sphere), shapes = radii(feet, Rule::end_shape);
  if (spheres.greatest - spheres.least > kSameRadius)
    violations.add(feet[spheres.last]->line, "robot",
                   "foot radii range from " + in_words(spheres.least) + " m (" +
                       last_link(file, tree.chains[spheres.first]).name + ") to " +
                       in_words(spheres.greatest) + " m (" +
                       last_link(file, tree.chains[spheres.last]).name +
                       "); all feet must be alike (--foot-radius)");
  if (spheres.greatest > 0.0) return spheres.least;
  if (shapes.greatest > 0.0) return shapes.least;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < feet.size(); ++i)
    if (feet[i]) {
      const SerialChain& chain = tree.chains[i];
      lengths.push_back(length_of(chain, chain.links.back().X_BL0 * feet[i]->p_LF));
    }
  std::ranges::sort(lengths);
  return lengths.empty() ? 0.0 : kRadiusByRule * lengths[lengths.size() / 2];
}

/// Replaces the shape that the foot is taken from by a ball.
void put_ball(LinkModel& link, const FoundFoot& foot, const Vector3& p_LF, double radius,
              const LinkParts& parts) {
  for (const LinkParts::Solid& solid : parts.collisions) {
    if (solid.shape != foot.shape) continue;
    std::erase_if(link.shapes, [&](const Shape& shape) {
      return (shape.X_LS.p - solid.X_LS.p).norm() < kSamePlace &&
             (shape.size - solid.shape->size).norm() < kSamePlace;
    });
  }
  if (link.shapes.empty() && p_LF.norm() > radius)
    link.shapes.push_back(rod(p_LF, kRodToFoot * radius, p_LF.norm()));
  link.shapes.push_back({Shape::Kind::sphere, {radius, 0.0, 0.0}, {Matrix3::Identity(), p_LF}});
}

/// A foot that is found by a rule, and stands a little off the plane in which two parallel joints move
/// it, is meant to be in it.
Vector3 in_plane(const SerialChain& chain, const Vector3& p_BF0, double radius) {
  constexpr double kParallel = 1e-4;  // [rad]
  if (chain.joints.size() != 3) return p_BF0;
  const Vector3 &yaw = chain.joints[0].axis_B0, &hip = chain.joints[1].axis_B0,
                &knee = chain.joints[2].axis_B0;
  const double off = hip.dot(p_BF0 - chain.joints[0].p_BJ0);
  const bool planar = hip.cross(knee).norm() < kParallel && std::abs(hip.dot(yaw)) < kParallel;
  return planar && std::abs(off) < radius ? Vector3(p_BF0 - off * hip) : p_BF0;
}

std::string rule_in_words(const FoundFoot& foot) {
  switch (foot.rule) {
    case Rule::given:
      return "at the place given";
    case Rule::sphere:
      return "its collision sphere";
    case Rule::end_shape:
      return "the middle of the shape at its end";
    case Rule::end_link:
      return "the origin of the link fixed to its end";
    case Rule::far_end:
      return "the outermost point of its shapes";
    case Rule::mass:
      return "twice as far as its centre of mass";
  }
  return "";
}

}  // namespace

void settle_feet(const UrdfFile& file, const UrdfOptions& options, const Feet& feet,
                 RobotTree& tree, Violations& violations,
                 std::vector<Substitution>& substitutions) {
  refuse_missing(file, tree, feet, violations);
  const double radius = common_radius(file, options, tree, feet, violations);
  for (std::size_t i = 0; i < feet.size(); ++i) {
    if (!feet[i]) continue;
    SerialChain& chain = tree.chains[i];
    LinkModel& tip = chain.links.back();
    Vector3 p_LF = feet[i]->p_LF;
    const Rule rule = feet[i]->rule;
    // What touches the ground is a radius outside of the centre.
    if (rule == Rule::end_link || rule == Rule::far_end || rule == Rule::mass)
      p_LF -= radius * p_LF.normalized();
    chain.foot = {tip.X_BL0 * p_LF, radius};
    if (rule == Rule::sphere && *feet[i]->radius == radius) continue;

    if (rule != Rule::sphere && rule != Rule::given) {
      chain.foot->p_BF0 = in_plane(chain, chain.foot->p_BF0, radius);
      p_LF = tip.X_BL0.inverse() * chain.foot->p_BF0;
    }
    put_ball(tip, *feet[i], p_LF, radius, chain.parts.back());
    substitutions.push_back(
        {rule == Rule::given || options.foot_radius ? Origin::given : Origin::derived,
         "link " + tip.name, feet[i]->line, "foot",
         rule == Rule::sphere ? "another radius" : "no collision sphere",
         rule_in_words(*feet[i]) + ", radius " + in_words(radius) + " m",
         rule == Rule::sphere ? "--foot-radius" : "--foot"});
  }
}

}  // namespace hexagait
