// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdio>
#include <hexagait/sim2d/slice_model.hpp>

namespace hexagait::sim2d {
namespace {
TEST(X, Y) {
  for (const char* terrain : {"flat", "descent:3-7", "descent:1-9", "profile:0", "profile:0.5",
                              "profile:1", "profile:2", "profile:4", "profile:8"})
    for (const char* gait : {"tripod", "free", "unadjusted", "literal", "wave:0.5", "wave:0.75",
                             "wave:0.8333333333333334"}) {
      double v = 0, S = 0, Sm = 0, f = 0, T = 0, lo = 99, hi = 0;
      int tri = -1;
      for (std::uint32_t t = 0; t < 100; ++t) {
        const auto s = run_slices({.gait = *gait_state::parse_gait_choice(gait),
                                   .terrain = *parse_slice_terrain(terrain)},
                                  {1, t});
        v += s.speed / 100;
        S += s.sweep / 100;
        Sm += s.sweep_mean / 100;
        f += s.fraction_of_bound() / 100;
        T += s.step_time / 100;
        lo = std::min(lo, s.speed);
        hi = std::max(hi, s.speed);
        tri = std::max(tri, s.tripod_after);
      }
      std::printf("%-12s %-10s v %.3f [%.2f %.2f] S %.1f mean %.1f frac %.3f T %.2f tri %d\n",
                  terrain, gait, v, lo, hi, S, Sm, f, T, tri);
    }
}
}  // namespace
}  // namespace hexagait::sim2d
