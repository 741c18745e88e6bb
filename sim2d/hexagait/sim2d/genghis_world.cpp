// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/sim2d/detail/box2d_trigonometry.hpp>
#include <hexagait/sim2d/detail/ground_chains.hpp>
#include <hexagait/sim2d/genghis_world.hpp>
#include <hexagait/text/violations.hpp>
#include <limits>

namespace hexagait::sim2d {
namespace detail {

/// One servo: an implicit spring-damper on its own inertia. What the foot meets only adds to that.
struct GenghisServo {
  double kp, kd, limit, inertia, dt;

  [[nodiscard]] double operator()(double error, double error_rate) const {
    const double wanted = kp * (error + dt * error_rate) + kd * error_rate;
    return std::clamp(wanted / (1.0 + dt * (kd + dt * kp) / inertia), -limit, limit);
  }
};

struct GenghisLeg {
  b2Body* body = nullptr;
  b2WheelJoint* joint = nullptr;  ///< a slider and a hinge: lift and swing, moved from outside
};

}  // namespace detail

namespace {

using namespace detail;

constexpr int kVelocityIterations = 12, kPositionIterations = 4;

GenghisWorldParams checked(const GenghisWorldParams& params) {
  Violations violations("Genghis");
  const auto require = [&](bool right, const char* name, double value, const char* words) {
    if (!right) violations.add(name, in_words(value) + "; it must be " + words);
  };
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  require(1e-5 <= params.physics_dt && params.physics_dt <= 0.01, "physics_dt", params.physics_dt,
          "from 1e-5 to 0.01 s");
  const double steps = params.control_dt / params.physics_dt;
  require(steps >= 0.999 && std::abs(steps - std::round(steps)) < 1e-6 && steps < 1e4, "control_dt",
          params.control_dt, "a whole number of physics steps");
  require(positive(params.gravity), "gravity", params.gravity, "greater than 0");
  require(params.foot_friction >= 0.0, "foot_friction", params.foot_friction, "0 or more");
  require(params.body_friction >= 0.0, "body_friction", params.body_friction, "0 or more");
  violations.throw_if_any();
  return params;
}

Vector3 in_space(const Vector2& p, double y) { return {p.x(), y, p.y()}; }

b2Body* make_body(b2World& world, const GenghisModel& model, const Vector2& p_WB, double friction) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = units(p_WB);
  b2Body* const body = world.CreateBody(&definition);

  // A box with its lower corners cut off: nose and tail slide up edges.
  const float x = units(0.5 * model.body_length), bevel = units(model.bevel);
  const float low = units(-model.belly), high = units(model.body_height - model.belly);
  const b2Vec2 outline[] = {{x, high},         {-x, high},       {-x, low + bevel},
                            {-x + bevel, low}, {x - bevel, low}, {x, low + bevel}};
  b2PolygonShape shape;
  shape.Set(outline, 6);
  b2MassData unit_density;
  shape.ComputeMass(&unit_density, 1.0F);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = static_cast<float>(model.body_mass) / unit_density.mass;
  fixture.friction = static_cast<float>(friction * friction);  // Box2D takes the geometric mean
  fixture.filter.categoryBits = kBody;
  fixture.filter.maskBits = kLeftGround | kRightGround;
  body->CreateFixture(&fixture);
  return body;
}

/// A rod from the hip to the foot with the foot at its end; only the foot touches.
detail::GenghisLeg make_leg(b2World& world, b2Body* body, const GenghisModel& model, LegId leg,
                            const GenghisJoints& q, double friction) {
  const Vector2 p_BH = hip(model, leg) + Vector2(0.0, q.lift);
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = body->GetWorldPoint(units(p_BH));
  definition.angle = static_cast<float>(q.swing);
  detail::GenghisLeg result;
  result.body = world.CreateBody(&definition);

  b2CircleShape foot;
  foot.m_p.Set(0.0F, units(-model.leg_length));
  foot.m_radius = units(model.foot_radius);
  b2FixtureDef fixture;
  fixture.shape = &foot;
  fixture.friction = static_cast<float>(friction * friction);
  const bool left = side_of(leg) == Side::left;
  fixture.filter.categoryBits = left ? kLeftFoot : kRightFoot;
  fixture.filter.maskBits = left ? kLeftGround : kRightGround;
  result.body->CreateFixture(&fixture);
  b2MassData mass;
  mass.mass = static_cast<float>(model.leg_mass);
  mass.center.Set(0.0F, units(-0.5 * model.leg_length));
  mass.I = mass.mass * units(model.leg_length) * units(model.leg_length) / 3.0F;
  result.body->SetMassData(&mass);

  b2WheelJointDef slider_and_hinge;
  slider_and_hinge.bodyA = body;
  slider_and_hinge.bodyB = result.body;
  slider_and_hinge.localAnchorA = units(hip(model, leg));
  slider_and_hinge.localAxisA.Set(0.0F, 1.0F);
  slider_and_hinge.enableLimit = true;
  slider_and_hinge.lowerTranslation = 0.0F;
  slider_and_hinge.upperTranslation = units(model.max_lift);
  result.joint = static_cast<b2WheelJoint*>(world.CreateJoint(&slider_and_hinge));
  return result;
}

}  // namespace

