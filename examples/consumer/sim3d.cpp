// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/sim3d/terrain.hpp>

int main() {
  const auto& terrains = hexagait::sim3d::known_terrains();
  std::printf("sim3d: %zu terrains\n", terrains.size());
  return terrains.empty() ? 1 : 0;
}
