// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/text/violations.hpp>
#include <hexagait/yaml/yaml_tree.hpp>
#include <map>
#include <string>
#include <vector>

namespace hexagait {

/// Puts values in the place of `$name` and `${name}` in all scalars of a document, keys not among
/// them. Values are those given, else those under the key `placeholders` of the root. A value is a
/// scalar or a list of scalars; a list only where the placeholder is all of the scalar. A `$` that
/// no name follows stays. What was put in is not searched again.
/// @param given  name → YAML of its value
void fill_placeholders(YamlTree& tree, const std::map<std::string, std::string>& given,
                       Violations& violations);

/// The names of the placeholders that a document uses or has defaults for, each once, in order.
[[nodiscard]] std::vector<std::string> placeholder_names(const YamlTree& tree);

}  // namespace hexagait
