// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <hexagait/sim2d/slice_model.hpp>

// How many slices of the slice model one core makes in a second: `items_per_second`.
namespace hexagait::sim2d {
namespace {

void slices(benchmark::State& state, const char* gait, const char* terrain) {
  const SliceConfig config{.gait = *gait_state::parse_gait_choice(gait),
                           .terrain = *parse_slice_terrain(terrain)};
  SliceSeed seed;
  for (auto _ : state) {
    ++seed.trial;
    benchmark::DoNotOptimize(run_slices(config, seed));
  }
  state.SetItemsProcessed(state.iterations() * config.slices);
}
BENCHMARK_CAPTURE(slices, free_flat, "free", "flat");
BENCHMARK_CAPTURE(slices, free_descent, "free", "descent:3-7");
BENCHMARK_CAPTURE(slices, free_profile, "free", "profile:4");
BENCHMARK_CAPTURE(slices, tripod_flat, "tripod", "flat");
BENCHMARK_CAPTURE(slices, wave_flat, "wave:0.75", "flat");

}  // namespace
}  // namespace hexagait::sim2d
