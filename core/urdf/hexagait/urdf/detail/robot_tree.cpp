// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/urdf/detail/joint_limits.hpp>
#include <hexagait/urdf/detail/robot_tree.hpp>

namespace hexagait {
namespace {

/// A link with everything that is fixed to it, while it is summed up.
struct RigidBody {
  LinkModel link;  ///< mass properties are filled in last
  LinkParts parts;
  double mass = 0.0;                    ///< [kg]
  Vector3 moment_L = Vector3::Zero();   ///< Σ m p_LM [kg m]
  Matrix3 inertia_L = Matrix3::Zero();  ///< about L's origin [kg m²]
  struct Departure {
    int joint;
    Pose X_LP;  ///< frame of the joint's parent
  };
  std::vector<Departure> departures;  ///< the moving joints that leave it
};

std::optional<Shape> primitive(const FileShape& solid, const Pose& X_LS) {
  switch (solid.kind) {
    case FileShape::Kind::box:
      return Shape{Shape::Kind::box, solid.size, X_LS};
    case FileShape::Kind::cylinder:
      return Shape{Shape::Kind::cylinder, solid.size, X_LS};
    case FileShape::Kind::sphere:
      return Shape{Shape::Kind::sphere, solid.size, X_LS};
    case FileShape::Kind::mesh:
      break;
  }
  return {};
}

/// Walks the tree from its root.
class Assembly {
 public:
  Assembly(const UrdfFile& file, const std::vector<JointChain>& chains, const UrdfOptions& options)
      : file_(file), options_(options), moves_(file.joints.size(), false) {
    for (const JointChain& chain : chains)
      for (const int joint : chain) moves_[static_cast<std::size_t>(joint)] = true;
  }

  RobotTree tree() {
    RobotTree tree;
    RigidBody base = rigid_body(file_.root, Pose{});
    tree.base = std::move(base.link);
    tree.base_parts = std::move(base.parts);
    // A body is called after its first part that has a mass, not after a root that only holds it.
    const auto has_mass = [&](const LinkParts::Part& part) {
      return link(part.link).inertial.has_value();
    };
    const auto first = std::ranges::find_if(tree.base_parts.parts, has_mass);
    if (first != tree.base_parts.parts.end()) tree.base.name = link(first->link).name;
    for (const RigidBody::Departure& departure : base.departures)
      tree.chains.push_back(chain(departure));
    return tree;
  }

 private:
  const FileJoint& joint(int i) const { return file_.joint(i); }
  const FileLink& link(int i) const { return file_.link(i); }

  SerialChain chain(RigidBody::Departure next);
  RigidBody rigid_body(int link, const Pose& X_BL);
  void merge(int part, const Pose& X_LP, RigidBody& body);
  void merge_inertia(const FileLink& part, const Pose& X_LP, RigidBody& body);
  void merge_shapes(int index, const Pose& X_LP, RigidBody& body);

