// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tinyxml.h>

#include <hexagait/math/trigonometry.hpp>
#include <hexagait/urdf/detail/rotations.hpp>

namespace hexagait {
namespace {

/// Rz(yaw) Ry(pitch) Rx(roll), the product of three half-angle quaternions.
urdf::Rotation rotation_of(const urdf::Vector3& rpy) {
  const portable::SinCos roll = portable::sincos(0.5 * rpy.x),
                         pitch = portable::sincos(0.5 * rpy.y), yaw = portable::sincos(0.5 * rpy.z);
  urdf::Rotation q(roll.s * pitch.c * yaw.c - roll.c * pitch.s * yaw.s,
                   roll.c * pitch.s * yaw.c + roll.s * pitch.c * yaw.s,
                   roll.c * pitch.c * yaw.s - roll.s * pitch.s * yaw.c,
                   roll.c * pitch.c * yaw.c + roll.s * pitch.s * yaw.s);
  q.normalize();
  return q;
}

/// Of an element with an <origin>; without rpy it is not turned.
void recompute(const TiXmlElement& element, urdf::Pose& pose) {
  const TiXmlElement* origin = element.FirstChildElement("origin");
  const char* text = origin != nullptr ? origin->Attribute("rpy") : nullptr;
  if (text == nullptr) return;
  urdf::Vector3 rpy;
  rpy.init(text);
  pose.rotation = rotation_of(rpy);
}

void recompute_link(const TiXmlElement& element, urdf::Link& link) {
  const TiXmlElement* inertial = element.FirstChildElement("inertial");
  if (inertial != nullptr && link.inertial) recompute(*inertial, link.inertial->origin);
  const TiXmlElement* shape = element.FirstChildElement("collision");
  for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
    if (shape == nullptr) return;
    recompute(*shape, collision->origin);
    shape = shape->NextSiblingElement("collision");
  }
}

/// Calls f(element, part) for each child element of the robot that is called `kind` and has the name
/// of a part of the model.
template <class Parts, class F>
void for_each(const TiXmlElement& robot, const char* kind, const Parts& parts, F f) {
  for (const TiXmlElement* element = robot.FirstChildElement(kind); element != nullptr;
       element = element->NextSiblingElement(kind)) {
    const char* name = element->Attribute("name");
    const auto part = name != nullptr ? parts.find(name) : parts.end();
    if (part != parts.end()) f(*element, *part->second);
  }
}

}  // namespace

void recompute_rotations(urdf::ModelInterface& model, const std::string& xml) {
  TiXmlDocument document;
  document.Parse(xml.c_str());
  const TiXmlElement* robot = document.FirstChildElement("robot");
  if (robot == nullptr) return;
  for_each(*robot, "link", model.links_, recompute_link);
  for_each(*robot, "joint", model.joints_, [](const TiXmlElement& element, urdf::Joint& joint) {
    recompute(element, joint.parent_to_joint_origin_transform);
  });
}

}  // namespace hexagait
