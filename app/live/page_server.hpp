// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/viewer/server/host.hpp>
#include <limits>

#include "options/page_options.hpp"

namespace hexagait::app {

/// Is it over by itself? Asked now and then, by another thread.
using Ended = std::function<bool()>;
inline bool never() { return false; }

/// Waits for Ctrl-C, or so long [s], or until it is over.
void wait_for_end(double seconds, const Ended& ended);

/// Serves the page of a walk or a replay, and prints its address, until Ctrl-C, or so long [s], or until it
/// is over.
/// @param command  begins the message if there is no page
/// @param quiet    says nothing but the address
/// @throws InvalidInput  if there is no page, or the address can't be had
void serve_page(const char* command, const PageAddress& address, bool quiet, viewer::Host& host,
                double seconds = std::numeric_limits<double>::infinity(),
                const Ended& ended = never);

}  // namespace hexagait::app
