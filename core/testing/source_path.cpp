// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <testing/source_path.hpp>

namespace hexagait::testing {

std::string source_path(std::string_view from_root) {
  return HEXAGAIT_SOURCE_DIR "/" + std::string(from_root);
}

}  // namespace hexagait::testing
