// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gnu/libc-version.h>

#include <bit>
#include <cctype>
#include <hexagait/recording/detail/walk_json.hpp>
#include <hexagait/recording/provenance.hpp>
#include <hexagait/recording/version.hpp>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sim2d/engine_version.hpp>
#include <hexagait/sim3d/engine_version.hpp>

// Parameters that can follow from the robot come from the table of parameters(). The other structs are taken apart by
// structured bindings: a new field that is not listed here does not compile. What a result's configuration has is left out.
namespace hexagait::recording {
namespace {

using Parameters = Provenance::Parameters;

void append(Parameters& to, const std::string& prefix, const Parameters& more) {
  for (const auto& [name, value] : more) to.emplace_back(prefix + name, value);
}

// ---- three dimensions -------------------------------------------------------------------------

// "m/s²" as the ending of a name: "_m_s2".
std::string suffix(std::string_view unit) {
  if (unit == "1") return "";
  std::string text = "_";
  for (const char letter : unit) {
    if (letter == '/' || letter == ' ') text += '_';
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0)
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return unit.ends_with("²") ? text + "2" : text;
}

// Those of the robot's parameters whose names begin so.
Parameters parameters(RobotParams params, std::string_view prefix) {
  Parameters some;
  for (const Parameter& one : hexagait::parameters()) {
    const std::string_view name = one.name;
    if (name.starts_with(prefix))
      some.emplace_back(std::string(name) + suffix(one.unit), one.in(params));
  }
  return some;
}

Parameters parameters(const sim3d::WorldParams& params) {
  RobotParams robot;
  robot.plant = params;
  Parameters all = {{"physics_dt_s", params.physics_dt},
                    {"control_dt_s", params.control_dt},
                    {"gravity_m_s2", params.gravity},
                    {"velocity_limits", params.velocity_limits},
                    {"drive_friction_n_m", params.drive_friction},
                    {"backlash_rad", params.backlash},
                    {"armature_kg_m2", params.armature},
                    {"servo_lag_s", params.servo_lag},
                    {"mass_error", params.mass_error},
                    {"friction", params.friction},
                    {"contact_erp", params.contact_erp},
                    {"hinge_erp", params.hinge_erp}};
  append(all, "", parameters(robot, "plant."));
  return all;
}

Parameters parameters(const VirtualModelParams& params) {
  const auto& [frequency, turn_frequency, damping, turn_damping, friction, least, most] = params;
  return {{"frequency_rad_s", frequency},
          {"turn_frequency_rad_s", turn_frequency},
          {"damping_ratio", damping},
          {"turn_damping_ratio", turn_damping},
          {"friction", friction},
          {"least_load", least},
          {"most_load", most}};
}

Parameters parameters(const footstep_gen::WalkerParams& params) {
  const auto& [control_dt, sensors, gait, stepper, step, executor, tolerance, late_limit,
               finds_faults, resolves_deadlocks] = params;
  const auto& [swing, base, gravity, controller, virtual_model] = executor;
  RobotParams robot;
  robot.step = step;
  robot.swing = swing;
  robot.base = base;
  robot.tolerance = tolerance;
  Parameters all = {{"late_limit_s", late_limit},
                    {"finds_faults", finds_faults ? 1.0 : 0.0},
                    {"resolves_deadlocks", resolves_deadlocks ? 1.0 : 0.0},
                    {"gravity_m_s2", gravity},
                    {"whole_body_controller", static_cast<double>(controller)},
                    {"step.roughness_gain", step.roughness_gain},
                    {"step.urgent_share", step.urgent_share},
                    {"swing.clearance_share", swing.clearance_share},
                    {"swing.max_retreats", swing.max_retreats},
                    {"swing.max_bounces", swing.max_bounces},
                    {"swing.reflexes", swing.reflexes}};
  for (const char* prefix : {"step.", "swing.", "base.", "gait.", "tolerance."})
    append(all, "", parameters(robot, prefix));
  append(all, "virtual_model.", parameters(virtual_model));
  return all;
}

// ---- side view --------------------------------------------------------------------------------

Parameters parameters(const sim2d::GenghisWorldParams& params) {
  const auto& [physics_dt, control_dt, seed, gravity, foot_friction, body_friction, lift_kp,
               lift_kd, lift_limit, swing_kp, swing_kd, swing_limit] = params;
  return {{"physics_dt_s", physics_dt},     {"control_dt_s", control_dt},
          {"gravity_m_s2", gravity},        {"foot_friction", foot_friction},
          {"body_friction", body_friction}, {"lift_kp_n_m", lift_kp},
          {"lift_kd_n_s_m", lift_kd},       {"lift_limit_n", lift_limit},
          {"swing_kp_n_m_rad", swing_kp},   {"swing_kd_n_m_s_rad", swing_kd},
          {"swing_limit_n_m", swing_limit}};
}

Parameters parameters(const sim2d::GenghisParams& params) {
  const auto& [control_dt, gait, backward, tie, half_stroke, clearance, gain, raise, advance,
               acceleration, descent, body_speed, body_acceleration, posture_rate, vertical,
               pitch_speed, max_pitch, usable, urgent, touchdown_load, lost_load, lost_time,
               blocked, retreat, raise_more, drop, patience, search_step] = params;
  return {{"tie_tolerance_m", tie},
          {"half_stroke_m", half_stroke},
          {"clearance_m", clearance},
          {"roughness_gain", gain},
          {"raise_speed_m_s", raise},
          {"advance_speed_m_s", advance},
          {"swing_acceleration_m_s2", acceleration},
          {"descent_speed_m_s", descent},
          {"body_speed_m_s", body_speed},
          {"body_acceleration_m_s2", body_acceleration},
          {"posture_rate_1_s", posture_rate},
          {"vertical_speed_m_s", vertical},
          {"pitch_speed_rad_s", pitch_speed},
          {"max_pitch_rad", max_pitch},
          {"usable_share", usable},
          {"urgent_share", urgent},
          {"touchdown_load_n", touchdown_load},
          {"lost_load_n", lost_load},
          {"lost_time_s", lost_time},
          {"blocked_error_m", blocked},
          {"retreat_m", retreat},
          {"raise_more_m", raise_more},
          {"presumed_drop_m", drop},
          {"patience_s", patience},
          {"search_step_m", search_step}};
}

// ---- models -----------------------------------------------------------------------------------

class ModelHash {
 public:
  void add(const std::string& text) { hash_ = fnv1a(std::uint8_t{0}, fnv1a(text, hash_)); }
  void add(double value) { hash_ = fnv1a(std::bit_cast<std::uint64_t>(value), hash_); }
  template <class Derived>
  void add(const Eigen::MatrixBase<Derived>& values) {
    for (Eigen::Index k = 0; k < values.size(); ++k)
      add(values(k % values.rows(), k / values.rows()));
  }
  template <class Value>
  void add(const std::vector<Value>& values) {
    for (const Value& value : values) add(value);
  }
  void add(const Pose& pose) { add_all(pose.p, pose.R); }
  void add(const Shape& shape) { add_all(static_cast<double>(shape.kind), shape.size, shape.X_LS); }
  void add(const LinkModel& link) {
    add_all(link.name, link.mass, link.p_LM, link.inertia_M_L, link.shapes, link.X_BL0);
  }
  void add(const LegModel& leg) {
    add_all(leg.name, static_cast<double>(leg.kind), leg.X_BH, leg.coxa, leg.femur, leg.tibia,
            leg.joint_sign, leg.joint_offset);
    for (int k = 0; k < leg.num_joints(); ++k) {
      const auto& [lower, upper, velocity, effort] = leg.limits[k];
      add_all(leg.joint_names[k], lower, upper, velocity, effort, leg.links[k], leg.p_BJ0[k],
              leg.axis_B0[k]);
    }
    add_all(leg.p_BF0, leg.p_BC, leg.q_nominal, leg.workspace_radius, leg.min_reach, leg.max_reach);
  }
  template <class... Values>
  void add_all(const Values&... values) {
    (add(values), ...);
  }

  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = kFnv1aBasis;
};

std::uint64_t model_hash(const sim2d::GenghisModel& model) {
  const auto& [length, height, belly, bevel, foot, leg, max_lift, max_swing, body_mass, leg_mass,
               hip_x, splay, stance, workspace, hip_y, foot_y] = model;
  ModelHash hash;
  hash.add_all(length, height, belly, bevel, foot, leg, max_lift, max_swing, body_mass, leg_mass,
               splay, stance, workspace, hip_y, foot_y);
  for (const double x : hip_x) hash.add(x);
  return hash.value();
}

Json object(const Parameters& parameters) {
  Json json = Json::object();
  for (const auto& [name, value] : parameters) json[name] = value;
  return json;
}

}  // namespace

std::uint64_t model_hash(const RobotModel& robot) {
  ModelHash hash;
  hash.add(robot.base);
  for (const LegModel& leg : robot.legs) hash.add(leg);
  hash.add(robot.foot_radius);
  return hash.value();
}

Provenance provenance() {
  return {.version = kVersion,
          .revision = kRevision,
          .compiler = kCompiler,
          .libraries = {{"ODE", sim3d::engine_version()},
                        {"Box2D", sim2d::engine_version()},
                        {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                              EIGEN_MINOR_VERSION)},
                        {"yaml-cpp", kYamlCppVersion},
                        {"libc", gnu_get_libc_version()}},
          .robots = {},
          .physics = {},
          .controller = {}};
}

