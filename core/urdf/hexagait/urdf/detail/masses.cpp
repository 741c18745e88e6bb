// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <hexagait/urdf/detail/feet.hpp>
#include <hexagait/urdf/detail/masses.hpp>
#include <hexagait/urdf/detail/symmetry.hpp>

namespace hexagait {
namespace {

constexpr double kLightestRobot = 2.0, kHeaviestRobot = 1000.0;  // [kg/m³] of its size cubed
constexpr double kLightestLink = 1.0, kHeaviestLink = 1e5;       // [kg/m³] of its volume
constexpr double kSlimmest = 0.01, kWidest = 2.0;  // radius of gyration, of the extent
constexpr double kRodToLength = 0.1;               // radius of a rod, of its length
constexpr double kOnlyABall = 0.05;                // shapes of less than this share of the rod

/// A link, and what it is made of if it is filled evenly.
struct Filled {
  LinkModel* link = nullptr;
  const LinkParts* parts = nullptr;
  double volume = 0.0;               ///< [m³]
  Vector3 p_LM = Vector3::Zero();    ///< centre [m]
  Matrix3 second = Matrix3::Zero();  ///< inertia about the centre at 1 kg/m³ [m⁵]
  double extent = 0.0;               ///< from the joint to the outermost point [m]
};

double volume_of(const Shape& shape) {
  const double r = shape.size.x();
  switch (shape.kind) {
    case Shape::Kind::box:
      return shape.size.prod();
    case Shape::Kind::cylinder:
      return std::numbers::pi * r * r * shape.size.y();
    case Shape::Kind::sphere:
      return 4.0 / 3.0 * std::numbers::pi * r * r * r;
  }
  return 0.0;
}

/// Inertia about the shape's centre at 1 kg, axes of the shape [m²].
Vector3 gyration(const Shape& shape) {
  const Vector3 s = shape.size.cwiseAbs2();
  switch (shape.kind) {
    case Shape::Kind::box:
      return Vector3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()) / 12.0;
    case Shape::Kind::cylinder: {
      const double across = (3.0 * s.x() + s.y()) / 12.0;
      return {across, across, 0.5 * s.x()};
    }
    case Shape::Kind::sphere:
      return Vector3::Constant(0.4 * s.x());
  }
  return Vector3::Zero();
}

/// Fills a link's shapes, or a rod from its joint to `end` if these are none, or only a foot.
Filled filled(LinkModel& link, const LinkParts& parts, const Vector3& end_L, double shortest) {
  const double length = std::max(end_L.norm(), shortest);
  const Shape along = rod(end_L, kRodToLength * length, length);
  double volume = 0.0;
  for (const Shape& shape : link.shapes) volume += volume_of(shape);
  const std::vector<Shape> solids =
      volume < kOnlyABall * volume_of(along) ? std::vector<Shape>{along} : link.shapes;

  Filled result{&link, &parts};
  Vector3 moment = Vector3::Zero();
  Matrix3 about_L = Matrix3::Zero();
  for (const Shape& shape : solids) {
    const double v = volume_of(shape);
    result.volume += v;
    moment += v * shape.X_LS.p;
    about_L +=
        shape.X_LS.R * Matrix3((v * gyration(shape)).asDiagonal()) * shape.X_LS.R.transpose() +
        point_mass_inertia(v, shape.X_LS.p);
    result.extent = std::max(result.extent, shape.X_LS.p.norm() + shape.size.maxCoeff());
  }
  result.p_LM = moment / result.volume;
  result.second = about_L - point_mass_inertia(result.volume, result.p_LM);
  return result;
}

std::vector<Filled> all_filled(RobotTree& tree) {
  std::vector<Filled> all = {filled(tree.base, tree.base_parts, Vector3::Zero(), 0.0)};
  for (SerialChain& chain : tree.chains) {
    const double share =
        length_of(chain, chain.foot->p_BF0) / static_cast<double>(chain.links.size());
    for (std::size_t i = 0; i < chain.links.size(); ++i) {
      const Vector3 end_B =
          i + 1 < chain.links.size() ? chain.joints[i + 1].p_BJ0 : chain.foot->p_BF0;
      LinkModel& link = chain.links[i];
      all.push_back(filled(link, chain.parts[i], link.X_BL0.inverse() * end_B, share));
    }
  }
  return all;
}

Substitution about(const UrdfFile& file, const Filled& filled, const char* what,
                   const std::string& found) {
  const FileLink& link = filled.parts->link_in(file);
  return {Origin::substituted, "link " + link.name, link.line, what, found, "", "--density"};
}

void replace_mass(const UrdfFile& file, const UrdfOptions& options, const Filled& filled,
                  const std::string& found, std::vector<Substitution>& substitutions) {
  LinkModel& link = *filled.link;
  link.mass = options.density * filled.volume;
  link.p_LM = filled.p_LM;
  link.inertia_M_L = options.density * filled.second;
  Substitution substitution = about(file, filled, "mass", found);
  substitution.used = in_words(link.mass) + " kg, of " + in_words(options.density) + " kg/m³";
  substitutions.push_back(std::move(substitution));
}

/// What is wrong with a link's mass; empty: nothing.
std::string mass_problem(const Filled& filled) {
  const double mass = filled.link->mass;
  if (!(mass > 0.0)) return "none";
  const double density = mass / filled.volume;
  if (kLightestLink <= density && density <= kHeaviestLink) return "";
  return in_words(mass) + " kg, " + in_words(density) + " kg/m³ of its volume";
}

/// What is wrong with a link's inertia; empty: nothing.
std::string inertia_problem(const Filled& filled) {
  if (!filled.parts->has_inertia) return "none";
  const auto moments =
      Eigen::SelfAdjointEigenSolver<Matrix3>(filled.link->inertia_M_L).eigenvalues();
  if (!(moments.minCoeff() > 0.0))
    return "smallest principal moment " + in_words(moments.minCoeff()) + " kg m²";
  const double radius = std::sqrt(moments.maxCoeff() / filled.link->mass);
  if (kSlimmest * filled.extent <= radius && radius <= kWidest * filled.extent) return "";
  return "radius of gyration " + in_words(radius) + " m of a link of " + in_words(filled.extent) +
         " m";
}

void replace_inertia(const UrdfFile& file, const Filled& filled, const std::string& found,
                     std::vector<Substitution>& substitutions) {
  LinkModel& link = *filled.link;
  link.inertia_M_L = link.mass / filled.volume * filled.second;
  Substitution substitution = about(file, filled, "inertia", found);
  substitution.used = "that of its shape, filled evenly";
  substitution.option.clear();
  substitutions.push_back(std::move(substitution));
}

void scale_to(double mass, const std::vector<Filled>& links, double total,
              std::vector<Substitution>& substitutions) {
  for (const Filled& filled : links) {
    filled.link->mass *= mass / total;
    filled.link->inertia_M_L *= mass / total;
  }
  substitutions.push_back({Origin::given, "robot", 0, "mass", in_words(total) + " kg",
                           in_words(mass) + " kg", "--mass"});
}

double total_mass(const std::vector<Filled>& links) {
  double total = 0.0;
  for (const Filled& filled : links) total += filled.link->mass;
  return total;
}

}  // namespace

