// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/experiment_context.hpp"

#include <hexagait/urdf/urdf.hpp>

#include "options/arguments.hpp"

namespace hexagait::app {

experiments::ExperimentContext experiment_context(const RobotModel& robot, Progress& progress,
                                                  const std::atomic<bool>& stop, bool short_form) {
  return {.robot = &robot,
          .robot_names = known_names("robots", ".urdf"),
          .robot_named = [](const std::string& name) { return load_urdf(robot_file(name)); },
          .progress = [&progress](double share) { progress.at(share); },
          .stop = &stop,
          .short_form = short_form};
}

}  // namespace hexagait::app
