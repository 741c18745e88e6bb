// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <hexagait/urdf/detail/robot_tree.hpp>
#include <hexagait/urdf/detail/rotations.hpp>
#include <hexagait/urdf/detail/xml_size.hpp>
#include <mutex>

namespace hexagait {
namespace {

/// While it lives, what urdfdom reports is kept here and not printed. Afterwards console_bridge
/// doesn't know it any more: it remembers the handler in use and the one before, which
/// restorePreviousOutputHandler() exchanges.
class UrdfdomLog : public console_bridge::OutputHandler {
 public:
  UrdfdomLog() : used_(console_bridge::getOutputHandler()), level_(console_bridge::getLogLevel()) {
    console_bridge::restorePreviousOutputHandler();
    before_ = console_bridge::getOutputHandler();
    console_bridge::useOutputHandler(this);
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
  }
  ~UrdfdomLog() override {
    console_bridge::setLogLevel(level_);
    console_bridge::useOutputHandler(before_);
    console_bridge::useOutputHandler(used_);
  }
  UrdfdomLog(const UrdfdomLog&) = delete;
  UrdfdomLog& operator=(const UrdfdomLog&) = delete;

  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override {
    errors.push_back(text);
  }

  std::vector<std::string> errors;

 private:
  console_bridge::OutputHandler* used_;
  console_bridge::OutputHandler* before_ = nullptr;
  console_bridge::LogLevel level_;
};

/// Links own their children: if some form a ring, they would never be freed.
struct LinkOwner {
  urdf::ModelInterface& model;
  ~LinkOwner() {
    for (const auto& [name, link] : model.links_) link->child_links.clear();
  }
};

/// What urdfdom complains about is a violation, also where it carries on (with 0 for a bad mass).
/// @returns null if there is any: what is wrong with the rest would follow from it
urdf::ModelInterfaceSharedPtr parse(const std::string& xml, Violations& violations) {
  if (const std::string problem = too_large(xml); !problem.empty()) {
    violations.add("URDF", problem);
    return nullptr;
  }
  static std::mutex one_at_a_time;  // urdfdom reports through one global handler
  const std::lock_guard lock(one_at_a_time);
  const UrdfdomLog log;
  urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(xml);

  // It stops at the first fault, and tells the context after the reason: one violation.
  std::string reasons;
  for (const std::string& error : log.errors)
    reasons.append(reasons.empty() ? "" : "; ").append(error);
  if (!model) reasons += "; it must be XML with a <robot> element and its links and joints";
  if (model && reasons.empty()) {
    recompute_rotations(*model, xml);
    return model;
  }
  violations.add("URDF", reasons);
  if (model) const LinkOwner frees{*model};
  return nullptr;
}

Vector3 vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Pose pose(const urdf::Pose& X) {
  const Eigen::Quaterniond rotation(X.rotation.w, X.rotation.x, X.rotation.y, X.rotation.z);
  return {rotation.toRotationMatrix(), vector(X.position)};
}

/// A link with everything that is fixed to it, while it is summed up.
struct RigidBody {
  LinkModel link;                       ///< mass properties are filled in last
  bool has_inertia = false;             ///< some part of it has an <inertial> element
  double mass = 0.0;                    ///< [kg]
  Vector3 moment_L = Vector3::Zero();   ///< Σ m p_LM [kg m]
  Matrix3 inertia_L = Matrix3::Zero();  ///< about L's origin [kg m²]
  struct Departure {
    const urdf::Joint* joint;
    Pose X_LP;  ///< frame of the joint's parent
  };
  std::vector<Departure> departures;  ///< the movable joints that leave it
};

Matrix3 point_mass_inertia(double mass, const Vector3& p) {
  return mass * (p.squaredNorm() * Matrix3::Identity() - p * p.transpose());
}

/// The reader: walks the tree from its root.
class Reader {
 public:
  Reader(const urdf::ModelInterface& model, Violations& violations)
      : model_(model), violations_(violations) {}

  RobotTree read();

 private:
  RigidBody rigid_body(const urdf::Link& link, const Pose& X_BL);
  void merge(const urdf::Link& part, const Pose& X_LP, RigidBody& body);
  void merge_inertia(const urdf::Link& part, const Pose& X_LP, RigidBody& body);
  void merge_shapes(const urdf::Link& part, const Pose& X_LP, RigidBody& body);
  void finish_inertia(RigidBody& body);
  SerialChain chain(const urdf::Joint* joint, Pose X_BP);
  TreeJoint tree_joint(const urdf::Joint& joint, const Pose& X_BJ);
  JointLimits limits(const urdf::Joint& joint);
  void report_unreached();

