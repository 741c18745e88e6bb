// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/sim3d/detail/png.hpp>

namespace hexagait::sim3d::detail {

std::string read_png(const std::string&, std::size_t, Heightmap&) {
  return "this hexagait was built without libpng; a table of numbers (CSV) can be read";
}

}  // namespace hexagait::sim3d::detail
