// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hexagait::sweep {

/// Successive positions of a shard.
struct Chunk {
  std::uint64_t first = 0, count = 0;
};

/// What came of a chunk.
struct Answer {
  enum class End {
    finished,
    died,     ///< the worker ended, and all its lines are lost
    overdue,  ///< it took too long, and was ended
  };
  Chunk chunk;
  End end = End::finished;
  std::string lines = {};   ///< of the journal, one per trial
  std::string reason = {};  ///< how a worker died
  double seconds = 0.0;     ///< from assignment to answer [s]
};

/// Processes that run trials: ODE worlds are not safe in threads, and one that dies takes nothing
/// else with it. They are forked, so they see what their parent had prepared, and end with it.
class WorkerPool {
 public:
  /// Runs in a worker: the journal's line of the trial at a position. Must not throw.
  using Work = std::function<std::string(std::uint64_t position)>;

  /// @param time_limit  for a chunk [s]
  /// @throws std::runtime_error  if the system has no more processes
  WorkerPool(int jobs, Work work, double time_limit);
  ~WorkerPool();  ///< ends the workers, whatever they do
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Workers that wait for a chunk, and those that work on one.
  [[nodiscard]] int idle() const;
  [[nodiscard]] int busy() const;

  /// Gives a chunk to a worker that is idle.
  void assign(const Chunk& chunk);

  /// Waits for answers, at most so long. A worker that died, or is ended since it takes too long,
  /// answers for its chunk, and another takes its place.
  [[nodiscard]] std::vector<Answer> wait(std::chrono::milliseconds patience);

 private:
  struct Worker {
    pid_t process = -1;
    int requests = -1, answers = -1;  // our ends of its pipes
    std::optional<Chunk> chunk;       // that it works on
    std::chrono::steady_clock::time_point since = {};
  };
  [[nodiscard]] Worker spawn();
  [[nodiscard]] static std::optional<Answer> receive(Worker& worker);
  [[nodiscard]] static std::string bury(Worker& worker);
  [[nodiscard]] std::optional<Answer> answer(Worker& worker, bool is_ready);
  void forgive_a_pause();
  void replace_the_dead();

  Work work_;
  std::chrono::duration<double> time_limit_;
  std::vector<Worker> workers_;
  std::chrono::steady_clock::time_point awake_;  // when wait() was last seen
};

}  // namespace hexagait::sweep
