// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/ranges.h>

#include <algorithm>
#include <hexagait/sim2d/genghis_model.hpp>
#include <hexagait/sweep/sweep.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/parse_number.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/yaml/yaml_reader.hpp>
#include <limits>
#include <optional>

namespace hexagait::sweep {
namespace {

constexpr double kMaxTrials = 1e12;
constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

constexpr std::string_view kKeys[] = {
    "simulator", "controllers", "terrains", "roughness", "seeds",    "master_seed",   "measure",
    "slices",    "robots",      "plants",   "seconds",   "distance", "random_posture"};
constexpr YamlKeys kSweep = {"sweep", kKeys};

bool has(Engine engine, std::string_view key) {
  if (key == "plants") return engine == Engine::ode;
  if (key == "slices") return engine == Engine::slice;
  const bool is_of_walks =
      std::ranges::find(std::begin(kKeys) + 8, std::end(kKeys), key) != std::end(kKeys);
  return engine != Engine::slice || !is_of_walks;
}

// A quantity of a range, and what to say of any other.
struct Range {
  double least, greatest;
  Dimension dimension;
  std::string words;
};

// Reads one sweep; a value that is wrong is refused, and passed over.
class SweepReader {
 public:
  SweepReader(YamlReader& yaml, const YamlFields& fields, const RobotFinder& robot_file)
      : yaml_(yaml), fields_(fields), robot_file_(robot_file) {}

  Sweep read() {
    if (!read_engine()) return sweep_;  // what the other values may be is not known
    for (const YamlField& field : fields_.fields)
      if (!has(sweep_.engine, field.key))
        yaml_.refuse(field.mark, fmt::format("the simulator '{}' has no '{}'; remove it",
                                             to_string(sweep_.engine), field.key));
    read_controllers();
    read_robots();
    read_plants();
    read_terrains();
    read_seeds();
    read_limits();
    read_measure();
    const double trials = static_cast<double>(sweep_.terrains.size()) *
                          static_cast<double>(sweep_.controllers.size()) *
                          static_cast<double>(sweep_.robots.size()) *
                          static_cast<double>(sweep_.plants.size()) *
                          static_cast<double>(std::max<std::uint64_t>(sweep_.num_seeds, 1));
    if (trials > kMaxTrials)
      yaml_.refuse(fields_.mark, fmt::format("the grid has {:g} trials; at most {:g} are possible",
                                             trials, kMaxTrials));
    return sweep_;
  }

 private:
  bool read_engine() {
    std::vector<std::string> names;
    names.reserve(std::size(kEngines));
    for (const Engine engine : kEngines) names.emplace_back(to_string(engine));
    const auto field = yaml_.require(fields_, "simulator");
    const auto index = field ? yaml_.word(*field, names) : std::nullopt;
    if (index) sweep_.engine = kEngines[*index];
    return index.has_value();
  }

  void read_controllers() {
    const std::vector<std::string> known = {"free",   "unadjusted", "literal",
                                            "tripod", "clocked",    "wave:0.75"};
    for (const YamlField& item : list("controllers", "[free, tripod]")) {
      const auto choice = gait_state::parse_gait_choice(yaml_.node(item.node).text);
      if (choice && choice->open_loop && sweep_.engine != Engine::ode)
        yaml_.refuse(item.mark,
                     fmt::format("the simulator '{}' has no 'clocked'; only ode has sensors to do "
                                 "without",
                                 to_string(sweep_.engine)));
      else if (choice)
        add_once(item, "controller", sweep_.controllers, *choice,
                 [](const auto& c) { return to_string(c); });
      else
        yaml_.refuse_word(item.mark, "controller", yaml_.node(item.node).text, known);
    }
  }

  void read_robots() {
    if (sweep_.engine == Engine::slice) return sweep_.robots.push_back({"six_feet", {}});
    const auto robots = yaml_.find(fields_, "robots");
    if (sweep_.engine == Engine::box2d) {
      const std::vector<std::string> only = {"genghis2d"};
      sweep_.robots.push_back({only.front(), {}});
      if (!robots) return;
      for (const YamlField& item : list("robots", "[genghis2d]"))
        static_cast<void>(yaml_.word(item, only));
    } else if (robots) {
      for (const YamlField& item : list("robots", "[argos]"))
        read_robot(item, yaml_.node(item.node).text);
    } else {
      read_robot({"robots", 0, fields_.mark}, "argos");
    }
  }

