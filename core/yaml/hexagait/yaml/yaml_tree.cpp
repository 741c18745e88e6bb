// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/violations.hpp>
#include <hexagait/yaml/yaml_tree.hpp>
#include <map>
#include <sstream>
#include <string_view>

namespace hexagait {
namespace {

constexpr int kMaxDepth = 64;

Mark to_mark(const YAML::Mark& mark) { return {mark.line + 1, mark.column + 1}; }

/// Puts a tree together from the parser's events, which tell of anchors and places.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(std::string source) : source_(std::move(source)) {}

  [[nodiscard]] YamlTree take() { return std::move(tree_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(YamlNode::Kind::null, mark, anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const int node = anchor < anchored_.size() ? anchored_[anchor] : -1;
    if (node < 0 || std::find(open_.begin(), open_.end(), node) != open_.end())
      throw InvalidInput(fmt::format("{}:{}:{}: refers to what it is itself a part of", source_,
                                     mark.line + 1, mark.column + 1));
    if (!open_.empty()) at(open_.back()).children.push_back(node);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    const int node = add(YamlNode::Kind::scalar, mark, anchor);
    at(node).text = value;
    at(node).quoted = tag == "!";
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open_.push_back(add(YamlNode::Kind::list, mark, anchor));
  }
  void OnSequenceEnd() override { open_.pop_back(); }

  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open_.push_back(add(YamlNode::Kind::map, mark, anchor));
  }
  void OnMapEnd() override { open_.pop_back(); }

 private:
  YamlNode& at(int node) { return tree_[static_cast<std::size_t>(node)]; }

  int add(YamlNode::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    const int node = static_cast<int>(tree_.size());
    const int parent = open_.empty() ? -1 : open_.back();
    tree_.push_back({.kind = kind, .mark = to_mark(mark), .parent = parent});
    if (parent >= 0) at(parent).children.push_back(node);
    if (anchor != 0) {
      if (anchored_.size() <= anchor) anchored_.resize(anchor + 1, -1);
      anchored_[anchor] = node;
    }
    return node;
  }

  std::string source_;
  YamlTree tree_;
  std::vector<int> open_;      // lists and maps that have not ended, from the root
  std::vector<int> anchored_;  // [anchor]: node
};

void find_repeated_keys(const YamlTree& tree, Violations& violations) {
  for (const YamlNode& node : tree) {
    if (!node.is_map()) continue;
    std::map<std::string_view, Mark> keys;
    for (std::size_t i = 0; i < node.children.size(); i += 2) {
      const YamlNode& key = tree[static_cast<std::size_t>(node.children[i])];
      if (!key.is_scalar()) continue;
      const auto [first, is_new] = keys.emplace(key.text, key.mark);
      if (!is_new)
        violations.add(key.mark, fmt::format("the key \"{:.60}\" stands here a second time; the "
                                             "first is at {}:{}",
                                             key.text, first->second.line, first->second.column));
    }
  }
}

void emit(YAML::Emitter& out, const YamlTree& tree, int index) {
  const YamlNode& node = tree[static_cast<std::size_t>(index)];
  switch (node.kind) {
    case YamlNode::Kind::null:
      out << YAML::Null;
      return;
    case YamlNode::Kind::scalar:
      if (node.quoted) out << YAML::DoubleQuoted;
      out << node.text;
      return;
    case YamlNode::Kind::list:
      out << YAML::Flow << YAML::BeginSeq;
      for (const int child : node.children) emit(out, tree, child);
      out << YAML::EndSeq;
      return;
    case YamlNode::Kind::map:
      out << YAML::Flow << YAML::BeginMap;
      for (std::size_t i = 0; i + 1 < node.children.size(); i += 2) {
        out << YAML::Key;
        emit(out, tree, node.children[i]);
        out << YAML::Value;
        emit(out, tree, node.children[i + 1]);
      }
      out << YAML::EndMap;
  }
}

std::size_t size_below(const YamlTree& tree, int index, std::size_t limit, int depth) {
  if (depth > kMaxDepth) return limit;
  const YamlNode& node = tree[static_cast<std::size_t>(index)];
  std::size_t size = 1 + node.text.size();
  for (const int child : node.children) {
    if (size >= limit) return limit;
    size += size_below(tree, child, limit - size, depth + 1);
  }
  return std::min(size, limit);
}

}  // namespace

YamlTree parse_yaml(const std::string& text, const std::string& source, Violations& violations) {
  if (text.size() > kMaxYamlText)
    throw InvalidInput(
        fmt::format("{}: has {} bytes; at most {} are read", source, text.size(), kMaxYamlText));
  TreeBuilder builder(source);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    TreeBuilder second(source);
    if (parser.HandleNextDocument(second))
      throw InvalidInput(source + ": has more than one YAML document; one is read");
  } catch (const YAML::Exception& error) {
    throw InvalidInput(fmt::format("{}:{}:{}: not YAML: {}", source, error.mark.line + 1,
                                   error.mark.column + 1, error.msg));
  }
  YamlTree tree = builder.take();
  if (tree.empty()) tree.push_back({.mark = {1, 1}});
  find_repeated_keys(tree, violations);
  return tree;
}

std::string yaml_text(const YamlTree& tree, int node) {
  YAML::Emitter out;
  out.SetMapFormat(YAML::Flow);
  out.SetSeqFormat(YAML::Flow);
  emit(out, tree, node);
  return out.c_str();
}

std::size_t yaml_size(const YamlTree& tree, int node, std::size_t limit) {
  return size_below(tree, node, limit, 0);
}

}  // namespace hexagait
