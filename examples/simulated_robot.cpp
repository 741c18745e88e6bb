// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The other end of my_robot's pipe: a robot in a process of its own, here a simulated one. It owns
// the clock: it sends its state, waits for targets, moves on by one control period, and says at the
// end how far it got.                                              simulated_robot ROBOT.urdf
#include <cstdio>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "robot_link.hpp"

using namespace hexagait;

int main(int argc, char** argv) try {
  if (argc < 2) return std::fputs("usage: simulated_robot ROBOT.urdf\n", stderr), 2;
  const RobotModel model = load_urdf(argv[1]);
  LegArray<LegJoints> stance(model.num_legs());
  for (LegId i = 0; i < model.num_legs(); ++i)
    stance[i] = inverse_kinematics(model.legs[i], model.legs[i].p_BC).q;
  sim3d::World world(model, {}, {}, stance);

  Measurement state;
  TargetPacket targets;
  while (world.read(state) == PlantStatus::fresh) {
    const StatePacket packet = packet_from(state);
    if (send(STDOUT_FILENO, &packet, sizeof packet, MSG_NOSIGNAL) != sizeof packet) break;
    if (recv(STDIN_FILENO, &targets, sizeof targets, 0) != sizeof targets) break;
    world.write(targets_from(targets, model.num_legs()));
  }
  const Vector3& p_WB = world.truth().X_WB.p;
  std::fprintf(stderr, "robot: at x %.3f, y %.3f, z %.3f m after %.2f s\n", p_WB.x(), p_WB.y(),
               p_WB.z(), world.truth().time);
  return 0;
} catch (const InvalidInput& error) {
  return std::fprintf(stderr, "simulated_robot: %s\n", error.what()), 2;
}