  void read_robot(const YamlField& item, const std::string& name) {
    try {
      if (name.find_first_of(",\n\"") != std::string::npos)
        throw InvalidInput(fmt::format("the robot '{}' has a comma or quote in its name", name));
      add_once(item, "robot", sweep_.robots, Robot{name, load_urdf(robot_file_(name))},
               [](const Robot& robot) { return robot.name; });
    } catch (const InvalidInput& error) {
      yaml_.refuse(item.mark, error.what());
    }
  }

  void read_plants() {
    if (!yaml_.find(fields_, "plants")) return;
    sweep_.plants.clear();
    for (const YamlField& item : list("plants", "[ideal, real]")) read_plant(item);
  }

  void read_plant(const YamlField& item) {
    try {
      const recording::PlantSetup plant = recording::parse_plant(yaml_.node(item.node).text);
      for (const Robot& robot : sweep_.robots)
        static_cast<void>(resolved(plant.parts, robot.model));
      add_once(item, "plant", sweep_.plants, plant, &recording::PlantSetup::name);
    } catch (const InvalidInput& error) {
      yaml_.refuse(item.mark, error.what());
    }
  }

  void read_terrains() {
    const auto roughness = yaml_.find(fields_, "roughness");
    const std::vector<std::string>& kinds = rough_terrains(sweep_.engine);
    std::vector<std::string> rough;  // those that wait for a roughness
    for (const YamlField& item : list("terrains", "[flat]")) {
      const std::string& name = yaml_.node(item.node).text;
      if (std::ranges::find(kinds, name) == kinds.end())
        read_terrain(item, name);
      else if (!roughness)
        yaml_.refuse(item.mark, fmt::format("'{0}' lacks its roughness; write {0}:1, or give a "
                                            "list with the key 'roughness'",
                                            name));
      else
        add_once(item, "terrain", rough, name, std::identity());
    }
    if (!roughness) return;
    const std::vector<YamlField> values = roughnesses();
    if (rough.empty() && !values.empty())
      yaml_.refuse(roughness->mark,
                   fmt::format("no terrain takes this roughness; name one without a number: {}",
                               fmt::join(kinds, ", ")));
    for (const std::string& kind : rough)
      for (const YamlField& value : values)
        read_terrain(value, kind + ":" + yaml_.node(value.node).text);
  }

  // Those that are numbers of 0 or more.
  std::vector<YamlField> roughnesses() {
    std::vector<YamlField> values = list("roughness", "[0.05, 0.10]");
    const auto dimension = sweep_.engine == Engine::slice ? Dimension::number : Dimension::length;
    std::erase_if(values, [&](const YamlField& item) {
      return !yaml_.number(item, {NumberRule::Bound::not_negative, dimension});
    });
    return values;
  }

  void read_terrain(const YamlField& item, const std::string& name) {
    try {
      add_once(item, "terrain", sweep_.terrains, ground(sweep_.engine, name), &Ground::terrain);
    } catch (const InvalidInput& error) {
      yaml_.refuse(item.mark, error.what());
    }
  }

  void read_seeds() {
    sweep_.master_seed = whole("master_seed", 0).value_or(1);
    const auto field = yaml_.require(fields_, "seeds");
    if (!field) return;
    if (!yaml_.node(field->node).is_list()) {
      sweep_.num_seeds = whole("seeds", 1).value_or(1);
      return;
    }
    for (const YamlField& item : list("seeds", "[1, 2]"))
      if (const auto value = whole(item, 0))
        add_once(item, "seed", sweep_.seeds, *value, std::identity());
    sweep_.num_seeds = sweep_.seeds.size();
  }