Provenance provenance(const std::string& name, const RobotModel& robot,
                      const Simulation& simulation) {
  Provenance result = provenance();
  result.robots = {{name, model_hash(robot)}};
  result.physics = parameters(completed(world_params(simulation), robot));
  result.controller = parameters(footstep_gen::completed(walker_params(simulation), robot));
  return result;
}

Provenance provenance(const sim2d::GenghisTrial& trial) {
  Provenance result = provenance();
  result.robots = {{"genghis2d", model_hash(sim2d::GenghisModel{})}};
  sim2d::GenghisWorldParams world;
  world.physics_dt = trial.physics_dt;
  world.control_dt = trial.control_dt;
  result.physics = parameters(world);
  result.controller = parameters(trial.controller);
  return result;
}

Json json(const Provenance& provenance) {
  Json json{{"version", provenance.version},
            {"revision", provenance.revision},
            {"compiler", provenance.compiler}};
  for (const auto& [name, version] : provenance.libraries) json["libraries"][name] = version;
  for (const Provenance::Robot& robot : provenance.robots)
    json["robots"].push_back({{"name", robot.name}, {"model", hex(robot.model_hash)}});
  if (!provenance.physics.empty()) json["physics"] = object(provenance.physics);
  if (!provenance.controller.empty()) json["controller"] = object(provenance.controller);
  return json;
}

}  // namespace hexagait::recording
