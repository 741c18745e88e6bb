// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <hexagait/experiments/manifest.hpp>
#include <vector>

namespace hexagait::experiments {

/// index.html in `out`: the experiments with their claims, whether each holds, numbers and figures.
/// The figures are in the page itself; tables and manifests are linked, in the directories where
/// run() has put them. No script, nothing from elsewhere.
/// @throws InvalidInput  if it can't be written
void write_page(const std::vector<Manifest>& manifests, const std::filesystem::path& out);

}  // namespace hexagait::experiments