  const urdf::ModelInterface& model_;
  Violations& violations_;
  std::size_t links_read_ = 0;
};

RobotTree Reader::read() {
  RobotTree tree;
  tree.name = model_.getName();
  const RigidBody base = rigid_body(*model_.getRoot(), Pose{});
  tree.base = base.link;
  for (const RigidBody::Departure& departure : base.departures)
    tree.chains.push_back(chain(departure.joint, departure.X_LP));
  report_unreached();
  return tree;
}

/// Follows the joints outwards from `joint`, whose parent frame is at X_BP.
SerialChain Reader::chain(const urdf::Joint* joint, Pose X_BP) {
  SerialChain chain;
  while (joint != nullptr) {
    const Pose X_BJ = X_BP * pose(joint->parent_to_joint_origin_transform);
    chain.joints.push_back(tree_joint(*joint, X_BJ));
    const RigidBody body = rigid_body(*model_.getLink(joint->child_link_name), X_BJ);
    chain.links.push_back(body.link);
    if (body.departures.size() > 1)
      violations_.add("link " + body.link.name,
                      "carries " + std::to_string(body.departures.size()) +
                          " movable joints; in a serial leg it carries at most one");

    joint = body.departures.empty() ? nullptr : body.departures.front().joint;
    if (joint != nullptr) X_BP = X_BJ * body.departures.front().X_LP;
  }

  const LinkModel& tip = chain.links.back();
  for (const Shape& shape : tip.shapes) {
    if (shape.kind != Shape::Kind::sphere) continue;
    const Vector3 p_BS = tip.X_BL0 * shape.X_LS.p, p_BJ = tip.X_BL0.p;
    if (!chain.foot || (p_BS - p_BJ).norm() > (chain.foot->p_BF0 - p_BJ).norm())
      chain.foot = {p_BS, shape.size.x()};
  }
  return chain;
}

RigidBody Reader::rigid_body(const urdf::Link& link, const Pose& X_BL) {
  RigidBody body;
  body.link.name = link.name;
  body.link.X_BL0 = X_BL;
  merge(link, Pose{}, body);
  finish_inertia(body);
  return body;
}

void Reader::merge(const urdf::Link& part, const Pose& X_LP, RigidBody& body) {
  ++links_read_;
  merge_inertia(part, X_LP, body);
  merge_shapes(part, X_LP, body);
  for (const urdf::JointSharedPtr& joint : part.child_joints) {
    const urdf::LinkConstSharedPtr child = model_.getLink(joint->child_link_name);
    if (child->parent_joint != joint) {
      violations_.add("link " + child->name, "has two parents, by the joints " + joint->name +
                                                 " and " + child->parent_joint->name +
                                                 "; a robot is a tree");
    } else if (joint->type == urdf::Joint::FIXED) {
      merge(*child, X_LP * pose(joint->parent_to_joint_origin_transform), body);
    } else {
      body.departures.push_back({joint.get(), X_LP});
    }
  }
}

void Reader::merge_inertia(const urdf::Link& part, const Pose& X_LP, RigidBody& body) {
  if (!part.inertial) return;
  const urdf::Inertial& inertial = *part.inertial;
  body.has_inertia = true;
  if (!(inertial.mass > 0.0))
    violations_.add("link " + part.name,
                    "mass is " + in_words(inertial.mass) + " kg; it must be positive");

  Matrix3 inertia;
  inertia << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,         //
      inertial.ixz, inertial.iyz, inertial.izz;
  const Pose X_LM = X_LP * pose(inertial.origin);
  body.mass += inertial.mass;
  body.moment_L += inertial.mass * X_LM.p;
  body.inertia_L += X_LM.R * inertia * X_LM.R.transpose();
  body.inertia_L += point_mass_inertia(inertial.mass, X_LM.p);
}

void Reader::merge_shapes(const urdf::Link& part, const Pose& X_LP, RigidBody& body) {
  for (const urdf::CollisionSharedPtr& collision : part.collision_array) {
    if (!collision->geometry || collision->geometry->type == urdf::Geometry::MESH) continue;
    Shape shape;
    shape.X_LS = X_LP * pose(collision->origin);
    if (const auto* box = dynamic_cast<const urdf::Box*>(collision->geometry.get())) {
      shape.kind = Shape::Kind::box;
      shape.size = vector(box->dim);
    } else if (const auto* rod = dynamic_cast<const urdf::Cylinder*>(collision->geometry.get())) {
      shape.kind = Shape::Kind::cylinder;
      shape.size = {rod->radius, rod->length, 0.0};
    } else if (const auto* ball = dynamic_cast<const urdf::Sphere*>(collision->geometry.get())) {
      shape.kind = Shape::Kind::sphere;
      shape.size = {ball->radius, 0.0, 0.0};
    }
    const int sizes = shape.kind == Shape::Kind::box        ? 3
                      : shape.kind == Shape::Kind::cylinder ? 2
                                                            : 1;
    for (int i = 0; i < sizes; ++i) {
      if (shape.size[i] > 0.0 && std::isfinite(shape.size[i])) continue;
      violations_.add("link " + part.name, "collision size is " + in_words(shape.size[i]) +
                                               " m; it must be positive and finite");
    }
    body.link.shapes.push_back(shape);
  }
}

/// Turns the sums into mass, centre of mass and inertia about it.
void Reader::finish_inertia(RigidBody& body) {
  LinkModel& link = body.link;
  if (!body.has_inertia)
    violations_.add("link " + link.name, "has no mass; it needs an <inertial> element");
  if (!(body.mass > 0.0)) return;

  link.mass = body.mass;
  link.p_LM = body.moment_L / body.mass;
  link.inertia_M_L = body.inertia_L - point_mass_inertia(body.mass, link.p_LM);
  if (!std::isfinite(link.mass) || !link.p_LM.allFinite() || !link.inertia_M_L.allFinite() ||
      !link.X_BL0.p.allFinite()) {
    violations_.add("link " + link.name, "mass, inertia or origin is not a finite number");
    return;
  }
  const double smallest =
      Eigen::SelfAdjointEigenSolver<Matrix3>(link.inertia_M_L).eigenvalues().minCoeff();
  if (!(smallest > 0.0))
    violations_.add("link " + link.name, "smallest principal moment of inertia is " +
                                             in_words(smallest) + " kg m^2; it must be positive");
}

TreeJoint Reader::tree_joint(const urdf::Joint& joint, const Pose& X_BJ) {
  const std::string element = "joint " + joint.name;
  const bool turns = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
  if (!turns) violations_.add(element, "moves, but is neither revolute nor continuous");
  if (joint.mimic)
    violations_.add(element,
                    "mimics " + joint.mimic->joint_name + "; each joint needs its own motor");

  const Vector3 axis = vector(joint.axis);
  if (!axis.allFinite() || axis.isZero())
    violations_.add(element,
                    "axis has length " + in_words(axis.norm()) + "; it must be a direction");
  return {joint.name, X_BJ.p, X_BJ.R * axis.normalized(), turns ? limits(joint) : JointLimits{}};
}

JointLimits Reader::limits(const urdf::Joint& joint) {
  const std::string element = "joint " + joint.name;
  if (!joint.limits) {
    violations_.add(element, "has no <limit>; velocity and effort are needed");
    return {};
  }
  JointLimits limits{joint.limits->lower, joint.limits->upper, joint.limits->velocity,
                     joint.limits->effort};
  if (joint.type == urdf::Joint::CONTINUOUS)
    limits = {-std::numbers::pi, std::numbers::pi, limits.velocity, limits.effort};

  if (!std::isfinite(limits.upper - limits.lower) || !(limits.lower < limits.upper))
    violations_.add(element, "lower limit " + in_words(limits.lower) + " rad, upper limit " +
                                 in_words(limits.upper) + " rad; need finite lower < upper");
  if (!(limits.velocity > 0.0) || !std::isfinite(limits.velocity))
    violations_.add(element, "velocity limit is " + in_words(limits.velocity) +
                                 " rad/s; it must be positive and finite");
  if (!(limits.effort > 0.0) || !std::isfinite(limits.effort))
    violations_.add(element, "effort limit is " + in_words(limits.effort) +
                                 " N m; it must be positive and finite");
  return limits;
}

void Reader::report_unreached() {
  const std::size_t links = model_.links_.size();
  if (links_read_ == links) return;
  violations_.add("robot " + model_.getName(),
                  std::to_string(links - links_read_) + " of " + std::to_string(links) +
                      " links do not hang from the root link; a robot is a tree");
}

}  // namespace

std::optional<RobotTree> read_robot_tree(const std::string& xml, Violations& violations) {
  const urdf::ModelInterfaceSharedPtr model = parse(xml, violations);
  if (!model) return std::nullopt;
  const LinkOwner owner{*model};
  return Reader(*model, violations).read();
}

}  // namespace hexagait
