// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/text/mark.hpp>
#include <string>
#include <vector>

namespace hexagait {

class Violations;

/// A value of a YAML document. References are resolved: what is referred to several times is the
/// child of several nodes. Nothing contains itself.
struct YamlNode {
  enum class Kind : std::uint8_t { null, scalar, list, map };
  Kind kind = Kind::null;
  bool quoted = false;             ///< a scalar that is text whatever it looks like
  Mark mark = {};                  ///< where it is written, not where it is referred to
  int parent = -1;                 ///< the list or map in which it is written
  std::string text = {};           ///< of a scalar
  std::vector<int> children = {};  ///< list: its values; map: key, value, key, value, …

  [[nodiscard]] bool is_scalar() const { return kind == Kind::scalar; }
  [[nodiscard]] bool is_list() const { return kind == Kind::list; }
  [[nodiscard]] bool is_map() const { return kind == Kind::map; }
  [[nodiscard]] bool is_null() const { return kind == Kind::null; }
};

/// The nodes of a document in the order in which they are written, the root first: children are
/// indices, so that a tree takes no more memory than its text asks for, whatever it refers to.
using YamlTree = std::vector<YamlNode>;

/// Largest text that is read [bytes].
inline constexpr std::size_t kMaxYamlText = 1'000'000;

/// Reads one YAML 1.2 document; an empty text is one null. Keys that stand twice in a map are added
/// to the violations.
/// @throws InvalidInput  if the text is larger than kMaxYamlText, is not YAML, has more than one
///                       document, or something in it that refers to itself
[[nodiscard]] YamlTree parse_yaml(const std::string& text, const std::string& source,
                                  Violations& violations);

/// A value as YAML of one line. The tree below it must be small: yaml_size().
[[nodiscard]] std::string yaml_text(const YamlTree& tree, int node);

/// Letters and values below a node, counted as often as they are referred to; counting ends at the
/// limit, and a value nested deeper than 64 counts as the limit.
[[nodiscard]] std::size_t yaml_size(const YamlTree& tree, int node, std::size_t limit);

}  // namespace hexagait
