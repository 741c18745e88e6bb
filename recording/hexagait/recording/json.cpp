// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/recording/detail/walk_json.hpp>
#include <hexagait/recording/json.hpp>
#include <hexagait/recording/version.hpp>
#include <hexagait/walk/paths/path_file.hpp>
#include <nlohmann/json.hpp>

namespace hexagait::recording {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr int kIndent = 2;

std::string kind(const Heading& heading) {
  if (!heading.moving()) return "stop";
  if (heading.rho() <= 0.0) return heading.turn() == Turn::ccw ? "spin ccw" : "spin cw";
  return heading.curvature() == 0.0 ? "straight" : "arc";
}

Json commands(const walk::Schedule& schedule) {
  Json list = Json::array();
  for (const walk::TimedCommand& command : schedule)
    list.push_back({{"at_s", command.time},
                    {"heading", kind(command.heading)},
                    {"curvature_per_m", finite(command.heading.curvature())},
                    {"crab_rad", command.heading.crab_angle()},
                    {"duty_factor", json_of(command.duty_factor)}});
  return list;
}

Json path_asked(const walk::TrialOptions& trial) {
  const path_following::PathTask& task = *trial.path;
  return {{"lap_m", task.path.length()},
          {"closed", task.path.closed()},
          {"laps", task.laps},
          {"facing", walk::to_string(task.facing)},
          {"look_ahead_m", task.look_ahead},
          {"localisation", walk::to_string(trial.localised_by)}};
}

Json path_results(const walk::PathSummary& path) {
  return {{"length_m", path.length},
          {"done_m", path.done},
          {"believed_error_m", {{"mean", path.believed_mean}, {"max", path.believed_max}}},
          {"missed_m", path.missed},
          {"end_error_m", path.off_end}};
}

Json leg_json(const LegModel& leg) {
  Json joints = Json::array();
  for (int k = 0; k < leg.num_joints(); ++k)
    joints.push_back({{"name", leg.joint_names[k]},
                      {"lower_rad", finite(leg.limits[k].lower)},
                      {"upper_rad", finite(leg.limits[k].upper)},
                      {"velocity_rad_s", finite(leg.limits[k].velocity)},
                      {"effort_n_m", finite(leg.limits[k].effort)}});
  constexpr const char* kKinds[] = {"yaw_pitch_pitch", "serial", "yaw_pitch"};
  const bool serial = leg.kind == LegKind::serial;
  Json json = {{"name", leg.name}, {"kind", kKinds[static_cast<int>(leg.kind)]}};
  if (!serial) {
    json["coxa_m"] = leg.coxa;
    json["femur_m"] = leg.femur;
    json["tibia_m"] = leg.tibia;
  }
  json["hip_m"] = {leg.X_BH.p.x(), leg.X_BH.p.y(), leg.X_BH.p.z()};
  json["workspace_centre_m"] = {leg.p_BC.x(), leg.p_BC.y(), leg.p_BC.z()};
  json["workspace_radius_m"] = leg.workspace_radius;
  json["reach_m"] = {{"min", leg.min_reach}, {"max", leg.max_reach}};
  json["joints"] = joints;
  return json;
}

}  // namespace

Json json(const PlantSetup& plant) {
  Json json = {{"name", plant.name}};
  for (const PlantNumber& number : plant_numbers()) json[name_with_unit(number)] = number.of(plant);
  json["velocity_limits"] = plant.world.velocity_limits;
  json["positions_only"] = plant.faults.positions_only;
  json["faults"] = Json::array();
  for (const walk::PartFault& fault : plant.parts) json["faults"].push_back(fault.text);
  return json;
}

Json configuration(const WalkReport& report) {
  const Simulation& simulation = report.simulation;
  const walk::Schedule& schedule = simulation.trial.schedule;
  const Heading& first = schedule.front().heading;
  return {{"robot", report.robot},
          {"terrain", terrain_of(report)},
          {"seed", simulation.seed},
          {"heading", simulation.trial.path  ? "path"
                      : schedule.size() == 1 ? kind(first)
                                             : "schedule"},
          {"curvature_per_m", schedule.size() == 1 ? finite(first.curvature()) : Json(nullptr)},
          {"crab_rad", schedule.size() == 1 ? finite(first.crab_angle()) : Json(nullptr)},
          {"commands", simulation.trial.path ? Json::array() : commands(schedule)},
          {"seconds_asked", simulation.trial.seconds},
          {"distance_asked_m", finite(simulation.trial.distance)},
          {"gait", gait_state::to_string(simulation.gait)},
          {"random_posture_m", simulation.random_posture},
          {"foot_contacts", !simulation.gait.open_loop && simulation.sensors.foot_contacts},
          {"joint_feedback", !simulation.gait.open_loop && simulation.sensors.joint_feedback},
          {"plant", json(simulation.plant)},
          {"physics_step_s", simulation.physics_dt},
          {"control_period_s", simulation.control_dt}};
}

