// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <hexagait/load/load_params.hpp>
#include <hexagait/params/set_parameter.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/text/violations.hpp>
#include <hexagait/yaml/yaml_reader.hpp>
#include <map>

namespace hexagait {
namespace {

// The parameters by group and name: "step", "height".
using Groups = std::map<std::string_view, std::map<std::string_view, const Parameter*>>;

Groups groups_of_parameters() {
  Groups groups;
  for (const Parameter& one : parameters()) {
    const std::string_view name = one.name;
    const std::size_t dot = name.find('.');
    groups[name.substr(0, dot)][name.substr(dot + 1)] = &one;
  }
  return groups;
}

template <class Map>
std::vector<std::string_view> keys_of(const Map& map) {
  std::vector<std::string_view> keys;
  keys.reserve(map.size());
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

}  // namespace

void load_params(RobotParams& params, const std::string& path) {
  Violations violations(path);
  const YamlTree tree = parse_yaml(read_text(path, kMaxYamlText), path, violations);
  YamlReader yaml(tree, violations);
  const Groups groups = groups_of_parameters();
  const std::vector<std::string_view> names = keys_of(groups);
  const YamlKeys root_keys{"parameters of a robot", names};
  const YamlFields root = yaml.fields({"parameters", 0, yaml.node(0).mark}, root_keys);
  for (const auto& [group, of_group] : groups) {
    const auto field = yaml.find(root, group);
    if (!field) continue;
    const std::vector<std::string_view> known = keys_of(of_group);
    const YamlKeys keys{group, known};
    const YamlFields fields = yaml.fields(*field, keys);
    for (const auto& [name, parameter] : of_group) {
      const auto value = yaml.find(fields, name);
      if (!value) continue;
      const auto bound =
          may_be_zero(*parameter) ? NumberRule::Bound::not_negative : NumberRule::Bound::positive;
      const auto number =
          yaml.number(*value, {.bound = bound, .dimension = dimension_of(*parameter)});
      if (number) parameter->in(params) = *number;
    }
  }
  violations.throw_if_any();
}

std::string params_beside(const std::string& urdf) {
  std::filesystem::path path = urdf;
  path.replace_extension(".params.yaml");
  std::error_code none;
  return std::filesystem::is_regular_file(path, none) ? path.string() : "";
}

}  // namespace hexagait
