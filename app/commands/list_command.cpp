// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/all/all.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/sim2d/terrain2d.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/yaml/yaml_tree.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "commands/commands.hpp"
#include "options/robot_options.hpp"
#include "terminal/output.hpp"

namespace hexagait::app {
namespace {

using Json = nlohmann::ordered_json;

// A list for programs, and its lines for people.
struct List {
  Json json = Json::array();
  std::string text;
};

// The names of the files in a folder that comes with hexagait, which is never empty.
std::vector<std::string> shipped_names(const char* folder, const char* suffix) {
  std::vector<std::string> names = known_names(folder, suffix);
  if (names.empty())
    throw InvalidInput(
        fmt::format("there are no {} in {}; set HEXAGAIT_DATA to the folder that holds {}/", folder,
                    shared_directory(folder).string(), folder));
  return names;
}

List robots() {
  List list;
  list.text = fmt::format("{:<14} {:>4}  {:>6}  {:>8}  {:>11}  {:>10}  {:>6}  {:>6}\n", "", "legs",
                          "joints", "mass", "stance", "legs reach", "step", "speed");
  for (const std::string& name : shipped_names("robots", ".urdf")) {
    const std::string file = robot_file(name);
    const RobotModel robot = load_urdf(file);
    const RobotScale scale = scale_of(robot);
    double reach = 0.0, length = 0.0, width = 0.0;
    for (const LegModel& leg : robot.legs) {
      reach = std::max(reach, leg.max_reach);
      length = std::max(length, 2.0 * std::abs(leg.p_BC.x()));
      width = std::max(width, 2.0 * std::abs(leg.p_BC.y()));
    }
    const int joints = robot.legs[0].num_joints();
    list.text += fmt::format(
        "{:<14} {:>4}  {:>6}  {:>5.1f} kg  {:.2f} × {:.2f} m  {:>8.2f} m  {:>3.0f} cm  {:.2f} "
        "m/s\n",
        name, robot.num_legs(), joints, robot.mass, length, width, reach, 100.0 * scale.reach,
        usual_speed(scale));
    const std::vector<std::string> not_in_file = in_words(robot.substitutions, true);
    for (const std::string& line : not_in_file) list.text += fmt::format("{:<14} {}\n", "", line);
    list.json.push_back({{"name", name},
                         {"file", file},
                         {"legs", robot.num_legs()},
                         {"joints_per_leg", joints},
                         {"mass_kg", robot.mass},
                         {"stance_length_m", length},
                         {"stance_width_m", width},
                         {"size_m", scale.size},
                         {"reach_m", reach},
                         {"step_reach_m", scale.reach},
                         {"usual_speed_m_s", usual_speed(scale)},
                         {"not_in_file", not_in_file}});
  }
  list.text +=
      fmt::format("{:<14} Genghis II in a side view, without a file: for walk only\n", kGenghis);
  list.text +=
      "\nspeed: about, straight on over flat ground; hexagait robot NAME has all figures of one.\n";
  list.json.push_back({{"name", kGenghis}, {"file", nullptr}});
  return list;
}

// The comment at the beginning of an action file, as one line without its licence.
std::string comment(const std::string& file) {
  std::istringstream lines(read_text(file, kMaxYamlText));
  std::string text;
  for (std::string line; std::getline(lines, line) && line.starts_with('#');)
    if (line.size() > 2 && line.find("SPDX") == std::string::npos)
      text.append(text.empty() ? "" : " ").append(line, 2);
  return text;
}

// How many steps are written in an action file, those in lists of their own as well.
int steps_in(const std::string& file) {
  const std::string text = read_text(file, kMaxYamlText);
  int count = 0;
  for (std::size_t at = text.find("- step:"); at != std::string::npos;
       at = text.find("- step:", at + 1))
    ++count;
  return count;
}

List actions() {
  List list;
  for (const std::string& name : shipped_names("actions", ".yaml")) {
    const std::string file = shared_file("action", name, "actions", ".yaml");
    const std::string about = comment(file);
    // Its first sentence, up to a colon; the robot is the first word `like this`.
    const std::string what = about.substr(0, std::min(about.find(". "), about.find(": ")));
    const std::size_t begin = std::min(about.find('`'), about.size() - 1) + 1;
    const std::string robot = about.substr(begin, about.find('`', begin) - begin);
    const int steps = steps_in(file);
    list.text += fmt::format("{:<14} {:<12} {:>2} step{}  {}\n", name, robot, steps,
                             steps == 1 ? " " : "s", what);
    list.json.push_back({{"name", name},
                         {"file", file},
                         {"robot", robot},
                         {"steps", steps},
                         {"description", what}});
  }
  return list;
}

List paths() {
  List list;
  for (const std::string& name : shipped_names("paths", ".yaml")) {
    const std::string file = shared_file("path", name, "paths", ".yaml");
    const std::string about = comment(file), what = about.substr(0, about.find(". "));
    list.text += fmt::format("{:<14} {}\n", name, what);
    list.json.push_back({{"name", name}, {"file", file}, {"description", what}});
  }
  return list;
}

List terrains() {
  List list;
  const auto add = [&](std::string_view syntax, std::string_view meaning, bool side_view) {
    list.text += fmt::format("{:<23} {}\n", syntax, meaning);
    list.json.push_back({{"syntax", syntax}, {"meaning", meaning}, {"side_view", side_view}});
  };
  for (const auto& terrain : sim3d::known_terrains()) add(terrain.syntax, terrain.meaning, false);
  list.text += fmt::format("\nIn the side view (--robot {}):\n", kGenghis);
  for (const auto& terrain : sim2d::known_terrains2d()) add(terrain.syntax, terrain.meaning, true);
  list.text +=
      "\nH is a height: 0.1, 10cm or 100mm; the second number may be left out. Kinds add up:\n"
      "slope:10deg+boxes:5cm. hexagait terrains --plot FILE draws them.\n";
  return list;
}

List plants() {
  List list;
  for (const recording::PlantPreset& preset : recording::plant_presets()) {
    list.text += fmt::format("{:<10} {}\n", preset.name, preset.meaning);
    list.json.push_back({{"name", preset.name}, {"meaning", preset.meaning}});
  }
  list.text += "\nAnd what differs: NAME:VALUE, joined by +, as in real+friction:0.4. NAME is\n";
  for (const recording::PlantNumber& number : recording::plant_numbers()) {
    list.text += fmt::format("{:<20} {}: {}\n", number.name, number.meaning, expected(number));
    list.json.push_back(
        {{"name", number.name}, {"meaning", number.meaning}, {"value", expected(number)}});
  }
  for (const recording::PlantSwitch& one : recording::plant_switches()) {
    const std::string words = fmt::format("{} or {}", one.words[0], one.words[1]);
    list.text += fmt::format("{:<20} {}: {}\n", one.name, one.meaning, words);
    list.json.push_back({{"name", one.name}, {"meaning", one.meaning}, {"value", words}});
  }
  return list;
}

List faults() {
  List list;
  for (const walk::PartFaultWords& kind : walk::part_fault_kinds()) {
    list.text += fmt::format("{:<24} {}\n", kind.syntax, kind.meaning);
    list.json.push_back({{"syntax", kind.syntax}, {"meaning", kind.meaning}});
  }
  list.text +=
      "\nAll but a load may end in @TIME, the time in the walk at which the fault begins: "
      "dead:LF@5s. LEG\n"
      "and JOINT are named as hexagait robot names them. Plants of sweeps take faults too: "
      "real+dead:LF@5s.\n";
  return list;
}

List experiments_list() {
  List list;
  for (const experiments::Experiment& experiment : experiments::experiments()) {
    list.text += fmt::format("{:<14} {}\n", experiment.name, experiment.title);
    list.json.push_back(
        {{"name", experiment.name}, {"title", experiment.title}, {"shows", experiment.shows}});
  }
  return list;
}

struct Kind {
  std::string name;
  List (*make)();
};

}  // namespace

int list_command(const std::string& what, bool json) {
  const Kind kinds[] = {{"robots", robots},
                        {"actions", actions},
                        {"paths", paths},
                        {"terrains", terrains},
                        {"plants", plants},
                        {"faults", faults},
                        {"experiments", experiments_list}};
  std::vector<std::string> names;
  for (const Kind& kind : kinds) {
    names.push_back(kind.name);
    if (kind.name != what) continue;
    const List list = kind.make();
    print_out(json ? list.json.dump(2) + "\n" : list.text);
    return kOk;
  }
  throw InvalidInput(
      fmt::format("there is no list of '{}'{}; there are robots, actions, paths, terrains, "
                  "plants, faults and experiments",
                  what, did_you_mean(what, names)));
}

}  // namespace hexagait::app
