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
  Chunk chunk;
  std::string lines = {};    ///< of the journal, one per finished trial
  std::string failure = {};  ///< why others did not finish, else empty
  double seconds = 0.0;      ///< from assignment to answer [s]
};

/// Processes that run trials: ODE worlds are not safe in threads, and one that dies takes nothing
/// else with it. They are forked, so they see what their parent had prepared, and end with it.
class WorkerPool {
 public:
  /// Runs in a worker: the journal's line of the trial at a position. What it throws is a failure
  /// of this trial alone.
  using Work = std::function<std::string(std::uint64_t position)>;

  /// @throws std::runtime_error  if the system has no more processes
  WorkerPool(int jobs, const Work& work);
  ~WorkerPool();  ///< ends the workers, whatever they do
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Workers that wait for a chunk, and those that work on one.
  [[nodiscard]] int idle() const;
  [[nodiscard]] int busy() const;

  /// Gives a chunk to a worker that is idle.
  void assign(const Chunk& chunk);

  /// Waits for answers, at most so long. A worker that died answers with a failure, and is gone.
  [[nodiscard]] std::vector<Answer> wait(std::chrono::milliseconds patience);

 private:
  struct Worker {
    pid_t process = -1;
    int requests = -1, answers = -1;  // our ends of its pipes
    std::optional<Chunk> chunk;       // that it works on
    std::chrono::steady_clock::time_point since = {};
  };
  [[nodiscard]] Worker spawn(const Work& work);
  [[nodiscard]] static std::optional<Answer> receive(Worker& worker);
  [[nodiscard]] static std::string bury(Worker& worker);

  std::vector<Worker> workers_;
};

}  // namespace hexagait::sweep
