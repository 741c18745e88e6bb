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
#include <hexagait/sweep/worker_pool.hpp>
#include <stdexcept>

namespace hexagait::sweep {
namespace {

using Clock = std::chrono::steady_clock;

// Precedes every answer: how long its two texts are.
struct AnswerSize {
  std::uint64_t lines = 0, failure = 0;
};

bool write_all(int file, const void* bytes, std::size_t size) {
  const char* from = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t written = write(file, from, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    from += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
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
    std::string lines, failure;
    for (std::uint64_t k = 0; k < chunk.count; ++k) {
      try {
        lines += work(chunk.first + k);
      } catch (const std::exception& error) {
        failure = error.what();
      }
    }
    const AnswerSize size{lines.size(), failure.size()};
    if (!write_all(answers, &size, sizeof size) ||
        !write_all(answers, lines.data(), lines.size()) ||
        !write_all(answers, failure.data(), failure.size()))
      return;
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

WorkerPool::WorkerPool(int jobs, const Work& work) {
  std::fflush(nullptr);  // or the children would print it again
  for (int job = 0; job < jobs; ++job) workers_.push_back(spawn(work));
}

WorkerPool::~WorkerPool() {
  for (Worker& worker : workers_) kill(worker.process, SIGKILL);
  for (Worker& worker : workers_) static_cast<void>(bury(worker));
}

WorkerPool::Worker WorkerPool::spawn(const Work& work) {
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
    // The parent's ends of all pipes are not ours.
    for (const Worker& other : workers_) {
      close(other.requests);
      close(other.answers);
    }
    close(requests[1]);
    close(answers[0]);
    live(parent, requests[0], answers[1], work);
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
  static_cast<void>(write_all(worker->requests, &chunk, sizeof chunk));
}

std::vector<Answer> WorkerPool::wait(std::chrono::milliseconds patience) {
  std::vector<pollfd> files;
  for (const Worker& worker : workers_) files.push_back({worker.answers, POLLIN, 0});
  std::vector<Answer> answers;
  if (poll(files.data(), files.size(), static_cast<int>(patience.count())) <= 0) return answers;

  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].revents == 0) continue;
    Worker& worker = workers_[i];
    std::optional<Answer> answer = receive(worker);
    if (!answer) answer = {.chunk = worker.chunk.value_or(Chunk{}), .failure = bury(worker)};
    answer->seconds = std::chrono::duration<double>(Clock::now() - worker.since).count();
    worker.chunk.reset();
    answers.push_back(std::move(*answer));
  }
  std::erase_if(workers_, [](const Worker& worker) { return worker.process < 0; });
  return answers;
}

std::optional<Answer> WorkerPool::receive(Worker& worker) {
  AnswerSize size;
  if (!worker.chunk || !read_all(worker.answers, &size, sizeof size)) return {};
  Answer answer{.chunk = *worker.chunk};
  answer.lines.resize(size.lines);
  answer.failure.resize(size.failure);
  if (!read_all(worker.answers, answer.lines.data(), size.lines) ||
      !read_all(worker.answers, answer.failure.data(), size.failure))
    return {};
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
  const std::string name = fmt::format("the worker process {}", worker.process);
  worker.process = -1;
  if (WIFSIGNALED(status))
    return fmt::format("{} was ended by signal {} ({})", name, WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  return fmt::format("{} ended with status {}", name, WEXITSTATUS(status));
}

}  // namespace hexagait::sweep
