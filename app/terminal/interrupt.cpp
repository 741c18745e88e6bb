// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/interrupt.hpp"

#include <csignal>

namespace hexagait::app {
namespace {

std::atomic<bool> interrupted = false;
std::atomic<int> interrupts = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "set by a signal handler");

void interrupt(int /*signal*/) {
  interrupted = true;
  ++interrupts;
}

}  // namespace

const std::atomic<bool>& watch_interrupts() {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  return interrupted;
}

const std::atomic<int>& count_interrupts() {
  (void)watch_interrupts();
  return interrupts;
}

}  // namespace hexagait::app
