// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/detail/robot.hpp>

namespace hexagait::sim3d::detail {
namespace {

// Beyond these bounds the physics has diverged. (ODE would abort before it returned a NaN.)
constexpr double kFarthest = 1e6;  // [m]
constexpr double kFastest = 1e4;   // [m/s], [rad/s]

constexpr double kSamePlace = 1e-6;  // [m]
constexpr double kNearLimit = 0.8;   // of a servo's effort limit: see Robot::step()
constexpr int kMostRepeats = 8;      // of a step: far more than are ever needed

void place(dBodyID body, const Pose& X_WL, const Vector3& p_LM) {
  const Vector3 p_WM = X_WL * p_LM;
  dBodySetPosition(body, p_WM.x(), p_WM.y(), p_WM.z());
  dBodySetRotation(body, OdeRotation(X_WL.R).m.data());
}

Pose pose_of(dBodyID body, const Vector3& p_LM) {
  const Matrix3 R = rotation_from_ode(dBodyGetRotation(body));
  return {R, from_ode(dBodyGetPosition(body)) - R * p_LM};
}

// A slim cylinder becomes the capsule inside it: its contacts are exact, except at the rims.
dGeomID make_geom(const Shape& shape) {
  const Vector3& size = shape.size;
  switch (shape.kind) {
    case Shape::Kind::box:
      return dCreateBox(nullptr, size.x(), size.y(), size.z());
    case Shape::Kind::sphere:
      return dCreateSphere(nullptr, size.x());
    case Shape::Kind::cylinder:
      if (size.y() > 2.0 * size.x()) {
        return dCreateCapsule(nullptr, size.x(), size.y() - 2.0 * size.x());
      }
      return dCreateCylinder(nullptr, size.x(), size.y());
  }
  return nullptr;
}

// The robot as it is built: each link heavier or lighter than its model by a share.
RobotModel with_mass_errors(RobotModel model, const WorldParams& params) {
  if (params.mass_error == 0.0) return model;
  RandomSequence lot{.seed = params.seed, .stream = RandomStream::masses};
  const auto change = [&](LinkModel& link) {
    const double factor = 1.0 + (lot.u01() < 0.5 ? -1.0 : 1.0) * params.mass_error;
    link.mass *= factor;
    link.inertia_M_L *= factor;
  };
  change(model.base);
  for (LegModel& leg : model.legs)
    for (LinkModel& link : leg.links) change(link);
  return model;
}

}  // namespace

bool is_foot(const Shape& shape, const LegModel& leg) {
  const Vector3 p_BS0 = leg.links.back().X_BL0 * shape.X_LS.p;
  return shape.kind == Shape::Kind::sphere && (p_BS0 - leg.p_BF0).norm() < kSamePlace;
}

Robot::Robot(dWorldID world, const RobotModel& model, const WorldParams& params, const Pose& X_WB,
             const LegArray<LegJoints>& q)
    : world_(world),
      h_(params.physics_dt),
      model_(with_mass_errors(model, params)),
      servos_(params, q),
      links_(model.num_legs()) {
  base_ = make_link(model_.base, X_WB);
  make_shapes(model_.base, base_);
  if (params.base_on_stand) dBodySetKinematic(base_.body);

  // Hinges read zero where they are made: make them in the zero configuration, then move the legs.
  for (LegId leg = 0; leg < model.num_legs(); ++leg) {
    make_leg(leg, X_WB);
    move_leg_to(leg, X_WB, q[leg]);
  }
}

Robot::Link Robot::make_link(const LinkModel& model, const Pose& X_WB) {
  const Matrix3& I = model.inertia_M_L;
  dMass mass;
  dMassSetParameters(&mass, model.mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2),
                     I(1, 2));
  const Link link{dBodyCreate(world_), model.p_LM};
  dBodySetMass(link.body, &mass);
  place(link.body, X_WB * model.X_BL0, link.p_LM);
  bodies_.push_back(link.body);
  saved_.emplace_back();
  return link;
}

void Robot::make_shapes(const LinkModel& model, const Link& link) {
  for (const Shape& shape : model.shapes) {
    GeomPtr geom(make_geom(shape));
    dGeomSetBody(geom.get(), link.body);
    const Vector3 p_MS = shape.X_LS.p - link.p_LM;
    dGeomSetOffsetPosition(geom.get(), p_MS.x(), p_MS.y(), p_MS.z());
    dGeomSetOffsetRotation(geom.get(), OdeRotation(shape.X_LS.R).m.data());
    shapes_.push_back({std::move(geom), link.body, RobotShape::kNotAFoot, link.body == base_.body});
  }
}