  void read_limits() {
    Limits& limits = sweep_.limits;
    if (sweep_.engine == Engine::slice) {
      constexpr std::uint64_t kMostSlices = 1'000'000'000;
      limits.slices = static_cast<int>(
          whole("slices", 1, kMostSlices).value_or(static_cast<std::uint64_t>(limits.slices)));
      return;
    }
    const double radius = smallest_workspace();
    limits.seconds = number("seconds", limits.seconds,
                            {1e-3, 86400.0, Dimension::time, "a time of 1 ms to a day [s]"});
    limits.distance = number("distance", limits.distance,
                             {1e-3, 1e5, Dimension::length, "a length of 1 mm to 100 km [m]"});
    limits.random_posture =
        number("random_posture", limits.random_posture,
               {0.0, radius, Dimension::length,
                fmt::format("a length of 0 to {:.3g} m, the radius of the workspaces", radius)});
  }

  // Over all legs and robots [m].
  [[nodiscard]] double smallest_workspace() const {
    if (sweep_.engine == Engine::box2d) return sim2d::GenghisModel{}.workspace_radius;
    double radius = std::numeric_limits<double>::infinity();
    for (const Robot& robot : sweep_.robots)
      for (const LegModel& leg : robot.model.legs) radius = std::min(radius, leg.workspace_radius);
    return radius;
  }

  void read_measure() {
    std::vector<std::string> known;
    for (const Column& column : columns(sweep_.engine)) known.push_back(column.name);
    const auto field = yaml_.find(fields_, "measure");
    sweep_.measure = known[field ? yaml_.word(*field, known).value_or(0) : 0];
  }

  // A number of a range, or the default if there is no such key.
  double number(std::string_view key, double otherwise, const Range& range) {
    const auto field = yaml_.find(fields_, key);
    const auto value = field ? yaml_.number(*field, {.dimension = range.dimension}) : std::nullopt;
    if (!value) return otherwise;
    if (range.least <= *value && *value <= range.greatest) return *value;
    yaml_.refuse(*field, range.words);
    return otherwise;
  }

  std::optional<std::uint64_t> whole(std::string_view key, std::uint64_t least,
                                     std::uint64_t greatest = kNoLimit) {
    const auto field = yaml_.find(fields_, key);
    return field ? whole(*field, least, greatest) : std::nullopt;
  }

  // Seeds have more digits than a double has.
  std::optional<std::uint64_t> whole(const YamlField& field, std::uint64_t least,
                                     std::uint64_t greatest = kNoLimit) {
    const auto value = parse_number<std::uint64_t>(yaml_.node(field.node).text);
    if (value && least <= *value && *value <= greatest) return value;
    yaml_.refuse(field, greatest == kNoLimit
                            ? fmt::format("a whole number of {} or more", least)
                            : fmt::format("a whole number from {} to {}", least, greatest));
    return {};
  }

  // A list of single values, at least one.
  std::vector<YamlField> list(std::string_view key, std::string_view example) {
    const auto field = yaml_.require(fields_, key);
    if (!field) return {};
    std::vector<YamlField> items;
    if (yaml_.node(field->node).is_list()) items = yaml_.list(*field);
    if (items.empty()) yaml_.refuse(*field, fmt::format("a list such as {}", example));
    std::erase_if(items, [&](const YamlField& item) { return !yaml_.text(item); });
    return items;
  }

  // A value that is there twice would make each of its trials twice.
  template <class Value, class Name>
  void add_once(const YamlField& item, const char* what, std::vector<Value>& values, Value value,
                const Name& name) {
    if (std::ranges::find(values, std::invoke(name, value), name) == values.end())
      values.push_back(std::move(value));
    else
      yaml_.refuse(item.mark,
                   fmt::format("the {} '{}' is there twice", what, std::invoke(name, value)));
  }

  YamlReader& yaml_;
  const YamlFields& fields_;
  const RobotFinder& robot_file_;
  Sweep sweep_;
};

}  // namespace

Sweep load_sweep(const std::string& path, const RobotFinder& robot_file) {
  Violations violations(path);
  const YamlTree tree = parse_yaml(read_text(path, kMaxYamlText, "a sweep file"), path, violations);
  YamlReader yaml(tree, violations);
  const YamlFields fields = yaml.fields({"sweep", 0, {1, 1}}, kSweep);
  if (!yaml.node(0).is_map()) violations.throw_if_any();
  Sweep sweep = SweepReader(yaml, fields, robot_file).read();
  violations.throw_if_any();
  return sweep;
}

}  // namespace hexagait::sweep
