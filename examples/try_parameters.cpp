// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
// What a parameter does: walks 20 s straight ahead with it, on three seeds of a terrain, and prints
// the means. docs/parameters.md has a table of what came out.
//
//   try_parameters ROBOT.urdf TERRAIN [NAME=VALUE | size=SCALE]...
//   try_parameters robots/argos.urdf boxes:0.10 step.stroke=0.24
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/trial.hpp>
#include <map>
#include <string>

using namespace hexagait;

struct Setup {
  footstep_gen::WalkerParams walker;
  sim3d::WorldParams world;
};

// Every parameter that can be set, by its name.
std::map<std::string, double*> parameters_of(Setup& s) {
  footstep_gen::StepParams& step = s.walker.step;
  SwingParams& swing = s.walker.executor.swing;
  BaseParams& base = s.walker.executor.base;
  return {{"step.stroke", &step.stroke},
          {"step.height", &step.height},
          {"step.roughness_gain", &step.roughness_gain},
          {"step.max_height", &step.max_height},
          {"step.urgent_share", &step.urgent_share},
          {"step.stability_margin", &step.stability_margin},
          {"gait.tie_tolerance", &s.walker.gait.tie_tolerance},
          {"executor.gravity", &s.walker.executor.gravity},
          {"swing.unload_time", &swing.unload_time},
          {"swing.load_time", &swing.load_time},
          {"swing.even_load_rate", &swing.even_load_rate},
          {"swing.lift_time", &swing.lift_time},
          {"swing.clearance_share", &swing.clearance_share},
          {"swing.transfer_time", &swing.transfer_time},
          {"swing.max_speed", &swing.max_speed},
          {"swing.overlap_time", &swing.overlap_time},
          {"swing.descent_speed", &swing.descent_speed},
          {"swing.touchdown_speed", &swing.touchdown_speed},
          {"swing.touchdown_margin", &swing.touchdown_margin},
          {"swing.search_speed", &swing.search_speed},
          {"swing.vertical_acceleration", &swing.vertical_acceleration},
          {"swing.commit_height", &swing.commit_height},
          {"swing.retreat_back", &swing.retreat_back},
          {"swing.retreat_up", &swing.retreat_up},
          {"swing.retreat_time", &swing.retreat_time},
          {"swing.blocked_error", &swing.blocked_error},
          {"swing.confirm_time", &swing.confirm_time},
          {"swing.lost_time", &swing.lost_time},
          {"swing.regain_time", &swing.regain_time},
          {"swing.slide_distance", &swing.slide_distance},
          {"swing.slide_time", &swing.slide_time},
          {"base.acceleration", &base.acceleration},
          {"base.max_speed", &base.max_speed},
          {"base.advance_rate", &base.advance_rate},
          {"base.correction_rate", &base.correction_rate},
          {"base.correction_speed", &base.correction_speed},
          {"base.correction_turn", &base.correction_turn},
          {"base.posture_rate", &base.posture_rate},
          {"base.height_speed", &base.height_speed},
          {"base.tilt_speed", &base.tilt_speed},
          {"base.outer_radius", &base.outer_radius},
          {"world.friction", &s.world.friction},
          {"world.servo_kp", &s.world.servo_kp},
          {"world.servo_kd", &s.world.servo_kd},
          {"world.contact_threshold", &s.world.contact_threshold}};
}

// For a robot of `s` times the size of argos and s³ times its mass, at the same step times: lengths and
// speeds by s, forces by s³, torques and with them servo gains by s⁴.
void resize(std::map<std::string, double*>& parameters, double s) {
  for (const char* length_or_speed : {"step.stroke",
                                      "step.height",
                                      "step.max_height",
                                      "step.stability_margin",
                                      "gait.tie_tolerance",
                                      "swing.max_speed",
                                      "swing.descent_speed",
                                      "swing.touchdown_speed",
                                      "swing.touchdown_margin",
                                      "swing.search_speed",
                                      "swing.vertical_acceleration",
                                      "swing.commit_height",
                                      "swing.retreat_back",
                                      "swing.retreat_up",
                                      "swing.blocked_error",
                                      "swing.slide_distance",
                                      "base.acceleration",
                                      "base.max_speed",
                                      "base.correction_speed",
                                      "base.height_speed",
                                      "base.outer_radius"})
    *parameters.at(length_or_speed) *= s;
  *parameters.at("world.contact_threshold") *= s * s * s;
  *parameters.at("world.servo_kp") *= s * s * s * s;
  *parameters.at("world.servo_kd") *= s * s * s * s;
}

Setup setup_from(int argc, char** argv) {
  Setup setup;
  std::map<std::string, double*> parameters = parameters_of(setup);
  for (int k = 3; k < argc; ++k) {
    const std::string text = argv[k], name = text.substr(0, text.find('='));
    const char* digits = argv[k] + std::min(name.size() + 1, text.size());
    char* end = nullptr;
    const double value = std::strtod(digits, &end);
    if ((name != "size" && !parameters.contains(name)) || end == digits || *end != '\0')
      throw InvalidInput("'" + text + "' is not NAME=VALUE with a name of docs/parameters.md");
    if (name == "size")
      resize(parameters, value);
    else
      *parameters[name] = value;
  }
  return setup;
}

int main(int argc, char** argv) try {
  if (argc < 3)
    return std::fputs("usage: try_parameters ROBOT.urdf TERRAIN [NAME=VALUE]...\n", stderr), 2;
  const RobotModel model = load_urdf(argv[1]);
  const sim3d::TerrainSpec terrain = sim3d::parse_terrain(argv[2]);
  Setup setup = setup_from(argc, argv);
  walk::Summary sum;
  int falls = 0, stuck = 0;
  constexpr int kSeeds = 3;
  for (setup.world.seed = 1; setup.world.seed <= kSeeds; ++setup.world.seed) {
    sim3d::World world(model, terrain, setup.world, walk::nominal_posture(model));
    footstep_gen::Walker walker(model, setup.walker);
    walk::TrialOptions options;
    options.schedule = {{0.0, heading_control::Heading::straight(0.0), {}}};
    options.seconds = 20.0;
    const walk::Summary s = walk::run_trial(walker, world, world.truth(), options);
    sum.speed += s.speed / kSeeds;
    sum.lateral_mean += s.lateral_mean / kSeeds;
    sum.slip_p95 += s.slip_p95 / kSeeds;
    sum.margin_p5 += s.margin_p5 / kSeeds;
    sum.contact_losses += s.contact_losses;
    falls += s.fell;
    stuck += s.stuck;
  }
  std::printf(
      "%.3f m/s, %.1f mm off the path, slip %.1f mm (95 %%), margin %.1f cm (5 %%), contact lost "
      "%d "
      "times, %d fell, %d stuck\n",
      sum.speed, sum.lateral_mean * 1e3, sum.slip_p95 * 1e3, sum.margin_p5 * 1e2,
      sum.contact_losses, falls, stuck);
  return falls + stuck > 0 ? 1 : 0;
} catch (const InvalidInput& error) {
  return std::fprintf(stderr, "try_parameters: %s\n", error.what()), 2;
}