void Robot::make_leg(LegId leg, const Pose& X_WB) {
  const LegModel& model = model_.legs[leg];
  dBodyID parent = base_.body;
  links_[leg] = JointArray<Link>(model.num_joints());
  for (int k = 0; k < model.num_joints(); ++k) {
    const Link link = links_[leg][k] = make_link(model.links[k], X_WB);
    make_shapes(model.links[k], link);

    // Child first: the hinge then turns positively about the joint's axis.
    const dJointID hinge = dJointCreateHinge(world_, nullptr);
    dJointAttach(hinge, link.body, parent);
    const Vector3 anchor = X_WB * model.p_BJ0[k], axis = X_WB.R * model.axis_B0[k];
    dJointSetHingeAnchor(hinge, anchor.x(), anchor.y(), anchor.z());
    dJointSetHingeAxis(hinge, axis.x(), axis.y(), axis.z());
    servos_.add(world_, hinge, leg, k, model.limits[k]);
    parent = link.body;
  }

  // The shapes of the last link, which has the foot, came last.
  const std::vector<Shape>& last = model.links.back().shapes;
  for (std::size_t i = 0; i < last.size(); ++i) {
    if (is_foot(last[i], model)) shapes_[shapes_.size() - last.size() + i].foot_of = leg;
  }
}

void Robot::move_leg_to(LegId leg, const Pose& X_WB, const LegJoints& q) {
  for (int k = 0; k < links_[leg].size(); ++k) {
    const Link& link = links_[leg][k];
    place(link.body, X_WB * link_pose(model_.legs[leg], k, q), link.p_LM);
  }
}

// The solver spends most of its time on bounded rows, but servos are rarely at their limits. So only
// those near their effort limit in the last step are bounded, and only those at their velocity limit
// in the last step have its row. If another one exceeds a limit, the step is undone and repeated
// with all bounds, and with its row. A solution that violates no bound is also the solution of the
// bounded problem, so this affects only the run time.
void Robot::step(double to_come, const Vector3& force_W) {
  servos_.command(to_come);
  servos_.bound(kNearLimit);
  save_bodies();
  step_world(force_W);

  for (int k = 0; k < kMostRepeats && servos_.correct(); ++k) {
    restore_bodies();
    step_world(force_W);
  }
  servos_.read_positions();
}

// ODE clears the forces on bodies after each step.
void Robot::step_world(const Vector3& force_W) {
  if (!force_W.isZero()) dBodyAddForce(base_.body, force_W.x(), force_W.y(), force_W.z());
  dWorldStep(world_, h_);
  servos_.read_efforts();
}

void Robot::cut(LegId leg) {
  servos_.cut(leg);
  for (const Link& link : links_[leg]) {
    dBodyDisable(link.body);
    std::erase_if(shapes_, [&](const RobotShape& shape) { return shape.body == link.body; });
  }
}

void Robot::save_bodies() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    BodyState& state = saved_[i];
    state.p = from_ode(dBodyGetPosition(bodies_[i]));
    state.v = from_ode(dBodyGetLinearVel(bodies_[i]));
    state.w = from_ode(dBodyGetAngularVel(bodies_[i]));
    std::copy_n(dBodyGetQuaternion(bodies_[i]), 4, state.rotation.begin());
  }
}

void Robot::restore_bodies() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyState& state = saved_[i];
    dBodySetPosition(bodies_[i], state.p.x(), state.p.y(), state.p.z());
    dBodySetLinearVel(bodies_[i], state.v.x(), state.v.y(), state.v.z());
    dBodySetAngularVel(bodies_[i], state.w.x(), state.w.y(), state.w.z());
    dBodySetQuaternion(bodies_[i], state.rotation.data());
  }
}

Pose Robot::X_WB() const { return pose_of(base_.body, base_.p_LM) * model_.base.X_BL0.inverse(); }

Twist Robot::V_WB() const {
  const Pose X = X_WB();
  const Vector3 w_W = from_ode(dBodyGetAngularVel(base_.body));
  const Vector3 p_MB_W = X.p - from_ode(dBodyGetPosition(base_.body));
  const Vector3 v_W = from_ode(dBodyGetLinearVel(base_.body)) + w_W.cross(p_MB_W);
  return {X.R.transpose() * v_W, X.R.transpose() * w_W};
}

Vector3 Robot::p_WF(LegId leg) const {
  const Link& last = links_[leg].back();
  const LegModel& model = model_.legs[leg];
  return pose_of(last.body, last.p_LM) * (model.links.back().X_BL0.inverse() * model.p_BF0);
}

bool Robot::is_sane() const {
  const auto within = [](const dReal* v, double bound) { return from_ode(v).norm() < bound; };
  return std::ranges::all_of(bodies_, [&](dBodyID body) {
    return within(dBodyGetPosition(body), kFarthest) && within(dBodyGetLinearVel(body), kFastest) &&
           within(dBodyGetAngularVel(body), kFastest);
  });
}

}  // namespace hexagait::sim3d::detail
