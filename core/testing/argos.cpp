// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/urdf/urdf.hpp>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait::testing {

const RobotModel& argos() {
  static const RobotModel model = load_urdf(source_path("robots/argos.urdf"));
  return model;
}

RobotModel argos(double foot_radius) {
  RobotModel model = argos();
  model.foot_radius = foot_radius;
  return model;
}

}  // namespace hexagait::testing
