// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/urdf/urdf.hpp>

// Loads a robot, stands it on its workspace centres and asks which legs step first.
int main() {
  using namespace hexagait;
  const RobotModel robot = load_urdf(ROBOT);
  const int n = robot.num_legs();

  Measurement measured{0.0, LegArray<LegJoints>(n), LegArray<bool>(n, true)};
  for (LegId i = 0; i < n; ++i)
    measured.q[i] = inverse_kinematics(robot.legs[i], robot.legs[i].p_BC).q;

  footstep_gen::Walker walker(robot);
  walker.start(measured);
  const auto ahead = heading_control::Heading::straight(0.0);
  const footstep_gen::TickRecord& tick = walker.tick(PlantStatus::fresh, measured, ahead);

  std::printf("%s has %d legs; first to step:", robot.name.c_str(), n);
  for (LegId i = 0; i < n; ++i)
    if (tick.lifts.contains(i)) std::printf(" %s", robot.legs[i].name.c_str());
  std::printf("\n");
  return tick.fault == footstep_gen::Fault::none ? 0 : 1;
}
