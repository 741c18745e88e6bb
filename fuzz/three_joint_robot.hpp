// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>

namespace hexagait {

/// Six legs of which loaders need no more than the names.
[[nodiscard]] inline RobotModel three_joint_robot() {
  RobotModel model;
  model.legs = LegArray<LegModel>(6);
  const char* const names[] = {"LF", "RF", "LM", "RM", "LR", "RR"};
  for (LegId i = 0; i < 6; ++i) {
    const std::string name = names[i];
    model.legs[i].name = name;
    model.legs[i].joint_names = {name + "_yaw", name + "_hip", name + "_knee"};
  }
  return model;
}

}  // namespace hexagait