class GenghisWorld::Impl {
 public:
  Impl(const GenghisModel& model, const TerrainSpec2d& terrain, const GenghisWorldParams& params,
       const LegArray<GenghisJoints>& q)
      : model_(model),
        params_(checked(params)),
        world_({0.0F, force_units(-params.gravity)}),
        ground_(world_, Terrain2d(terrain, params.seed)),
        legs_(kGenghisLegs),
        load_(kGenghisLegs, 0.0) {
    const double h = params_.physics_dt, l = model.leg_length;
    lift_ = {params.lift_kp, params.lift_kd, params.lift_limit, model.leg_mass, h};
    swing_ = {params.swing_kp, params.swing_kd, params.swing_limit, model.leg_mass * l * l / 3, h};
    world_.SetAllowSleeping(false);
    world_.SetContinuousPhysics(false);

    double z = -std::numeric_limits<double>::infinity();
    for (LegId i = 0; i < kGenghisLegs; ++i) {
      const Vector2 p = foot_position(model, i, q[i]);
      z = std::max(z, ground_.terrain().height_at(side_of(i), p.x()) + model.foot_radius - p.y());
    }
    body_ = make_body(world_, model, {0.0, z}, params.body_friction);
    for (LegId i = 0; i < kGenghisLegs; ++i)
      legs_[i] = make_leg(world_, body_, model, i, q[i], params.foot_friction);
    ground_.cover(0.0);
    truth_.feet = LegArray<FootTruth>(kGenghisLegs);
    observe();
  }

  void read(GenghisMeasurement& measurement) const {
    measurement.time = truth_.time;
    measurement.q = LegArray<GenghisJoints>(kGenghisLegs);
    for (LegId i = 0; i < kGenghisLegs; ++i) measurement.q[i] = joints(i);
    measurement.load = load_;
    measurement.pitch = pitch_;
  }

  void write(const GenghisTargets& targets) {
    if (!truth_.finite) return;
    const auto steps = std::lround(params_.control_dt / params_.physics_dt);
    load_ = LegArray<double>(kGenghisLegs, 0.0);
    for (long k = 1; k <= steps; ++k) {
      // The set points are those of the period's end.
      const double left = static_cast<double>(steps - k) * params_.physics_dt;
      for (LegId i = 0; i < kGenghisLegs; ++i)
        load_[i] += drive(i, targets, left) / static_cast<double>(steps);
      world_.Step(static_cast<float>(params_.physics_dt), kVelocityIterations, kPositionIterations);
      truth_.time += params_.physics_dt;
      observe();
    }
    ground_.cover(truth_.X_WB.p.x());
  }

  [[nodiscard]] const GroundTruth& truth() const { return truth_; }
  [[nodiscard]] double pitch() const { return pitch_; }
  [[nodiscard]] bool underside_touches() const { return underside_touches_; }
  [[nodiscard]] const Terrain2d& terrain() const { return ground_.terrain(); }

 private:
  [[nodiscard]] GenghisJoints joints(LegId leg) const {
    const b2WheelJoint& joint = *legs_[leg].joint;
    return {static_cast<double>(joint.GetJointAngle()), metres(joint.GetJointTranslation())};
  }

  // Forces of both servos of a leg, and their reactions. Returns the load of the lift motor.
  double drive(LegId i, const GenghisTargets& targets, double left) {
    const detail::GenghisLeg& leg = legs_[i];
    const GenghisJoints q = joints(i);
    const GenghisJoints& goal = targets.q[i];
    const GenghisJoints& rate = targets.q_dot[i];
    const double lift_rate = metres(leg.joint->GetJointLinearSpeed());
    const double swing_rate = static_cast<double>(leg.joint->GetJointAngularSpeed());
    const double force = lift_(goal.lift - rate.lift * left - q.lift, rate.lift - lift_rate);
    const double torque = swing_(goal.swing - rate.swing * left - q.swing, rate.swing - swing_rate);

    const b2Vec2 up = body_->GetWorldVector({0.0F, 1.0F});
    const b2Vec2 at = leg.body->GetWorldPoint(b2Vec2_zero);
    leg.body->ApplyForce(force_units(force) * up, at, true);
    body_->ApplyForce(-force_units(force) * up, at, true);
    leg.body->ApplyTorque(torque_units(torque), true);
    body_->ApplyTorque(-torque_units(torque), true);
    const double weight = model_.leg_mass * params_.gravity * static_cast<double>(up.y);
    return weight - force;
  }

