// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
// What a parameter does: walks 20 s straight ahead with it, on three seeds of a terrain, and prints
// the means. docs/parameters.md has a table of what came out.
//
//   try_parameters ROBOT.urdf TERRAIN [NAME=VALUE]...
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

// What follows from the robot, and what does not.
struct Setup {
  RobotParams robot;
  footstep_gen::WalkerParams walker;
  sim3d::WorldParams world;
};

// Every parameter that can be set, by its name.
std::map<std::string, double*> parameters_of(Setup& s) {
  std::map<std::string, double*> all = {{"step.roughness_gain", &s.robot.step.roughness_gain},
                                        {"step.urgent_share", &s.robot.step.urgent_share},
                                        {"swing.clearance_share", &s.robot.swing.clearance_share},
                                        {"executor.gravity", &s.walker.executor.gravity},
                                        {"world.friction", &s.world.friction}};
  for (const Parameter& one : parameters()) all[one.name] = &one.in(s.robot);
  return all;
}

Setup setup_from(const RobotModel& model, int argc, char** argv) {
  Setup setup;
  setup.robot = params_for(model);
  const std::map<std::string, double*> parameters = parameters_of(setup);
  for (int k = 3; k < argc; ++k) {
    const std::string text = argv[k], name = text.substr(0, text.find('='));
    const char* digits = argv[k] + std::min(name.size() + 1, text.size());
    char* end = nullptr;
    const double value = std::strtod(digits, &end);
    if (!parameters.contains(name) || end == digits || *end != '\0')
      throw InvalidInput("'" + text + "' is not NAME=VALUE with a name of docs/parameters.md");
    *parameters.at(name) = value;
  }
  setup.walker.step = setup.robot.step;
  setup.walker.executor.swing = setup.robot.swing;
  setup.walker.executor.base = setup.robot.base;
  setup.walker.tolerance = setup.robot.tolerance;
  setup.walker.gait.tie_tolerance = setup.robot.tolerance.tie;
  static_cast<PlantParams&>(setup.world) = setup.robot.plant;
  return setup;
}

int main(int argc, char** argv) try {
  if (argc < 3)
    return std::fputs("usage: try_parameters ROBOT.urdf TERRAIN [NAME=VALUE]...\n", stderr), 2;
  const RobotModel model = load_urdf(argv[1]);
  const sim3d::TerrainSpec terrain = sim3d::parse_terrain(argv[2]);
  Setup setup = setup_from(model, argc, argv);
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
