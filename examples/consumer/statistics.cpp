// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdio>
#include <hexagait/statistics/statistics.hpp>

int main() {
  const auto estimate = hexagait::statistics::estimate(std::array{1.0, 2.0, 3.0});
  std::printf("statistics: mean %.1f\n", estimate.mean);
  return estimate.mean == 2.0 ? 0 : 1;
}
