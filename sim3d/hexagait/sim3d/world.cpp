// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/detail/check.hpp>
#include <hexagait/sim3d/detail/contacts.hpp>
#include <hexagait/sim3d/detail/ground.hpp>
#include <hexagait/sim3d/detail/robot.hpp>
#include <hexagait/sim3d/world.hpp>
#include <limits>

namespace hexagait::sim3d {
namespace {

using detail::RobotShape;
using detail::Touch;

detail::WorldPtr make_ode_world(const WorldParams& params, dThreadingImplementationID threading) {
  detail::WorldPtr world(dWorldCreate());
  dWorldSetStepThreadingImplementation(world.get(), dThreadingImplementationGetFunctions(threading),
                                       threading);
  dWorldSetGravity(world.get(), 0, 0, -params.gravity);
  dWorldSetERP(world.get(), params.hinge_erp);
  dWorldSetCFM(world.get(), params.hinge_cfm);
  dWorldSetContactMaxCorrectingVel(world.get(), params.contact_correcting_speed);
  dWorldSetAutoDisableFlag(world.get(), 0);
  return world;
}

// Start pose of the base: level, with the lowest foot start_clearance above the ground.
Pose start_pose(const RobotModel& model, const Terrain& terrain, const WorldParams& params,
                const LegArray<LegJoints>& q) {
  Pose X_WB{rotation_z(params.start.angle), Vector3::Zero()};
  X_WB.p.head<2>() = params.start.shift;
  double z = -std::numeric_limits<double>::infinity();
  for (LegId leg = 0; leg < model.num_legs(); ++leg) {
    const Vector3 p_WF = X_WB * foot_position(model.legs[leg], q[leg]);
    z = std::max(z, terrain.height_at(p_WF.x(), p_WF.y()) + model.foot_radius - p_WF.z());
  }
  const double ground = terrain.height_at(X_WB.p.x(), X_WB.p.y());
  X_WB.p.z() = std::max(z + params.start_clearance, ground + params.start_height);
  return X_WB;
}

// Are the values finite for all joints that exist?
bool all_finite(const JointTargets& targets, const LegArray<int>& num_joints) {
  for (LegId leg = 0; leg < num_joints.size(); ++leg)
    for (const LegArray<LegJoints>* all : {&targets.q, &targets.qd, &targets.effort})
      if (!(*all)[leg].head(num_joints[leg]).allFinite()) return false;
  return true;
}

// Updates the ground truth of the feet from the contacts of one step of length h. A foot on an edge
// has several contacts: their forces add up, and the most loaded one determines its slip.
void record_contacts(std::span<const Touch> touches, double h, GroundTruth& truth) {
  LegArray<double> largest(truth.feet.size(), 0.0);
  LegArray<Vector3> slip_velocity(truth.feet.size(), Vector3::Zero());
  for (FootTruth& foot : truth.feet) foot.normal_force = 0.0;
  truth.base_touches_ground = false;
  truth.leg_touches_ground = false;

  for (const Touch& touch : touches) {
    const LegId leg = touch.shape->foot_of;
    if (leg == RobotShape::kNotAFoot) {
      (touch.shape->of_base ? truth.base_touches_ground : truth.leg_touches_ground) = true;
      continue;
    }
    const double force = touch.normal_force();
    truth.feet[leg].normal_force += force;
    if (force > largest[leg]) {
      largest[leg] = force;
      slip_velocity[leg] = touch.slip_velocity();
    }
  }

  for (LegId leg = 0; leg < truth.feet.size(); ++leg) {
    FootTruth& foot = truth.feet[leg];
    foot.in_contact = foot.normal_force > 0.0;
    foot.slip_speed = slip_velocity[leg].norm();
    foot.slip_path += h * foot.slip_speed;
    foot.slip += h * slip_velocity[leg];
  }
}

}  // namespace

class World::Impl {
 public:
  Impl(const RobotModel& model, const TerrainSpec& spec, const WorldParams& params,
       const LegArray<LegJoints>& q)
      : params_(params),
        physics_steps_(static_cast<int>(std::lround(params.control_dt / params.physics_dt))),
        threading_(dThreadingAllocateSelfThreadedImplementation()),
        world_(make_ode_world(params, threading_.get())),
        ground_(Terrain(spec, params.seed), params.blocks),
        contacts_(world_.get(), params),
        robot_(world_.get(), model, params, start_pose(model, terrain(), params, q), q),
        num_joints_(model.num_legs()),
        felt_(model.num_legs(), false) {
    for (LegId leg = 0; leg < model.num_legs(); ++leg)
      num_joints_[leg] = model.legs[leg].num_joints();
    truth_.feet = LegArray<FootTruth>(model.num_legs());
    truth_.work = 0.0;
    record_motion();
    up_ = {0.0, 0.0, params.gravity};
    acceleration_B_ = truth_.X_WB.R.transpose() * up_;
  }

