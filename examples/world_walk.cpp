// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
// A walk of 10 s in the 3D simulator: on an arc, over boxes of up to 5 cm, on ground with less
// friction than the default. docs/world.md goes through it.              world_walk ROBOT.urdf
#include <algorithm>
#include <cstdio>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>

using namespace hexagait;

int main(int argc, char** argv) try {
  if (argc != 2) return std::fputs("usage: world_walk ROBOT.urdf\n", stderr), 2;
  const RobotModel model = load_urdf(argv[1]);

  // Stand with every foot at the centre of its workspace.
  LegArray<LegJoints> stance(model.num_legs());
  for (LegId i = 0; i < model.num_legs(); ++i)
    stance[i] = inverse_kinematics(model.legs[i], model.legs[i].p_BC).q;

  sim3d::WorldParams params;
  params.control_dt = 0.004;
  params.friction = 0.7;
  params.seed = 7;
  sim3d::World world(model, sim3d::parse_terrain("boxes:5cm"), params, stance);
  footstep_gen::WalkerParams control;
  control.control_dt = params.control_dt;
  footstep_gen::Walker walker(model, control);

  Measurement sensed;
  PlantStatus status = world.read(sensed);
  walker.start(sensed);
  double least_height = world.truth().X_WB.p.z();
  while (sensed.time < 10.0 && walker.record().fault == footstep_gen::Fault::none) {
    const auto heading = sensed.time < 0.2 ? heading_control::Heading::stop()
                                           : heading_control::Heading::arc(1.5, 0.0);
    world.write(walker.tick(status, sensed, heading).targets);
    status = world.read(sensed);
    least_height = std::min(least_height, world.truth().X_WB.p.z());
    if (world.truth().base_touches_ground) return std::fputs("fell\n", stderr), 1;
  }
  const Vector3& p_WB = world.truth().X_WB.p;
  std::printf("at x %.3f, y %.3f m after %.1f s, never lower than %.3f m, fault: %s\n", p_WB.x(),
              p_WB.y(), sensed.time, least_height, to_string(walker.record().fault));
  return walker.record().fault == footstep_gen::Fault::none ? 0 : 1;
} catch (const InvalidInput& error) {
  return std::fprintf(stderr, "world_walk: %s\n", error.what()), 2;
}