double size_of(const RobotTree& tree) {
  std::vector<Vector2> hips;
  std::vector<double> lengths;
  for (const SerialChain& chain : tree.chains) {
    hips.emplace_back(chain.joints.front().p_BJ0.head<2>());
    lengths.push_back(length_of(chain, chain.foot->p_BF0));
  }
  std::ranges::sort(lengths);
  return layout_radius(hips) + lengths[lengths.size() / 2];
}

void settle_masses(const UrdfFile& file, const UrdfOptions& options, RobotTree& tree,
                   std::vector<Substitution>& substitutions) {
  const std::vector<Filled> links = all_filled(tree);
  const double size = size_of(tree), density = total_mass(links) / (size * size * size);
  const bool any_mass = density > 0.0;
  const bool plausible = kLightestRobot <= density && density <= kHeaviestRobot;
  for (const Filled& filled : links) {
    std::string problem = mass_problem(filled);
    if (problem.empty() && any_mass && !plausible)
      problem = in_words(filled.link->mass) + " kg, in a robot of " + in_words(size) + " m with " +
                in_words(density) + " kg/m³";
    if (!problem.empty())
      replace_mass(file, options, filled, problem, substitutions);
    else if (problem = inertia_problem(filled); !problem.empty())
      replace_inertia(file, filled, problem, substitutions);
  }
  if (options.mass) scale_to(*options.mass, links, total_mass(links), substitutions);
}

}  // namespace hexagait