Json results(const walk::Summary& s) {
  return {{"seconds", s.seconds},
          {"distance_m", s.distance},
          {"turned_rad", s.turned},
          {"speed_m_s", s.speed},
          {"lateral_error_m",
           {{"mean", s.lateral_mean}, {"max", s.lateral_max}, {"end", s.lateral_end}}},
          {"heading_error_rad", {{"max", s.heading_max}, {"end", s.heading_end}}},
          {"odometry_error",
           {{"position_m", finite(s.odometry_position)},
            {"heading_rad", finite(s.odometry_heading)},
            {"height_m", finite(s.odometry_height)},
            {"tilt_rad", finite(s.odometry_tilt)}}},
          {"slip_m", {{"mean", finite(s.slip_mean)}, {"p95", finite(s.slip_p95)}}},
          {"touchdown_speed_m_s",
           {{"median", finite(s.touchdown_median)}, {"p95", finite(s.touchdown_p95)}}},
          {"stances", s.stances},
          {"stability_margin_m", {{"min", finite(s.margin_min)}, {"p5", finite(s.margin_p5)}}},
          {"cost_of_transport", finite(s.cost_of_transport)},
          {"roll_rad", {{"max", s.roll_max}}},
          {"pitch_rad", {{"max", s.pitch_max}}},
          {"body_height_m", {{"min", s.height_min}, {"max", s.height_max}}},
          {"steps", s.steps},
          {"tripod_after_steps", json_of(s.tripod_after_steps)},
          {"rule1_violations", s.rule1_violations},
          {"rule1_commanded", s.rule1_commanded},
          {"neighbour_flight_s", s.neighbour_flight},
          {"leg_touch_s", s.leg_touch_time},
          {"contact_losses", s.contact_losses},
          {"real_contact_losses", s.real_contact_losses},
          {"fell", s.fell},
          {"stuck", s.stuck},
          {"arrived", s.arrived},
          {"fault", footstep_gen::to_string(s.fault)},
          {"state_hash", hex(s.state_hash)}};
}

Json results(const WalkReport& report) {
  Json json = results(report.summary);
  json["fell_because"] =
      report.summary.fell ? Json(walk::fall_in_words(report.summary)) : Json(nullptr);
  json["stuck_because"] = report.hindrance.empty() ? Json(nullptr) : Json(report.hindrance);
  json["found"] = report.found;
  if (!report.side_view) return json;
  json["underside_contact_s"] = report.side_view->underside_time;
  json["blocked_advances"] = report.side_view->blocked;
  json["foothold_searches"] = report.side_view->searches;
  return json;
}

Json timing(const walk::Summary& s) {
  return {{"real_time_factor", finite(s.real_time_factor)},
          {"tick_ns", {{"median", s.tick_median}, {"p99", s.tick_p99}}}};
}

WalkReport report_of(const sim2d::GenghisTrial& trial) {
  WalkReport report{.robot = "genghis2d", .simulation = {}, .summary = {}};
  report.simulation.seed = trial.seed;
  report.simulation.physics_dt = trial.physics_dt;
  report.simulation.control_dt = trial.control_dt;
  report.simulation.gait = trial.gait;
  report.simulation.random_posture = trial.random_posture;
  const double crab = trial.backward ? std::numbers::pi : 0.0;
  report.simulation.trial.schedule = {{0.0, Heading::straight(crab)}};
  report.simulation.trial.seconds = trial.seconds;
  report.simulation.trial.distance = trial.distance;
  report.side_view = SideView{.terrain = trial.terrain};
  return report;
}

void take(WalkReport& report, const GenghisSummary& summary) {
  report.summary = summary;
  report.side_view = summary.side_view;
}

std::string terrain_of(const WalkReport& report) {
  return report.side_view ? sim2d::to_string(report.side_view->terrain)
                          : sim3d::to_string(report.simulation.terrain);
}

std::string to_json(const WalkReport& report, const std::vector<std::string>& files) {
  Json json = {{"schema", kJsonSchema}};
  json.update(configuration(report));
  if (report.simulation.trial.path) json["path_asked"] = path_asked(report.simulation.trial);
  json.update(results(report));
  if (report.summary.path) json["path"] = path_results(*report.summary.path);
  json.update(timing(report.summary));
  json["interrupted"] = report.interrupted;
  json["files"] = files;
  json["version"] = kVersion;
  return json.dump(kIndent);
}

std::string to_json(const RobotModel& robot) {
  Json substitutions = Json::array();
  for (const Substitution& s : robot.substitutions)
    substitutions.push_back({{"origin", to_string(s.origin)},
                             {"element", s.element},
                             {"line", s.line},
                             {"what", s.what},
                             {"found", s.found},
                             {"used", s.used},
                             {"option", s.option}});
  Json legs = Json::array();
  for (const LegModel& leg : robot.legs) legs.push_back(leg_json(leg));
  return Json{{"schema", kJsonSchema},
              {"name", robot.name},
              {"mass_kg", robot.mass},
              {"base_mass_kg", robot.base.mass},
              {"centre_of_mass_m", {robot.p_BM.x(), robot.p_BM.y(), robot.p_BM.z()}},
              {"foot_radius_m", robot.foot_radius},
              {"legs", legs},
              {"substitutions", substitutions}}
      .dump(kIndent);
}

}  // namespace hexagait::recording
