// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <hexagait/figures/gnuplot.hpp>

int main() { std::printf("figures: %s\n", hexagait::figures::in_quotes("a text").c_str()); }
