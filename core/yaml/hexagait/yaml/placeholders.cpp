// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/yaml/placeholders.hpp>
#include <hexagait/yaml/yaml_reader.hpp>
#include <optional>
#include <set>
#include <string_view>

namespace hexagait {
namespace {

constexpr std::size_t kMaxListed = 100;
constexpr std::size_t kCostOfNode = 100;
constexpr std::size_t kMaxFilled = 1'000'000;

struct Value {
  bool is_list = false;
  bool quoted = false;
  std::string text;
  std::vector<std::pair<std::string, bool>> items;  // text, quoted
};

std::optional<Value> as_value(const YamlTree& tree, int index) {
  const YamlNode& node = tree[static_cast<std::size_t>(index)];
  if (node.is_scalar()) return Value{false, node.quoted, node.text, {}};
  if (!node.is_list() || node.children.size() > kMaxListed) return {};
  Value value{.is_list = true, .text = {}, .items = {}};
  for (const int child : node.children) {
    const YamlNode& item = tree[static_cast<std::size_t>(child)];
    if (!item.is_scalar()) return {};
    value.items.emplace_back(item.text, item.quoted);
  }
  return value;
}

bool is_letter(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_';
}

/// A placeholder found in a text: it takes the place of text[begin, end).
struct Use {
  std::size_t begin, end;
  std::string name;
};

std::optional<Use> next_use(std::string_view text, std::size_t from) {
  for (std::size_t at = text.find('$', from); at != text.npos; at = text.find('$', at + 1)) {
    const bool braced = at + 1 < text.size() && text[at + 1] == '{';
    const std::size_t first = at + (braced ? 2 : 1);
    std::size_t last = first;
    while (last < text.size() && is_letter(text[last])) ++last;
    const bool closed = !braced || (last < text.size() && text[last] == '}');
    if (last > first && closed)
      return Use{at, last + (braced ? 1 : 0), std::string(text.substr(first, last - first))};
  }
  return {};
}

class Filler {
 public:
  Filler(YamlTree& tree, Violations& violations) : tree_(tree), violations_(violations) {}

  // The defaults of the file: the nodes [first, end) under the root's `placeholders`.
  void read_defaults() {
    const YamlNode& root = tree_.front();
    if (!root.is_map()) return;
    for (std::size_t i = 0; i + 1 < root.children.size(); i += 2) {
      if (at(root.children[i]).text != "placeholders") continue;
      const YamlNode& map = at(root.children[i + 1]);
      if (!map.is_map()) {
        add(at(root.children[i]).mark,
            fmt::format("placeholders: is {}; it must be a map of names and values",
                        in_words(map)));
        return;
      }
      first_default_ = root.children[i + 1];
      end_default_ =
          i + 2 < root.children.size() ? root.children[i + 2] : static_cast<int>(tree_.size());
      for (std::size_t k = 0; k + 1 < map.children.size(); k += 2)
        read_default(at(map.children[k]), map.children[k + 1]);
      return;
    }
  }

  void read_given(const std::map<std::string, std::string>& given) {
    for (const auto& [name, text] : given) {
      const std::string source = fmt::format("placeholder {}", in_quotes(name));
      Violations none(source);
      const std::optional<Value> value = as_value(parse_yaml(text, source, none), 0);
      if (!value)
        throw InvalidInput(
            fmt::format("{}: is {}; it must be a value or a list of at most {} "
                        "values",
                        source, in_quotes(text), kMaxListed));
      values_[name] = *value;
    }
  }

  void fill() {
    for (const auto& [name, value] : values_) names_.push_back(name);
    const int end = static_cast<int>(tree_.size());
    std::vector<bool> is_key(tree_.size());
    for (const YamlNode& node : tree_)
      for (std::size_t i = 0; node.is_map() && i < node.children.size(); i += 2)
        is_key[static_cast<std::size_t>(node.children[i])] = true;
    for (int i = 0; i < end; ++i) {
      const bool is_default = first_default_ <= i && i < end_default_;
      if (!is_default && !is_key[static_cast<std::size_t>(i)] && at(i).is_scalar()) fill(i);
    }
  }

 private:
  YamlNode& at(int index) { return tree_[static_cast<std::size_t>(index)]; }

