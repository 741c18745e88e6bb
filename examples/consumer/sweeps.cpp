// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/sweep/sweep.hpp>

int main() {
  const auto trials = hexagait::sweep::num_trials(hexagait::sweep::Sweep{});
  std::printf("sweeps: %llu trials\n", static_cast<unsigned long long>(trials));
}
