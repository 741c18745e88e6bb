// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/yaml/yaml_reader.hpp>

namespace hexagait {
namespace {

std::string description(NumberRule rule) {
  using Bound = NumberRule::Bound;
  std::string text(expected(rule.dimension));
  if (rule.bound == Bound::any) return text;
  text += rule.dimension == Dimension::number ? " of " : ", of ";
  return text + (rule.bound == Bound::positive ? "more than 0" : "0 or more");
}

std::string_view unit(Dimension dimension) {
  switch (dimension) {
    case Dimension::length:
      return " m";
    case Dimension::time:
      return " s";
    case Dimension::angle:
      return " rad";
    case Dimension::number:
    case Dimension::angular_rate:  // or its derivative
      break;
  }
  return "";
}

bool keeps(double value, NumberRule::Bound bound) {
  if (bound == NumberRule::Bound::positive) return value > 0.0;
  return bound == NumberRule::Bound::any || value >= 0.0;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 60;
  const bool is_cut = text.size() > kShown;
  if (is_cut) text = text.substr(0, kShown);
  // Not in the middle of a letter of several bytes.
  while (is_cut && !text.empty() && (static_cast<unsigned char>(text.back()) & 0x80U) != 0)
    text.remove_suffix(1);
  std::string shown = "\"";
  for (const char letter : text)
    shown += static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f ? '?' : letter;
  return shown + (is_cut ? "…\"" : "\"");
}

std::string in_words(const YamlNode& node) {
  if (node.is_scalar()) return in_quotes(node.text);
  if (node.is_list()) return fmt::format("a list of {}", node.children.size());
  return node.is_map() ? "a map" : "nothing";
}

void YamlReader::refuse(const Mark& mark, std::string_view problem) {
  ++num_refused_;
  violations_.add(mark, problem);
}

void YamlReader::stop(const Mark& mark, std::string_view problem) {
  refuse(mark, problem);
  violations_.throw_if_any();
  std::abort();  // there is one
}

void YamlReader::refuse(const YamlField& field, std::string_view must_be) {
  refuse(field.mark,
         fmt::format("{}: is {}; it must be {}", field.key, in_words(node(field.node)), must_be));
}

void YamlReader::refuse_word(const Mark& mark, std::string_view what, std::string_view word,
                             std::span<const std::string> known) {
  const std::optional<std::string> nearest = nearest_word(word, known);
  if (nearest)
    refuse(mark,
           fmt::format("unknown {} {}; did you mean \"{}\"?", what, in_quotes(word), *nearest));
  else if (known.empty())
    refuse(mark, fmt::format("unknown {} {}; none is known", what, in_quotes(word)));
  else
    refuse(mark,
           fmt::format("unknown {} {}; known: {}", what, in_quotes(word), fmt::join(known, ", ")));
}

YamlFields YamlReader::fields(const YamlField& map, const YamlKeys& allowed) {
  if (node(map.node).is_map()) return fields(map.mark, node(map.node).children, allowed);
  refuse(map, fmt::format("a map of {}", fmt::join(allowed.keys, ", ")));
  return {map.mark, &allowed, {}};
}

YamlFields YamlReader::fields(const Mark& mark, std::span<const int> keys_and_values,
                              const YamlKeys& allowed) {
  const std::vector<std::string> known(allowed.keys.begin(), allowed.keys.end());
  YamlFields found{mark, &allowed, {}};
  count(keys_and_values.size());
  for (std::size_t i = 0; i + 1 < keys_and_values.size(); i += 2) {
    const YamlNode& key = node(keys_and_values[i]);
    const YamlNode& value = node(keys_and_values[i + 1]);
    if (!key.is_scalar()) {
      refuse(key.mark, fmt::format("a key is {}; it must be a word", in_words(key)));
      continue;
    }
    const auto name = std::find(allowed.keys.begin(), allowed.keys.end(), key.text);
    if (name == allowed.keys.end())
      refuse_word(key.mark, fmt::format("key of {}", allowed.of), key.text, known);
    else
      found.fields.push_back(
          {*name, keys_and_values[i + 1], value.is_null() ? key.mark : value.mark});
  }
  return found;
}

std::optional<YamlField> YamlReader::find(const YamlFields& fields, std::string_view key) const {
  assert(std::ranges::find(fields.allowed->keys, key) != fields.allowed->keys.end());
  for (const YamlField& field : fields.fields)
    if (field.key == key) return field;
  return {};
}

std::optional<YamlField> YamlReader::require(const YamlFields& fields, std::string_view key) {
  const std::optional<YamlField> field = find(fields, key);
  if (!field)
    refuse(fields.mark, fmt::format("{}: the key \"{}\" is missing", fields.allowed->of, key));
  return field;
}

std::vector<YamlField> YamlReader::list(const YamlField& field) {
  if (!node(field.node).is_list()) {
    refuse(field, "a list");
    return {};
  }
  const std::vector<int>& children = node(field.node).children;
  count(children.size());
  std::vector<YamlField> values;
  values.reserve(children.size());
  for (const int child : children)
    values.push_back({field.key, child, node(child).is_null() ? field.mark : node(child).mark});
  return values;
}

std::optional<std::string> YamlReader::text(const YamlField& field) {
  if (node(field.node).is_scalar()) return node(field.node).text;
  refuse(field, "a text");
  return {};
}

std::optional<double> YamlReader::number(const YamlField& field, NumberRule rule) {
  const YamlNode& scalar = node(field.node);
  if (!scalar.is_scalar()) {
    refuse(field, description(rule));
    return {};
  }
  const auto [value, problem] = parse_quantity(scalar.text, rule.dimension);
  const bool is_tiny =
      rule.bound != NumberRule::Bound::any && 0.0 < value && value < kSmallestQuantity;
  if (!problem.empty())
    refuse(field.mark, fmt::format("{}: {}", field.key, problem));
  else if (is_tiny)
    refuse(field.mark, fmt::format("{}: {} is too small; the least that is read is {}", field.key,
                                   in_quotes(scalar.text), in_words(kSmallestQuantity)));
  else if (std::abs(value) > rule.most)
    refuse(field.mark,
           fmt::format("{}: {} is out of range; at most {}{} is read", field.key,
                       in_quotes(scalar.text), in_words(rule.most), unit(rule.dimension)));
  else if (!keeps(value, rule.bound))
    refuse(field, description(rule));
  else
    return value;
  return {};
}

std::optional<std::vector<double>> YamlReader::numbers(const YamlField& field,
                                                       std::span<const std::size_t> counts,
                                                       NumberRule rule) {
  const std::string must_be = fmt::format("a list of {} numbers", fmt::join(counts, " or "));
  const YamlNode& list_node = node(field.node);
  if (!list_node.is_list() ||
      std::find(counts.begin(), counts.end(), list_node.children.size()) == counts.end()) {
    refuse(field, must_be);
    return {};
  }
  std::vector<double> values;
  for (const YamlField& item : list(field))
    if (const std::optional<double> value = number(item, rule)) values.push_back(*value);
  if (values.size() != list_node.children.size()) return {};
  return values;
}

std::optional<Vector3> YamlReader::vector(const YamlField& field, NumberRule rule) {
  constexpr std::size_t kThree[] = {3};
  const std::optional<std::vector<double>> values = numbers(field, kThree, rule);
  if (!values) return {};
  return Vector3((*values)[0], (*values)[1], (*values)[2]);
}

std::optional<std::size_t> YamlReader::word(const YamlField& field,
                                            std::span<const std::string> known) {
  const YamlNode& scalar = node(field.node);
  if (!scalar.is_scalar()) {
    refuse(field, fmt::format("one of {}", fmt::join(known, ", ")));
    return {};
  }
  const auto found = std::find(known.begin(), known.end(), scalar.text);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  refuse_word(field.mark, field.key, scalar.text, known);
  return {};
}

double YamlReader::number_or(const YamlFields& fields, std::string_view key, double otherwise,
                             NumberRule rule) {
  const std::optional<YamlField> field = find(fields, key);
  return field ? number(*field, rule).value_or(otherwise) : otherwise;
}

bool YamlReader::flag_or(const YamlFields& fields, std::string_view key, bool otherwise) {
  const std::optional<YamlField> field = find(fields, key);
  if (!field) return otherwise;
  const YamlNode& scalar = node(field->node);
  if (scalar.is_scalar() && !scalar.quoted && scalar.text == "true") return true;
  if (scalar.is_scalar() && !scalar.quoted && scalar.text == "false") return false;
  refuse(*field, "true or false");
  return otherwise;
}

Vector3 YamlReader::vector_or(const YamlFields& fields, std::string_view key,
                              const Vector3& otherwise, NumberRule rule) {
  const std::optional<YamlField> field = find(fields, key);
  return field ? vector(*field, rule).value_or(otherwise) : otherwise;
}

void YamlReader::count(std::size_t values) {
  count_ += values;
  if (count_ > kMaxValues)
    stop({1, 1}, fmt::format("has more than {} values after references are followed", kMaxValues));
}

}  // namespace hexagait
