// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/verify/verify.hpp>

int main() {
  using namespace hexagait::verify;
  const TheoremReport report = verify({}, {.legs = {6}, .step_time = 1});
  std::printf("verify: %zu theorems\n", report.theorems.size());
  return report.theorems.empty() ? 1 : 0;
}
