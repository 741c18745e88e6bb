// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/sim2d/genghis_world.hpp>
#include <hexagait/sim2d/slice_model.hpp>

int main() { std::printf("sim2d: strokes of %.0f units\n", 2 * hexagait::sim2d::kHalfStroke); }
