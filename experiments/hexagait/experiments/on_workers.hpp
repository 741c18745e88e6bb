// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <hexagait/experiments/experiment.hpp>
#include <mutex>
#include <vector>

namespace hexagait::experiments {

/// Does work(k) for each k < count on so many threads, and done(k) after each, one at a time; tells
/// the progress. What has been done before may be left out of the count.
/// @returns false if it was stopped before the end
template <class Work, class Done>
[[nodiscard]] bool on_workers(const ExperimentContext& context, std::size_t count, int threads,
                              Work work, Done done, std::size_t before = 0) {
  std::atomic<std::size_t> next = 0;
  std::size_t finished = 0;
  std::mutex one_at_a_time;
  const auto loop = [&] {
    for (std::size_t k = next++; k < count && !context.stopped(); k = next++) {
      work(k);
      const std::scoped_lock lock(one_at_a_time);
      if (context.stopped()) return;
      done(k);
      context.tell(before + ++finished, before + count);
    }
  };
  std::vector<std::future<void>> workers(static_cast<std::size_t>(std::max(1, threads)));
  for (std::future<void>& worker : workers) worker = std::async(std::launch::async, loop);
  for (std::future<void>& worker : workers) worker.get();
  return !context.stopped();
}

}  // namespace hexagait::experiments
