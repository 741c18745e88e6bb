// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/recording/json.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "commands.hpp"
#include "output.hpp"
#include "words.hpp"

namespace hexagait::app {
namespace {

// Mass over the cube of a leg's reach: of walking machines some 50 to 500 kg/m³, whatever their
// size. Less than that of air, or more than that of lead: lengths or masses are in other units.
constexpr double kAir = 1.2, kLead = 11340.0;  // [kg/m³]

void warn_of_units(const RobotModel& robot) {
  double reach = 0.0;
  for (const LegModel& leg : robot.legs) reach = std::max(reach, leg.max_reach);
  const double density = robot.mass / (reach * reach * reach);
  const char* wrong = density < kAir    ? "lengths in millimetres, or masses too small?"
                      : density > kLead ? "lengths too short, or masses in grams?"
                                        : nullptr;
  if (wrong == nullptr) return;
  fmt::print(
      stderr,
      "hexagait: warning: {} has legs that reach {:.3g} m and a mass of {:.3g} kg; a URDF is "
      "in metres and kilograms: {}\n",
      robot.name, reach, robot.mass, wrong);
}

}  // namespace

int robot_command(const std::string& robot, bool json) {
  const RobotModel model = load_urdf(robot_file(robot));
  warn_of_units(model);
  print_out(json ? recording::to_json(model) + "\n" : in_words(model));
  return kOk;
}

}  // namespace hexagait::app
