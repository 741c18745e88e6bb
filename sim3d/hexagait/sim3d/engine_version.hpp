// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hexagait::sim3d {

/// "0.16.2 (libode.so.8)": the version of ODE that was compiled against, and the library in use.
[[nodiscard]] std::string engine_version();

}  // namespace hexagait::sim3d