  void add(const Mark& mark, const std::string& problem) { violations_.add(mark, problem); }

  void read_default(const YamlNode& key, int index) {
    const std::optional<Value> value = as_value(tree_, index);
    if (!key.is_scalar() || key.text.empty() || !std::ranges::all_of(key.text, is_letter))
      add(key.mark, fmt::format("a placeholder's name is {}; it must be of letters, digits and _",
                                in_words(key)));
    else if (!value)
      add(key.mark, fmt::format("placeholder {}: is {}; it must be a value or a list of at most {} "
                                "values",
                                in_quotes(key.text), in_words(at(index)), kMaxListed));
    else
      values_[key.text] = *value;
  }

  // The value of a placeholder used in node `index`, if there is one.
  const Value* find(int index, const std::string& name) {
    const auto found = values_.find(name);
    if (found != values_.end()) return &found->second;
    const std::optional<std::string> nearest = nearest_word(name, names_);
    add(at(index).mark,
        fmt::format("unknown placeholder {}; {}", in_quotes(name),
                    nearest ? fmt::format("did you mean \"{}\"?", *nearest)
                            : std::string("give it a default under \"placeholders\"")));
    return nullptr;
  }

  void spend(std::size_t cost) {
    spent_ += cost;
    if (spent_ <= kMaxFilled) return;
    add(at(0).mark, fmt::format("placeholders make more than {} letters of it", kMaxFilled));
    violations_.throw_if_any();
  }

  void fill(int index) {
    const std::string text = at(index).text;
    std::string filled;
    std::size_t from = 0;
    for (auto use = next_use(text, 0); use; use = next_use(text, use->end)) {
      const Value* value = find(index, use->name);
      if (!value) return;
      const bool is_all = use->begin == 0 && use->end == text.size();
      if (is_all) return replace(index, *value);
      if (value->is_list) {
        add(at(index).mark, fmt::format("placeholder {}: is a list; it can't be a part of {}",
                                        in_quotes(use->name), in_quotes(text)));
        return;
      }
      spend(value->text.size());
      filled.append(text, from, use->begin - from).append(value->text);
      from = use->end;
    }
    at(index).text = filled.append(text, from);
  }

  // A scalar becomes the value; what is wrong with it is told of where it is used.
  void replace(int index, const Value& value) {
    spend(value.text.size() + kCostOfNode * value.items.size());
    const Mark mark = at(index).mark;
    at(index).text = value.text;
    at(index).quoted = value.quoted;
    if (!value.is_list) return;
    at(index).kind = YamlNode::Kind::list;
    for (const auto& [item, item_quoted] : value.items) {
      spend(item.size());
      at(index).children.push_back(static_cast<int>(tree_.size()));
      tree_.push_back({YamlNode::Kind::scalar, item_quoted, mark, index, item, {}});
    }
  }

  YamlTree& tree_;
  Violations& violations_;
  std::map<std::string, Value> values_;
  std::vector<std::string> names_;
  int first_default_ = 0, end_default_ = 0;
  std::size_t spent_ = 0;
};

}  // namespace

std::vector<std::string> placeholder_names(const YamlTree& tree) {
  std::set<std::string> names;
  const auto node = [&](int index) -> const YamlNode& {
    return tree[static_cast<std::size_t>(index)];
  };
  const YamlNode& root = tree.front();
  for (std::size_t i = 0; root.is_map() && i + 1 < root.children.size(); i += 2) {
    const YamlNode& map = node(root.children[i + 1]);
    if (node(root.children[i]).text != "placeholders" || !map.is_map()) continue;
    for (std::size_t k = 0; k + 1 < map.children.size(); k += 2)
      names.insert(node(map.children[k]).text);
  }
  for (const YamlNode& scalar : tree)
    for (auto use = next_use(scalar.text, 0); use; use = next_use(scalar.text, use->end))
      names.insert(use->name);
  return {names.begin(), names.end()};
}

void fill_placeholders(YamlTree& tree, const std::map<std::string, std::string>& given,
                       Violations& violations) {
  Filler filler(tree, violations);
  filler.read_defaults();
  filler.read_given(given);
  filler.fill();
}

}  // namespace hexagait
