// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/load/detail/action_commands.hpp>

namespace hexagait::action {

/// Reads the list under `steps`, with what `repeat` makes of it.
[[nodiscard]] std::vector<Step> read_steps(YamlReader& yaml, const ActionWords& words,
                                           const YamlField& list);

}  // namespace hexagait::action
