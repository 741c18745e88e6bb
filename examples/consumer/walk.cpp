// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/walk/schedule.hpp>

int main() {
  const auto schedule = hexagait::walk::random_schedule(1, 1.0, 10.0, 0.3);
  std::printf("walk: a schedule of %zu commands\n", schedule.size());
  return schedule.empty() ? 1 : 0;
}
