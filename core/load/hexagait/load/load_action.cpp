// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>
#include <hexagait/load/detail/action_steps.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/yaml/placeholders.hpp>

namespace hexagait::action {
namespace {

Adaptation read_adaptation(YamlReader& yaml, const ActionWords& words, const YamlField& item) {
  Adaptation adaptation;
  const YamlFields fields = yaml.fields(item, kAdaptationMap);
  adaptation.yaw_only = yaml.flag_or(fields, "yaw_only", adaptation.yaw_only);
  const std::optional<YamlField> transform = yaml.require(fields, "transform");
  if (!transform) return adaptation;
  const YamlFields parts = yaml.fields(*transform, kTransformMap);
  const std::size_t before = yaml.num_refused();
  adaptation.source = read_frame(yaml, words, parts, "source_frame");
  adaptation.target = read_frame(yaml, words, parts, "target_frame");
  if (yaml.num_refused() == before && adaptation.source == adaptation.target)
    yaml.refuse(transform->mark,
                "transform: source_frame and target_frame are the same; they must "
                "be two");
  if (const auto pose = yaml.find(parts, "transform_in_source_frame"))
    adaptation.X_S = read_pose(yaml, yaml.fields(*pose, kTransformPoseMap));
  return adaptation;
}

std::vector<Adaptation> read_adaptations(YamlReader& yaml, const ActionWords& words,
                                         const YamlField& field) {
  std::vector<Adaptation> adaptations;
  for (const YamlField& item : yaml.list(field)) {
    const std::size_t before = yaml.num_refused();
    const Adaptation adaptation = read_adaptation(yaml, words, item);
    for (const Adaptation& other : adaptations)
      if (yaml.num_refused() == before && other.source == adaptation.source)
        yaml.refuse(item.mark, fmt::format("adaptation: of frame {} there is one already",
                                           words.frames[adaptation.source]));
    adaptations.push_back(adaptation);
  }
  return adaptations;
}

Action read_action(YamlReader& yaml, const ActionWords& words, const std::string& source) {
  Action action{std::filesystem::path(source).stem().string(), source, {}, {}};
  const YamlFields fields = yaml.fields({"action", 0, {1, 1}}, kActionMap);
  if (const auto name = yaml.find(fields, "name")) action.id = yaml.text(*name).value_or(action.id);
  if (const auto name = yaml.find(fields, "robot")) action.robot = yaml.text(*name).value_or("");
  if (const auto list = yaml.find(fields, "adapt_coordinates"))
    action.adapt_coordinates = read_adaptations(yaml, words, *list);
  if (!yaml.node(0).is_map()) return action;
  if (const auto steps = yaml.require(fields, "steps"))
    action.steps = read_steps(yaml, words, *steps);
  return action;
}

}  // namespace

Action parse_action(const std::string& text, const std::string& source, const RobotModel& model,
                    const ActionVocabulary& vocabulary) {
  Violations violations(source);
  YamlTree tree = parse_yaml(text, source, violations);
  fill_placeholders(tree, vocabulary.placeholders, violations);
  YamlReader yaml(tree, violations);
  Action action = read_action(yaml, action_words(model, vocabulary), source);
  violations.throw_if_any();
  return action;
}

std::string written_for(const std::string& text, const std::string& source) {
  Violations violations(source);
  const YamlTree tree = parse_yaml(text, source, violations);
  const YamlNode& root = tree.front();
  for (std::size_t k = 0; root.is_map() && k + 1 < root.children.size(); k += 2) {
    const auto node = [&](std::size_t i) -> const YamlNode& {
      return tree[static_cast<std::size_t>(root.children[i])];
    };
    if (node(k).text == "robot" && node(k + 1).is_scalar()) return node(k + 1).text;
  }
  return "";
}

Action load_action(const std::string& path, const RobotModel& model,
                   const ActionVocabulary& vocabulary) {
  return parse_action(read_text(path, kMaxYamlText), path, model, vocabulary);
}

}  // namespace hexagait::action
