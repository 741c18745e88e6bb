// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <hexagait/sweep/detail/worker_pool.hpp>
#include <hexagait/sweep/detail/write_all.hpp>
#include <stdexcept>

namespace hexagait::sweep {
namespace {

using Clock = std::chrono::steady_clock;

// A process that did not run for so long was stopped, or its machine slept: no worker is to blame.
constexpr std::chrono::seconds kPause{5};

// As it lies in memory: parent and worker are one program.
template <class Value>
std::string_view bytes_of(const Value& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

bool read_all(int file, void* bytes, std::size_t size) {
  char* to = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t got = read(file, to, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    to += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

// The life of a worker: chunks in, answers out, until its parent closes the pipe or is gone.
void serve(int requests, int answers, const WorkerPool::Work& work) {
  Chunk chunk;
  while (read_all(requests, &chunk, sizeof chunk)) {
    std::string lines;
    for (std::uint64_t k = 0; k < chunk.count; ++k) lines += work(chunk.first + k);
    const std::uint64_t size = lines.size();
    if (write_all(answers, bytes_of(size)) != 0 || write_all(answers, lines) != 0) return;
  }
}

// Ctrl-C reaches the whole group of processes: the parent decides what it means.
[[noreturn]] void live(pid_t parent, int requests, int answers, const WorkerPool::Work& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  signal(SIGINT, SIG_IGN);
  signal(SIGTERM, SIG_DFL);
  signal(SIGPIPE, SIG_IGN);
  serve(requests, answers, work);
  _exit(0);
}

}  // namespace

WorkerPool::WorkerPool(int jobs, Work work, double time_limit)
    : work_(std::move(work)), time_limit_(time_limit), awake_(Clock::now()) {
  for (int job = 0; job < jobs; ++job) workers_.push_back(spawn());
}

WorkerPool::~WorkerPool() {
  for (Worker& worker : workers_) kill(worker.process, SIGKILL);
  for (Worker& worker : workers_) static_cast<void>(bury(worker));
}

WorkerPool::Worker WorkerPool::spawn() {
  std::fflush(nullptr);  // or the child would print it again
  int requests[2], answers[2];
  const auto must = [](int result) {
    if (result < 0)
      throw std::runtime_error(fmt::format("can't start a worker: {}", std::strerror(errno)));
    return result;
  };
  must(pipe(requests));
  must(pipe(answers));
  const pid_t parent = getpid(), process = must(fork());
  if (process == 0) {
    // Of the parent's ends of all pipes this process inherited copies.
    for (const Worker& other : workers_) {
      close(other.requests);
      close(other.answers);
    }
    close(requests[1]);
    close(answers[0]);
    live(parent, requests[0], answers[1], work_);
  }
  close(requests[0]);
  close(answers[1]);
  return {.process = process, .requests = requests[1], .answers = answers[0], .chunk = {}};
}

int WorkerPool::busy() const {
  return static_cast<int>(
      std::ranges::count_if(workers_, [](const Worker& w) { return w.chunk.has_value(); }));
}

int WorkerPool::idle() const { return static_cast<int>(workers_.size()) - busy(); }

void WorkerPool::assign(const Chunk& chunk) {
  const auto worker =
      std::ranges::find_if(workers_, [](const Worker& w) { return !w.chunk.has_value(); });
  if (worker == workers_.end()) throw std::logic_error("no worker is idle");
  worker->chunk = chunk;
  worker->since = Clock::now();
  // If it is dead, wait() finds that it has closed its end.
  static_cast<void>(write_all(worker->requests, bytes_of(chunk)));
}

std::vector<Answer> WorkerPool::wait(std::chrono::milliseconds patience) {
  forgive_a_pause();
  std::vector<pollfd> files;
  for (const Worker& worker : workers_) files.push_back({worker.answers, POLLIN, 0});
  std::vector<Answer> answers;
  const int ready = poll(files.data(), files.size(), static_cast<int>(patience.count()));
  for (std::size_t i = 0; i < files.size(); ++i)
    if (auto found = answer(workers_[i], ready > 0 && files[i].revents != 0))
      answers.push_back(std::move(*found));
  replace_the_dead();
  return answers;
}

// A worker's answer, if there is one to be had. What is no whole answer means that the worker died.
std::optional<Answer> WorkerPool::answer(Worker& worker, bool is_ready) {
  const std::chrono::duration<double> taken = Clock::now() - worker.since;
  const bool overdue = !is_ready && worker.chunk && taken > time_limit_;
  if (!is_ready && !overdue) return {};
  std::optional<Answer> result = is_ready ? receive(worker) : std::nullopt;
  if (!result) {
    result = {.chunk = worker.chunk.value_or(Chunk{}),
              .end = overdue ? Answer::End::overdue : Answer::End::died,
              .reason = bury(worker)};
  }
  result->seconds = taken.count();
  worker.chunk.reset();
  if (result->chunk.count == 0) return {};  // it had no chunk to answer for
  return result;
}

void WorkerPool::forgive_a_pause() {
  const auto now = Clock::now();
  if (const auto gap = now - awake_; gap > kPause)
    for (Worker& worker : workers_) worker.since += gap;
  awake_ = now;
}

// If the system has no more processes, the workers that are left go on alone.
void WorkerPool::replace_the_dead() {
  const auto is_dead = [](const Worker& worker) { return worker.process < 0; };
  const auto dead = std::ranges::count_if(workers_, is_dead);
  std::erase_if(workers_, is_dead);
  try {
    for (auto k = dead; k > 0; --k) workers_.push_back(spawn());
  } catch (const std::runtime_error&) {
    if (workers_.empty()) throw;
  }
}

std::optional<Answer> WorkerPool::receive(Worker& worker) {
  std::uint64_t size = 0;
  if (!worker.chunk || !read_all(worker.answers, &size, sizeof size)) return {};
  Answer answer{.chunk = *worker.chunk};
  answer.lines.resize(size);
  if (!read_all(worker.answers, answer.lines.data(), size)) return {};
  return answer;
}

// Ends a worker and says how it ended.
std::string WorkerPool::bury(Worker& worker) {
  close(worker.requests);
  close(worker.answers);
  kill(worker.process, SIGKILL);
  int status = 0;
  while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
  }
  worker.process = -1;
  if (WIFSIGNALED(status))
    return fmt::format("the process that ran it was ended by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  return fmt::format("the process that ran it ended with status {}", WEXITSTATUS(status));
}

}  // namespace hexagait::sweep
