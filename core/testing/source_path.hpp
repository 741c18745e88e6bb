// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace hexagait::testing {

/// Where a file or folder of the project lies, by its path from the project's root: "robots/argos.urdf".
[[nodiscard]] std::string source_path(std::string_view from_root);

}  // namespace hexagait::testing
