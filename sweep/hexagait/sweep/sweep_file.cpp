// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <hexagait/sim2d/genghis_model.hpp>
#include <hexagait/sweep/spelling.hpp>
#include <hexagait/sweep/sweep.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <limits>
#include <optional>
#include <set>

namespace hexagait::sweep {
namespace {

using Words = std::vector<std::string>;

constexpr double kMaxTrials = 1e12;
constexpr std::size_t kMaxFileSize = 16U << 20;  // [byte]

// Keys of all sweeps, and of those with one kind of engine only.
const Words kKeys = {"simulator", "controllers", "terrains", "roughness",
                     "seeds",     "master_seed", "measure"};
const Words kSliceKeys = {"slices"};
const Words kWalkKeys = {"robots", "seconds", "distance", "random_posture"};

Words keys_of(Engine engine) {
  Words keys = kKeys;
  const Words& own = engine == Engine::slice ? kSliceKeys : kWalkKeys;
  keys.insert(keys.end(), own.begin(), own.end());
  return keys;
}

// A whole text as a number.
template <class Number>
std::optional<Number> number(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

// What is wrong with a file, in the order in which it stands there.
class Findings {
 public:
  explicit Findings(std::string path) : path_(std::move(path)) {}

  void add(const YAML::Mark& mark, const std::string& problem) {
    findings_.emplace(std::pair(mark.line, mark.column), problem);
  }

  void throw_if_any() const {
    if (findings_.empty()) return;
    Words lines;
    for (const auto& [place, problem] : findings_)
      lines.push_back(
          fmt::format("{}:{}:{}: {}", path_, place.first + 1, place.second + 1, problem));
    throw InvalidInput(fmt::format("{}", fmt::join(lines, "\n")));
  }

 private:
  std::string path_;
  std::multimap<std::pair<int, int>, std::string> findings_;
};

// Reads one sweep; a value that is wrong is noted, and passed over.
class SweepReader {
 public:
  SweepReader(const YAML::Node& root, Findings& findings, const RobotFinder& robot_file)
      : root_(root), findings_(findings), robot_file_(robot_file) {}

  Sweep read() {
    read_engine();
    check_keys();
    if (!engine_known_) return sweep_;  // what the other values may be is not known
    read_controllers();
    read_robots();
    read_terrains();
    read_seeds();
    read_limits();
    read_measure();
    const double trials = static_cast<double>(sweep_.terrains.size()) *
                          static_cast<double>(sweep_.controllers.size()) *
                          static_cast<double>(sweep_.robots.size()) *
                          static_cast<double>(std::max<std::uint64_t>(sweep_.num_seeds, 1));
    if (trials > kMaxTrials)
      findings_.add(root_.Mark(), fmt::format("the grid has {:g} trials; at most {:g} are possible",
                                              trials, kMaxTrials));
    return sweep_;
  }

 private:
  void read_engine() {
    const YAML::Node node = required("simulator", "slice, box2d or ode");
    if (!node) return;
    Words names;
    for (const Engine engine : kEngines) names.emplace_back(to_string(engine));
    const std::string name = scalar(node);
    const auto found = std::ranges::find(names, name);
    engine_known_ = found != names.end();
    if (engine_known_)
      sweep_.engine = kEngines[static_cast<std::size_t>(found - names.begin())];
    else
      findings_.add(node.Mark(),
                    fmt::format("unknown simulator '{}'{}", name, suggestion(name, names)));
  }

  void check_keys() {
    const Words known = keys_of(sweep_.engine);
    Words all = kKeys;
    all.insert(all.end(), kSliceKeys.begin(), kSliceKeys.end());
    all.insert(all.end(), kWalkKeys.begin(), kWalkKeys.end());
    std::set<std::string> seen;
    for (const auto& entry : root_) {
      const std::string key = scalar(entry.first);
      const YAML::Mark mark = entry.first.Mark();
      if (!seen.insert(key).second)
        findings_.add(mark, fmt::format("'{}' is there twice", key));
      else if (std::ranges::find(all, key) == all.end())
        findings_.add(mark, fmt::format("unknown key '{}'{}", key, suggestion(key, all)));
      else if (engine_known_ && std::ranges::find(known, key) == known.end())
        findings_.add(mark, fmt::format("the simulator '{}' has no '{}'; remove it",
                                        to_string(sweep_.engine), key));
    }
  }

  void read_controllers() {
    for (const YAML::Node& node : list("controllers", "a list such as [free, tripod]")) {
      const auto choice = gait_state::parse_gait_choice(scalar(node));
      if (choice)
        add_once(node, "controller", sweep_.controllers, *choice,
                 [](const auto& c) { return to_string(c); });
      else
        findings_.add(node.Mark(), fmt::format("unknown controller '{}'{}", scalar(node),
                                               controllers_like(scalar(node))));
    }
  }

  static std::string controllers_like(const std::string& text) {
    const Words known = {"free", "unadjusted", "literal", "tripod", "wave:0.75"};
    const std::string hint = suggestion(text, known);
    return hint.starts_with("; there are") ? fmt::format("; there are {}", gait_state::kGaitChoices)
                                           : hint;
  }

  void read_robots() {
    if (sweep_.engine != Engine::ode) return read_only_robot();
    if (!root_["robots"]) return read_robot(root_, "argos");
    for (const YAML::Node& node : list("robots", "a list such as [argos]"))
      read_robot(node, scalar(node));
  }

  void read_only_robot() {
    const std::string only = sweep_.engine == Engine::slice ? "six_feet" : "genghis2d";
    sweep_.robots.push_back({.name = only, .model = {}});
    if (!root_["robots"]) return;
    for (const YAML::Node& node : list("robots", "[genghis2d]"))
      if (sweep_.engine == Engine::box2d && scalar(node) != only)
        findings_.add(node.Mark(),
                      fmt::format("unknown robot '{}'; the simulator 'box2d' has only '{}'",
                                  scalar(node), only));
  }

  void read_robot(const YAML::Node& node, const std::string& name) {
    try {
      if (name.find_first_of(",\n\"") != std::string::npos)
        throw InvalidInput(fmt::format("the robot '{}' has a comma or quote in its name", name));
      const std::string path = robot_file_(name);
      add_once(node, "robot", sweep_.robots, Robot{name, load_urdf(path)},
               [](const Robot& robot) { return robot.name; });
    } catch (const InvalidInput& error) {
      findings_.add(node.Mark(), error.what());
    }
  }

  void read_terrains() {
    Words rough;  // kinds that wait for a roughness
    for (const YAML::Node& node : list("terrains", "a list such as [flat]")) {
      const std::string name = scalar(node);
      const Words& kinds = rough_terrains(sweep_.engine);
      if (std::ranges::find(kinds, name) == kinds.end()) {
        read_terrain(node, name);
        continue;
      }
      if (!root_["roughness"])
        findings_.add(node.Mark(), fmt::format("'{0}' lacks its roughness; write {0}:1, or give "
                                               "a list with the key 'roughness'",
                                               name));
      else if (std::ranges::find(rough, name) != rough.end())
        findings_.add(node.Mark(), fmt::format("the terrain '{}' is there twice", name));
      rough.push_back(name);
    }
    if (!root_["roughness"]) return;
    const Words values = roughnesses();
    if (rough.empty() && !values.empty())
      findings_.add(root_["roughness"].Mark(),
                    fmt::format("no terrain takes this roughness; name one without a number: {}",
                                fmt::join(rough_terrains(sweep_.engine), ", ")));
    for (const std::string& kind : rough)
      for (const YAML::Node& node : root_["roughness"])
        if (std::ranges::find(values, scalar(node)) != values.end())
          read_terrain(node, kind + ":" + scalar(node));
  }

  // Those that are numbers of 0 or more.
  Words roughnesses() {
    Words values;
    for (const YAML::Node& node : list("roughness", "a list of numbers such as [0.05, 0.10]")) {
      const auto value = number<double>(scalar(node));
      if (value && std::isfinite(*value) && *value >= 0.0)
        values.push_back(scalar(node));
      else
        findings_.add(
            node.Mark(),
            fmt::format("roughness is '{}'; it must be a number of 0 or more", scalar(node)));
    }
    return values;
  }

  void read_terrain(const YAML::Node& node, const std::string& name) {
    try {
      add_once(node, "terrain", sweep_.terrains, ground(sweep_.engine, name),
               [](const Ground& g) { return g.terrain; });
    } catch (const InvalidInput& error) {
      findings_.add(node.Mark(), error.what());
    }
  }

  void read_seeds() {
    sweep_.master_seed = whole("master_seed", 0, 1).value_or(1);
    const YAML::Node node = required("seeds", "a number of seeds, or a list of them");
    if (!node) return;
    if (!node.IsSequence()) {
      sweep_.num_seeds = whole("seeds", 1, 1).value_or(1);
      return;
    }
    for (const YAML::Node& entry : list("seeds", "a number of seeds, or a list of them")) {
      const auto value = number<std::uint64_t>(scalar(entry));
      if (value)
        add_once(entry, "seed", sweep_.seeds, *value, [](std::uint64_t s) { return s; });
      else
        findings_.add(entry.Mark(), fmt::format("a seed is '{}'; it must be a whole number of 0 or "
                                                "more",
                                                scalar(entry)));
    }
    sweep_.num_seeds = sweep_.seeds.size();
  }

  void read_limits() {
    Limits& limits = sweep_.limits;
    if (sweep_.engine == Engine::slice) {
      limits.slices = static_cast<int>(whole("slices", 1, 500, 1'000'000'000).value_or(1));
      return;
    }
    limits.seconds =
        length("seconds", 1e-3, 86400.0, limits.seconds, "a time of 1 ms to a day [s]");
    limits.distance = length("distance", 1e-3, 1e5, 0.0, "a length of 1 mm to 100 km [m]");
    limits.random_posture =
        length("random_posture", 0.0, smallest_workspace(), 0.0,
               fmt::format("a length of 0 to {:.3g} m, the radius of the workspaces",
                           smallest_workspace()));
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
    Words known;
    for (const Column& column : columns(sweep_.engine)) known.push_back(column.name);
    const YAML::Node node = root_["measure"];
    sweep_.measure = node ? scalar(node) : known.front();
    if (std::ranges::find(known, sweep_.measure) == known.end())
      findings_.add(node.Mark(), fmt::format("unknown measure '{}'{}", sweep_.measure,
                                             suggestion(sweep_.measure, known)));
  }

  // A number of a range, or the default if there is no such key.
  double length(const std::string& key, double least, double greatest, double otherwise,
                const std::string& words) {
    const YAML::Node node = root_[key];
    if (!node) return otherwise;
    const auto value = number<double>(scalar(node));
    if (value && least <= *value && *value <= greatest) return *value;
    findings_.add(node.Mark(), fmt::format("{} is '{}'; it must be {}", key, scalar(node), words));
    return otherwise;
  }

  std::optional<std::uint64_t> whole(const std::string& key, std::uint64_t least,
                                     std::uint64_t otherwise,
                                     std::uint64_t greatest = ~std::uint64_t{0}) {
    const YAML::Node node = root_[key];
    if (!node) return otherwise;
    const auto value = number<std::uint64_t>(scalar(node));
    if (value && least <= *value && *value <= greatest) return value;
    findings_.add(node.Mark(),
                  fmt::format("{} is '{}'; it must be a whole number of {} or more{}", key,
                              scalar(node), least, greatest < 1'000'000'001 ? ", up to 10⁹" : ""));
    return {};
  }

  // A list that is not empty; what is wrong with it is noted.
  std::vector<YAML::Node> list(const std::string& key, const char* words) {
    const YAML::Node node = required(key, words);
    if (!node) return {};
    if (!node.IsSequence() || node.size() == 0) {
      findings_.add(node.Mark(),
                    fmt::format("'{}' {}; it must be {}", key,
                                node.IsSequence() ? "is empty" : "is not a list", words));
      return {};
    }
    return {node.begin(), node.end()};
  }

  YAML::Node required(const std::string& key, const char* words) {
    const YAML::Node node = root_[key];
    if (node) return node;
    findings_.add(root_.Mark(), fmt::format("'{}' is missing: {}", key, words));
    return YAML::Node(YAML::NodeType::Undefined);
  }

  static std::string scalar(const YAML::Node& node) {
    return node.IsScalar() ? node.Scalar() : node.IsNull() ? "(nothing)" : "(not a single value)";
  }

  // A value that is there twice would make each of its trials twice.
  template <class Value, class Name>
  void add_once(const YAML::Node& node, const char* what, std::vector<Value>& values, Value value,
                const Name& name) {
    if (std::ranges::find(values, name(value), name) == values.end())
      values.push_back(std::move(value));
    else
      findings_.add(node.Mark(), fmt::format("the {} '{}' is there twice", what, name(value)));
  }

  const YAML::Node root_;
  Findings& findings_;
  const RobotFinder& robot_file_;
  Sweep sweep_;
  bool engine_known_ = false;
};

}  // namespace

Sweep load_sweep(const std::string& path, const RobotFinder& robot_file) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
    throw InvalidInput(fmt::format("'{}' is a directory; a sweep file is expected", path));
  YAML::Node root;
  try {
    root = YAML::Load(read_text(path, kMaxFileSize));
  } catch (const YAML::ParserException& error) {
    throw InvalidInput(fmt::format("{}:{}:{}: not YAML: {}", path, error.mark.line + 1,
                                   error.mark.column + 1, error.msg));
  }
  if (!root.IsMap())
    throw InvalidInput(fmt::format(
        "{}:1:1: must be a map with the keys simulator, controllers, terrains and seeds", path));
  Findings findings(path);
  Sweep sweep = SweepReader(root, findings, robot_file).read();
  findings.throw_if_any();
  return sweep;
}

}  // namespace hexagait::sweep
