// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hexagait::sweep {

/// "; did you mean 'seeds'?" if a word is the beginning of one that is known, or a slip of it, at
/// most a third of its letters wrong, missing, or too many; else "; there are a, b, c".
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace hexagait::sweep