  const UrdfFile& file_;
  const UrdfOptions& options_;
  std::vector<bool> moves_;  ///< of each joint of the file
};

TreeJoint tree_joint(const FileJoint& joint, int index, const Pose& X_BJ, const JointRange& range) {
  return {joint.name,
          X_BJ.p,
          X_BJ.R * joint.axis.normalized(),
          {range.lower, range.upper, joint.velocity.value_or(0.0), joint.effort.value_or(0.0)},
          index};
}

/// Follows the moving joints outwards. X_LP of the first one is in the body frame.
SerialChain Assembly::chain(RigidBody::Departure next) {
  SerialChain chain;
  Pose X_BP = next.X_LP;
  while (next.joint >= 0) {
    const Pose X_BJ = X_BP * joint(next.joint).X_PJ;
    const JointRange range = range_of(joint(next.joint), chain.joints.empty(), options_);
    chain.joints.push_back(tree_joint(joint(next.joint), next.joint, X_BJ, range));
    RigidBody body = rigid_body(joint(next.joint).child, X_BJ);
    next = body.departures.empty() ? RigidBody::Departure{-1, {}} : body.departures.front();
    if (next.joint >= 0) X_BP = X_BJ * next.X_LP;
    chain.links.push_back(std::move(body.link));
    chain.parts.push_back(std::move(body.parts));
  }
  return chain;
}

RigidBody Assembly::rigid_body(int index, const Pose& X_BL) {
  RigidBody body;
  body.link.name = link(index).name;
  body.link.X_BL0 = X_BL;
  merge(index, Pose{}, body);
  if (body.mass > 0.0) {
    LinkModel& link = body.link;
    link.mass = body.mass;
    link.p_LM = body.moment_L / body.mass;
    link.inertia_M_L = body.inertia_L - point_mass_inertia(body.mass, link.p_LM);
  }
  return body;
}

void Assembly::merge(int index, const Pose& X_LP, RigidBody& body) {
  merge_inertia(link(index), X_LP, body);
  merge_shapes(index, X_LP, body);
  body.parts.parts.push_back({index, X_LP, link(index).child_joints.empty()});
  for (const int next : link(index).child_joints) {
    if (moves_[static_cast<std::size_t>(next)])
      body.departures.push_back({next, X_LP});
    else
      merge(joint(next).child, X_LP * joint(next).X_PJ, body);
  }
}

void Assembly::merge_inertia(const FileLink& part, const Pose& X_LP, RigidBody& body) {
  if (!part.inertial || !(part.inertial->mass.value_or(0.0) > 0.0)) return;
  const double mass = *part.inertial->mass;
  body.parts.has_inertia |= part.inertial->inertia_M.has_value();
  const Pose X_LM = X_LP * part.inertial->X_LM;
  body.mass += mass;
  body.moment_L += mass * X_LM.p;
  body.inertia_L +=
      X_LM.R * part.inertial->inertia_M.value_or(Matrix3::Zero()) * X_LM.R.transpose();
  body.inertia_L += point_mass_inertia(mass, X_LM.p);
}

void Assembly::merge_shapes(int index, const Pose& X_LP, RigidBody& body) {
  for (const FileShape& solid : link(index).collisions) {
    const Pose X_LS = X_LP * solid.X_LS;
    body.parts.collisions.push_back({index, &solid, X_LS});
    if (const std::optional<Shape> shape = primitive(solid, X_LS))
      body.link.shapes.push_back(*shape);
  }
  for (const FileShape& solid : link(index).visuals)
    body.parts.visuals.push_back({index, &solid, X_LP * solid.X_LS});
}

}  // namespace

Shape rod(const Vector3& end_L, double radius, double length) {
  Shape shape{Shape::Kind::cylinder, {radius, length, 0.0}, {}};
  shape.X_LS.p = 0.5 * end_L;
  if (end_L.norm() > 1e-9)
    shape.X_LS.R = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), end_L).toRotationMatrix();
  return shape;
}

Matrix3 point_mass_inertia(double mass, const Vector3& p) {
  return mass * (p.squaredNorm() * Matrix3::Identity() - p * p.transpose());
}

RobotTree assemble(const UrdfFile& file, const std::vector<JointChain>& chains,
                   const UrdfOptions& options) {
  return Assembly(file, chains, options).tree();
}

void move(RobotTree& tree, const Pose& X_BR) {
  LinkModel& base = tree.base;
  base.p_LM = X_BR * base.p_LM;
  base.inertia_M_L = X_BR.R * base.inertia_M_L * X_BR.R.transpose();
  for (Shape& shape : base.shapes) shape.X_LS = X_BR * shape.X_LS;
  for (LinkParts::Solid& solid : tree.base_parts.collisions) solid.X_LS = X_BR * solid.X_LS;
  for (LinkParts::Solid& solid : tree.base_parts.visuals) solid.X_LS = X_BR * solid.X_LS;
  for (LinkParts::Part& part : tree.base_parts.parts) part.X_LP = X_BR * part.X_LP;
  for (SerialChain& chain : tree.chains) {
    for (TreeJoint& joint : chain.joints) {
      joint.p_BJ0 = X_BR * joint.p_BJ0;
      joint.axis_B0 = X_BR.R * joint.axis_B0;
    }
    for (LinkModel& link : chain.links) link.X_BL0 = X_BR * link.X_BL0;
    if (chain.foot) chain.foot->p_BF0 = X_BR * chain.foot->p_BF0;
  }
}

}  // namespace hexagait
