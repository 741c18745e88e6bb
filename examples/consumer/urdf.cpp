// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/urdf/urdf.hpp>

int main(int, char** argv) {
  const hexagait::RobotModel robot = hexagait::load_urdf(std::string(argv[1]) + "/argos.urdf");
  std::printf("urdf: %s has %d legs\n", robot.name.c_str(), robot.num_legs());
  return robot.num_legs() == 6 ? 0 : 1;
}