  PlantStatus read(Measurement& measurement) const {
    measurement.time = truth_.time;
    measurement.q = robot_.servos().q();
    measurement.contact = felt_;
    measurement.imu = {};
    if (params_.imu) measurement.imu = {acceleration_B_, truth_.V_WB.w};
    return truth_.finite ? PlantStatus::fresh : PlantStatus::closed;
  }

  void write(const JointTargets& targets) {
    if (!all_finite(targets, num_joints_)) truth_.finite = false;
    robot_.servos().set_targets(targets);
    felt_ = LegArray<bool>(felt_.size(), false);
    const Vector3 v_W = truth_.X_WB.R * truth_.V_WB.v;
    for (int k = 0; k < physics_steps_ && truth_.finite; ++k)
      step((physics_steps_ - k) * params_.physics_dt);
    feel_acceleration(v_W);
  }

  void push(const Vector3& force_W, double seconds) {
    push_ = force_W;
    push_steps_ = std::lround(seconds / params_.physics_dt);
  }

  void cut(LegId leg) { robot_.cut(leg); }
  void weaken(LegId leg, int joint, double share) { robot_.servos().weaken(leg, joint, share); }

  const GroundTruth& truth() const { return truth_; }
  const LegArray<LegJoints>& efforts() const { return robot_.servos().efforts(); }
  const Terrain& terrain() const { return ground_.terrain(); }
  double range(const Vector3& from_W, const Vector3& direction_W, double longest) {
    return ground_.range(from_W, direction_W, longest);
  }

 private:
  void step(double to_come) {
    const long complaints = detail::solver_complaints();
    contacts_.find(ground_, robot_.shapes());
    const LegArray<LegJoints> q = robot_.servos().q();
    robot_.step(to_come, push_steps_ > 0 ? push_ : Vector3::Zero());
    if (push_steps_ > 0) --push_steps_;
    truth_.solver_complaints += detail::solver_complaints() > complaints ? 1 : 0;
    truth_.finite = robot_.is_sane();
    if (!truth_.finite) return;

    truth_.time = ++steps_ * params_.physics_dt;
    record_motion();
    record_work(q);
    record_contacts(contacts_.touches(), params_.physics_dt, truth_);
    feel_contacts();
  }

  // @param v_W  velocity a control period ago [m/s]
  void feel_acceleration(const Vector3& v_W) {
    const Matrix3& R_WB = truth_.X_WB.R;
    const Vector3 change_W = R_WB * truth_.V_WB.v - v_W;
    acceleration_B_ = R_WB.transpose() * (change_W / params_.control_dt + up_);
  }

  void record_motion() {
    truth_.X_WB = robot_.X_WB();
    truth_.V_WB = robot_.V_WB();
    for (LegId leg = 0; leg < truth_.feet.size(); ++leg) truth_.feet[leg].p_WF = robot_.p_WF(leg);
  }

