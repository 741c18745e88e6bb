// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/sim3d/detail/contacts.hpp>

namespace hexagait::sim3d::detail {

double Touch::normal_force() const { return std::max(0.0, from_ode(feedback.f1).dot(normal)); }

Vector3 Touch::slip_velocity() const {
  const Vector3 v_M = from_ode(dBodyGetLinearVel(shape->body));
  const Vector3 w = from_ode(dBodyGetAngularVel(shape->body));
  const Vector3 v_P = v_M + w.cross(p_MP_W);
  return v_P - v_P.dot(normal) * normal;
}

Contacts::Contacts(dWorldID world, const WorldParams& params)
    : world_(world),
      h_(params.physics_dt),
      friction_(params.friction),
      joints_(dJointGroupCreate(0)) {
  surface_.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
  surface_.soft_erp = params.contact_erp;
  surface_.soft_cfm = params.contact_cfm;
}

void Contacts::find(Ground& ground, std::span<const RobotShape> shapes) {
  dJointGroupEmpty(joints_.get());
  count_ = 0;
  std::array<dContactGeom, kMostContacts> places;
  for (const RobotShape& shape : shapes) {
    const std::span room = std::span(places).first(kMostContacts - count_);
    const auto found = static_cast<std::size_t>(ground.collide(shape.geom.get(), room));
    if (const auto& soft = ground.terrain().softness(); soft && found > 0) give_way(*soft, found);
    for (const dContactGeom& place : room.first(found)) {
      surface_.mu = ground.terrain().friction_at(place.pos[0], place.pos[1], friction_);
      add(shape, place);
    }
  }
}

// The spring and damper F = K s + D ds/dt as a row of the solver, shared by the contacts of a shape:
// ERP = h K/(h K + D), CFM = 1/(h K + D).
void Contacts::give_way(const Terrain::Softness& soft, std::size_t contacts) {
  const double gain = h_ * soft.stiffness + soft.damping;
  surface_.soft_erp = h_ * soft.stiffness / gain;
  surface_.soft_cfm = static_cast<double>(contacts) / gain;
}

std::span<const Touch> Contacts::touches() const { return std::span(touches_).first(count_); }

void Contacts::add(const RobotShape& shape, const dContactGeom& place) {
  dContact contact{};
  contact.surface = surface_;
  contact.geom = place;
  const dJointID joint = dJointCreateContact(world_, joints_.get(), &contact);
  dJointAttach(joint, shape.body, nullptr);

  Touch& touch = touches_[count_++];
  touch.shape = &shape;
  touch.p_MP_W = from_ode(place.pos) - from_ode(dBodyGetPosition(shape.body));
  touch.normal = from_ode(place.normal);
  dJointSetFeedback(joint, &touch.feedback);
}

}  // namespace hexagait::sim3d::detail
