// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

namespace hexagait::app {

/// From now on SIGINT and SIGTERM end nothing by themselves but set the flag that is returned.
[[nodiscard]] const std::atomic<bool>& watch_interrupts();

/// The same, with a count of them.
[[nodiscard]] const std::atomic<int>& count_interrupts();

}  // namespace hexagait::app