  // @param q  before the step
  void record_work(const LegArray<LegJoints>& q) {
    const LegArray<LegJoints>&after = robot_.servos().q(), &effort = efforts();
    for (LegId leg = 0; leg < q.size(); ++leg)
      for (int k = 0; k < num_joints_[leg]; ++k)
        truth_.work += std::abs(effort[leg][k] * (after[leg][k] - q[leg][k]));
  }

  void feel_contacts() {
    for (LegId leg = 0; leg < felt_.size(); ++leg) {
      if (truth_.feet[leg].normal_force > params_.contact_threshold) felt_[leg] = true;
    }
  }

  WorldParams params_;
  int physics_steps_;  // per control period
  int steps_ = 0;      // since the start
  detail::ThreadingPtr threading_;
  detail::WorldPtr world_;
  detail::Ground ground_;
  detail::Contacts contacts_;
  detail::Robot robot_;
  LegArray<int> num_joints_;
  LegArray<bool> felt_;          // contact in any step of the control period
  Vector3 up_, acceleration_B_;  // minus gravity; what the inertial measurement unit feels [m/s²]
  Vector3 push_ = Vector3::Zero();  // on the base [N]
  long push_steps_ = 0;             // remaining
  GroundTruth truth_;
};

double physics_step_for(double control_dt, double longest) {
  return control_dt / std::ceil(control_dt / longest - 1e-9);
}

WorldParams completed(WorldParams params, const RobotModel& robot) {
  RobotParams all = none_derived();
  all.plant = params;
  static_cast<PlantParams&>(params) = completed(all, robot, params.gravity).plant;
  if (is_derived(params.physics_dt))
    params.physics_dt = physics_step_for(params.control_dt, params.longest_step);
  return params;
}

std::span<const Imperfection<WorldParams>> imperfections() {
  static constexpr Imperfection<WorldParams> kAll[] = {
      {"friction", &WorldParams::friction, PlantUnit::number, 0.0, 10.0,
       "Coefficient of friction between feet and ground"},
      {"contact_threshold", &WorldParams::contact_threshold, PlantUnit::force, 0.0, 1e5,
       "Force from which a foot's contact sensor closes"},
      {"servo_lag", &WorldParams::servo_lag, PlantUnit::time, 0.0, 1.0,
       "Servos follow their targets with this time constant"},
      {"drive_friction", &WorldParams::drive_friction, PlantUnit::torque, 0.0, 1e4,
       "Dry friction of every drive"},
      {"backlash", &WorldParams::backlash, PlantUnit::angle, 0.0, 0.2,
       "Play of every gear, to both sides together"},
      {"armature", &WorldParams::armature, PlantUnit::inertia, 0.0, 1e3,
       "Inertia of every drive's rotor, seen at the joint"},
      {"mass_error", &WorldParams::mass_error, PlantUnit::share, 0.0, 0.9,
       "Every link is heavier or lighter by this than the controller thinks"}};
  return kAll;
}

World::World(const RobotModel& robot, const TerrainSpec& terrain, const WorldParams& params,
             const LegArray<LegJoints>& q) {
  const WorldParams complete = completed(params, robot);
  detail::check(robot, complete, q);
  detail::initialise_ode();
  impl_ = std::make_unique<Impl>(robot, terrain, complete, q);
}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

PlantStatus World::read(Measurement& measurement) { return impl_->read(measurement); }
void World::write(const JointTargets& targets) { impl_->write(targets); }
void World::push(const Vector3& force_W, double seconds) { impl_->push(force_W, seconds); }
void World::cut(LegId leg) { impl_->cut(leg); }
void World::weaken(LegId leg, int joint, double share) { impl_->weaken(leg, joint, share); }
const GroundTruth& World::truth() const { return impl_->truth(); }
const LegArray<LegJoints>& World::efforts() const { return impl_->efforts(); }
const Terrain& World::terrain() const { return impl_->terrain(); }
double World::range(const Vector3& from_W, const Vector3& direction_W, double longest) const {
  return impl_->range(from_W, direction_W, longest);
}

}  // namespace hexagait::sim3d
