// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The other end of my_robot's pipe: a robot in a process of its own, here a simulated one. It owns
// the clock: it sends its state, waits for targets, moves on by one control period, and says at the
// end how far it got. With a terrain it is the test of docs/rough_terrain.md for a controller of any
// kind and language.                               simulated_robot ROBOT.urdf [TERRAIN [SEED]]
#include <cstdio>
#include <cstdlib>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "robot_link.hpp"

using namespace hexagait;

int main(int argc, char** argv) try {
  if (argc < 2)
    return std::fputs("usage: simulated_robot ROBOT.urdf [TERRAIN [SEED]]\n", stderr), 2;
  const RobotModel model = load_urdf(argv[1]);
  LegArray<LegJoints> stance(model.num_legs());
  for (LegId i = 0; i < model.num_legs(); ++i)
    stance[i] = inverse_kinematics(model.legs[i], model.legs[i].p_BC).q;
  sim3d::WorldParams params;
  params.seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  sim3d::World world(model, sim3d::parse_terrain(argc > 2 ? argv[2] : "flat"), params, stance);

  Measurement state;
  TargetPacket targets;
  bool fell = false;
  while (world.read(state) == PlantStatus::fresh) {
    const StatePacket packet = packet_from(state);
    if (send(STDOUT_FILENO, &packet, sizeof packet, MSG_NOSIGNAL) != sizeof packet) break;
    if (recv(STDIN_FILENO, &targets, sizeof targets, 0) != sizeof targets) break;
    world.write(targets_from(targets, model.num_legs()));
    fell = fell || world.truth().base_touches_ground;
  }
  const Vector3& p_WB = world.truth().X_WB.p;
  std::fprintf(stderr,
               "robot: at x %.3f, y %.3f, z %.3f m after %.2f s; %s; cost of transport %.2f\n",
               p_WB.x(), p_WB.y(), p_WB.z(), world.truth().time, fell ? "fell" : "did not fall",
               world.truth().work / (9.81 * model.mass * p_WB.head<2>().norm()));
  return 0;
} catch (const InvalidInput& error) {
  return std::fprintf(stderr, "simulated_robot: %s\n", error.what()), 2;
}
