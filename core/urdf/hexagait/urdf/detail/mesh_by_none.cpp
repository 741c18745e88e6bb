// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/urdf/detail/meshes.hpp>

namespace hexagait {

std::vector<Vector3> read_mesh(const std::string&, std::string& problem) {
  problem = "is not read: this hexagait is built without assimp (HEXAGAIT_MESHES)";
  return {};
}

}  // namespace hexagait
