// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <box2d/b2_common.h>

#include <hexagait/sim2d/engine_version.hpp>

namespace hexagait::sim2d {

std::string engine_version() {
  return std::to_string(b2_version.major) + '.' + std::to_string(b2_version.minor) + '.' +
         std::to_string(b2_version.revision);
}

}  // namespace hexagait::sim2d
