// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gnu/libc-version.h>

#include <bit>
#include <hexagait/recording/detail/walk_json.hpp>
#include <hexagait/recording/provenance.hpp>
#include <hexagait/recording/version.hpp>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sim2d/engine_version.hpp>
#include <hexagait/sim3d/engine_version.hpp>

// Parameters are taken apart by structured bindings: a field that is added and not listed here does
// not compile. What the configuration of a result names already is left out.
namespace hexagait::recording {
namespace {

using Parameters = Provenance::Parameters;

void append(Parameters& to, const std::string& prefix, const Parameters& more) {
  for (const auto& [name, value] : more) to.emplace_back(prefix + name, value);
}

// ---- three dimensions -------------------------------------------------------------------------

Parameters parameters(const sim3d::WorldParams& params) {
  const auto& [physics_dt, control_dt, seed, gravity, kp, kd, kv, servo_friction, velocity_limits,
               drive_friction, armature, servo_lag, mass_error, friction, threshold, contact_erp,
               contact_cfm, correcting_speed, hinge_erp, hinge_cfm, start, clearance, height,
               blocks, on_stand] = params;
  return {{"physics_dt_s", physics_dt},
          {"control_dt_s", control_dt},
          {"gravity_m_s2", gravity},
          {"servo_kp_n_m_rad", kp},
          {"servo_kd_n_m_s_rad", kd},
          {"servo_kv_n_m_s_rad", kv},
          {"servo_friction_n_m_s_rad", servo_friction},
          {"velocity_limits", velocity_limits},
          {"drive_friction_n_m", drive_friction},
          {"armature_kg_m2", armature},
          {"servo_lag_s", servo_lag},
          {"mass_error", mass_error},
          {"friction", friction},
          {"contact_threshold_n", threshold},
          {"contact_erp", contact_erp},
          {"contact_cfm_m_n_s", contact_cfm},
          {"contact_correcting_speed_m_s", correcting_speed},
          {"hinge_erp", hinge_erp},
          {"hinge_cfm", hinge_cfm},
          {"start_clearance_m", clearance}};
}

Parameters parameters(const footstep_gen::StepParams& params) {
  const auto& [stroke, height, roughness_gain, max_height, urgent_share, stability_margin] = params;
  return {{"stroke_m", stroke},
          {"height_m", height},
          {"roughness_gain", roughness_gain},
          {"max_height_m", max_height},
          {"urgent_share", urgent_share},
          {"stability_margin_m", stability_margin}};
}

Parameters parameters(const SwingParams& params) {
  const auto& [unload, load, even_load, lift, clearance, transfer, max_speed, overlap, descent,
               touchdown, margin, search, acceleration, commit, back, up, blocked, retreat,
               retreats, touch, confirm, lost, regain, slide_distance, slide_time, reflexes,
               search_time, follow_rate] = params;
  return {{"unload_time_s", unload},
          {"load_time_s", load},
          {"even_load_rate_1_s", even_load},
          {"lift_time_s", lift},
          {"clearance_share", clearance},
          {"transfer_time_s", transfer},
          {"max_speed_m_s", max_speed},
          {"overlap_time_s", overlap},
          {"descent_speed_m_s", descent},
          {"touchdown_speed_m_s", touchdown},
          {"touchdown_margin_m", margin},
          {"search_speed_m_s", search},
          {"vertical_acceleration_m_s2", acceleration},
          {"commit_height_m", commit},
          {"retreat_back_m", back},
          {"retreat_up_m", up},
          {"blocked_error_m", blocked},
          {"retreat_time_s", retreat},
          {"max_retreats", retreats},
          {"touch_time_s", touch},
          {"confirm_time_s", confirm},
          {"lost_time_s", lost},
          {"regain_time_s", regain},
          {"slide_distance_m", slide_distance},
          {"slide_time_s", slide_time},
          {"reflexes", reflexes},
          {"search_time_s", search_time},
          {"follow_rate_1_s", follow_rate}};
}

Parameters parameters(const BaseParams& params) {
  const auto& [acceleration, max_speed, advance_rate, correction_rate, correction_speed,
               correction_turn, posture_rate, height_speed, tilt_speed, outer_radius] = params;
  return {{"acceleration_m_s2", acceleration},        {"max_speed_m_s", max_speed},
          {"advance_rate_1_s", advance_rate},         {"correction_rate_1_s", correction_rate},
          {"correction_speed_m_s", correction_speed}, {"correction_turn_rad_s", correction_turn},
          {"posture_rate_1_s", posture_rate},         {"height_speed_m_s", height_speed},
          {"tilt_speed_rad_s", tilt_speed},           {"outer_radius_m", outer_radius}};
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
  const auto& [control_dt, sensors, gait, stepper, step, executor, late_limit] = params;
  const auto& [swing, base, gravity, controller, virtual_model] = executor;
  Parameters all = {{"late_limit_s", late_limit},
                    {"gait.tie_tolerance_m", gait.tie_tolerance},
                    {"gravity_m_s2", gravity},
                    {"whole_body_controller", static_cast<double>(controller)}};
  append(all, "step.", parameters(step));
  append(all, "swing.", parameters(swing));
  append(all, "base.", parameters(base));
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
  result.physics = parameters(world_params(simulation));
  result.controller = parameters(walker_params(simulation));
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
