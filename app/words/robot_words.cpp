// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "options/robot_options.hpp"
#include "words/words.hpp"

namespace hexagait::app {
namespace {

// Lengths of coxa, femur and tibia, if these are what it has.
std::string links_in_words(const LegModel& leg) {
  if (leg.kind == LegKind::serial) return fmt::format("{} joints, serial", leg.num_joints());
  return fmt::format("{:.3f}  {:.3f}  {:.3f}", leg.coxa, leg.femur, leg.tibia);
}

// Where a value comes from: d, s or g as explained below the table; a blank if from the file.
char mark(const RobotModel& robot, const std::string& element, const char* what) {
  for (const Substitution& s : robot.substitutions) {
    if (s.element != element || s.what != what) continue;
    return s.origin == Origin::derived ? 'd' : s.origin == Origin::given ? 'g' : 's';
  }
  return ' ';
}

char mass_mark(const RobotModel& robot, const LinkModel& link) {
  const char own = mark(robot, "link " + link.name, "mass");
  return own == ' ' ? mark(robot, "robot", "mass") : own;
}

std::string legs_table(const RobotModel& robot) {
  std::string text =
      "  leg    coxa   femur  tibia  reach          foot in the stance       radius  [m]\n";
  for (const LegModel& leg : robot.legs)
    text += fmt::format("  {:<5}  {:<19}  {:.3f}…{:.3f}  ({:6.3f}, {:6.3f}, {:6.3f})  {:.3f}\n",
                        leg.name, links_in_words(leg), leg.min_reach, leg.max_reach, leg.p_BC.x(),
                        leg.p_BC.y(), leg.p_BC.z(), leg.workspace_radius);
  return text;
}

std::string joints_table(const RobotModel& robot) {
  std::size_t joint_width = 5, link_width = 4;
  for (const LegModel& leg : robot.legs)
    for (int k = 0; k < leg.num_joints(); ++k) {
      joint_width = std::max(joint_width, leg.joint_names[k].size());
      link_width = std::max(link_width, leg.links[k].name.size());
    }
  std::string text =
      fmt::format("  leg    {:<{}}   limits        speed     effort    {:<{}}  mass\n", "joint",
                  joint_width, "link", link_width);
  text += fmt::format("  {:<{}}   [°]           [rad/s]   [N m]     {:<{}}  [kg]\n", "",
                      joint_width + 7, "", link_width);
  for (const LegModel& leg : robot.legs)
    for (int k = 0; k < leg.num_joints(); ++k) {
      const std::string joint = "joint " + leg.joint_names[k];
      const JointLimits& limits = leg.limits[k];
      text += fmt::format(
          "  {:<5}  {:<{}}  {:>5.0f}…{:<5.0f}{}  {:>6.3g} {}  {:>7.3g} {}  {:<{}}  {:.4g} {}\n",
          k == 0 ? leg.name : "", leg.joint_names[k], joint_width, degrees(limits.lower),
          degrees(limits.upper), mark(robot, joint, "limits"), limits.velocity,
          mark(robot, joint, "velocity limit"), limits.effort, mark(robot, joint, "effort limit"),
          leg.links[k].name, link_width, leg.links[k].mass, mass_mark(robot, leg.links[k]));
    }
  return text;
}

}  // namespace

std::string in_words(const RobotModel& robot) {
  std::string text = fmt::format("{}: {} legs, {:.4g} kg, feet of {} radius.\n", robot.name,
                                 robot.num_legs(), robot.mass, length(robot.foot_radius));
  text += fmt::format("  body {}, {:.4g} kg {}\n", robot.base.name, robot.base.mass,
                      mass_mark(robot, robot.base));
  text += fmt::format("  centre of mass ({:.3f}, {:.3f}, {:.3f}) m in the nominal stance\n\n",
                      robot.p_BM.x(), robot.p_BM.y(), robot.p_BM.z());
  text += legs_table(robot) + "\n" + joints_table(robot);
  text +=
      "\n  Lengths, reach, stance and radius are derived. Of the rest, what has no mark is the "
      "file's;\n  d derived, s substituted, g given by an option.\n";
  if (robot.substitutions.empty()) return text;
  text += "\n  What the file does not say, or what can't be as it says:\n";
  for (const std::string& line : in_words(robot.substitutions, false)) text += "    " + line + "\n";
  return text;
}

}  // namespace hexagait::app