  void observe() {
    pitch_ = static_cast<double>(body_->GetAngle());
    // Nose up is a negative turn about y.
    truth_.X_WB = {rotation({0.0, -pitch_, 0.0}), in_space(metres(body_->GetPosition()), 0.0)};
    truth_.V_WB.v = truth_.X_WB.R.transpose() * in_space(metres(body_->GetLinearVelocity()), 0.0);
    truth_.V_WB.w = {0.0, -static_cast<double>(body_->GetAngularVelocity()), 0.0};
    truth_.finite = truth_.X_WB.p.allFinite() && std::isfinite(pitch_);
    underside_touches_ = touch(body_).normal_force > 0.0;
    for (LegId i = 0; i < kGenghisLegs; ++i) {
      const Touch contact = touch(legs_[i].body);
      FootTruth& foot = truth_.feet[i];
      foot.p_WF = in_space(metres(legs_[i].body->GetWorldPoint({0.0F, units(-model_.leg_length)})),
                           sign_of(i) * model_.foot_y);
      foot.normal_force = contact.normal_force;
      foot.in_contact = contact.normal_force > 0.0;
      foot.slip_speed = contact.slip.norm();
      foot.slip_path += foot.slip_speed * params_.physics_dt;
      foot.slip += in_space(contact.slip, 0.0) * params_.physics_dt;
    }
  }

  struct Touch {
    double normal_force = 0.0;       ///< [N]
    Vector2 slip = Vector2::Zero();  ///< tangential velocity at the most loaded contact [m/s]
  };

  Touch touch(b2Body* body) const {
    Touch result;
    double most = 0.0;
    const double per_step = 1.0 / params_.physics_dt;
    for (const b2ContactEdge* edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
      if (!edge->contact->IsTouching()) continue;
      b2WorldManifold world;
      edge->contact->GetWorldManifold(&world);
      const b2Manifold& manifold = *edge->contact->GetManifold();
      for (int k = 0; k < manifold.pointCount; ++k) {
        const double normal = newtons(manifold.points[k].normalImpulse) * per_step;
        result.normal_force += normal;
        if (normal <= most) continue;
        most = normal;
        const b2Vec2 v = body->GetLinearVelocityFromWorldPoint(world.points[k]);
        const b2Vec2 along = b2Cross(1.0F, world.normal);
        result.slip = metres(b2Dot(along, v) * along);
      }
    }
    return result;
  }

  GenghisModel model_;
  GenghisWorldParams params_;
  detail::GenghisServo lift_{}, swing_{};
  b2World world_;
  GroundChains ground_;
  b2Body* body_ = nullptr;
  LegArray<detail::GenghisLeg> legs_;
  LegArray<double> load_;
  GroundTruth truth_;
  double pitch_ = 0.0;  ///< positive nose up [rad]
  bool underside_touches_ = false;
};

GenghisWorld::GenghisWorld(const GenghisModel& model, const TerrainSpec2d& terrain,
                           const GenghisWorldParams& params, const LegArray<GenghisJoints>& q)
    : impl_(std::make_unique<Impl>(model, terrain, params, q)) {
  detail::link_portable_trigonometry();
}
GenghisWorld::~GenghisWorld() = default;
GenghisWorld::GenghisWorld(GenghisWorld&&) noexcept = default;
GenghisWorld& GenghisWorld::operator=(GenghisWorld&&) noexcept = default;

void GenghisWorld::read(GenghisMeasurement& measurement) const { impl_->read(measurement); }
void GenghisWorld::write(const GenghisTargets& targets) { impl_->write(targets); }
const GroundTruth& GenghisWorld::truth() const { return impl_->truth(); }
double GenghisWorld::pitch() const { return impl_->pitch(); }
bool GenghisWorld::underside_touches() const { return impl_->underside_touches(); }
const Terrain2d& GenghisWorld::terrain() const { return impl_->terrain(); }

}  // namespace hexagait::sim2d
