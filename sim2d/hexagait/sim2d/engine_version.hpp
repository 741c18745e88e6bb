// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hexagait::sim2d {

/// "2.4.1": the version of Box2D in use.
[[nodiscard]] std::string engine_version();

}  // namespace hexagait::sim2d
