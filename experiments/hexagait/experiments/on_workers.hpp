// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <hexagait/experiments/experiment.hpp>
#include <hexagait/experiments/row_journal.hpp>
#include <hexagait/recording/version.hpp>
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

/// Makes the rows 1 … count of an experiment that takes long, on its workers. Those that the journal of
/// a run that was stopped has are only read again.
/// @param what    all on which the rows depend but for the program, a line; its first word names the journal
/// @param read    (number, row): takes a row of the journal
/// @param make    (number): makes one
/// @param row_of  (number): the row that was made, a line
/// @returns false if it was stopped before the end
template <class Read, class Make, class RowOf>
[[nodiscard]] bool all_rows(const ExperimentContext& context, const std::string& what,
                            std::uint64_t count, Read read, Make make, RowOf row_of) {
  RowJournal journal(context.directory / (what.substr(0, what.find(' ')) + ".journal"),
                     what + " of hexagait " + recording::kVersion + " (" + recording::kRevision +
                         ", " + recording::kCompiler + ")");
  std::vector<std::uint64_t> left;
  for (std::uint64_t number = 1; number <= count; ++number) {
    const auto row = journal.rows().find(number);
    if (row == journal.rows().end())
      left.push_back(number);
    else
      read(number, row->second);
  }
  const bool all = on_workers(
      context, left.size(), context.jobs, [&](std::size_t k) { make(left[k]); },
      [&](std::size_t k) { journal.add(left[k], row_of(left[k])); },
      static_cast<std::size_t>(count) - left.size());
  if (all) journal.remove();
  return all;
}

}  // namespace hexagait::experiments
