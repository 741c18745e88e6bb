// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sim/ground_truth.hpp>

int main() { std::printf("sim: truth of %zu bytes\n", sizeof(hexagait::GroundTruth)); }
