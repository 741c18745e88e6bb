// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/figures/robot_figure.hpp>
#include <hexagait/recording/json.hpp>

#include "commands/commands.hpp"
#include "files/output_file.hpp"
#include "terminal/output.hpp"
#include "words/words.hpp"

namespace hexagait::app {
namespace {

std::string robot_subtitle(const RobotModel& robot) {
  double reach = 0.0, height = 0.0;
  for (const LegModel& leg : robot.legs) {
    reach = std::max(reach, leg.max_reach);
    height = std::max(height, leg.X_BH.p.z() - leg.p_BC.z() + robot.foot_radius);
  }
  const auto count = [&](Origin origin) {
    return std::ranges::count(robot.substitutions, origin, &Substitution::origin);
  };
  return fmt::format(
      "Nominal stance · hips {} above the ground · legs reach {} · feet of {} radius · "
      "substituted: {} · left "
      "out: {}",
      length(height), length(reach), length(robot.foot_radius), count(Origin::substituted),
      count(Origin::left_out));
}

void draw(OutputFile& file, const RobotModel& robot) {
  write_output("--plot", file, [&] {
    recording::draw_robot(file.files,
                          {.stem = file.path.stem(),
                           .suffix = file.path.extension(),
                           .headline = fmt::format("{}: {} legs, {:.3g} kg", robot.name,
                                                   robot.num_legs(), robot.mass),
                           .subtitle = robot_subtitle(robot)},
                          robot);
    file.files.publish();
  });
}

}  // namespace

int robot_command(const RobotArguments& arguments) {
  // The table says itself what is not the file's.
  const RobotModel model = load_robot(arguments.robot, arguments.overrides, true);
  std::optional<OutputFile> plot = output_file("--plot", arguments.plot, {".png", ".svg", ".pdf"});
  if (plot) figures::require_gnuplot();
  print_out(arguments.json
                ? recording::to_json(model) + "\n"
                : in_words(model) + params_in_words(model, given_params(arguments.robot, "", {})));
  if (plot) draw(*plot, model);
  return kOk;
}

}  // namespace hexagait::app
