// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/viewer/session/session.hpp>
#include <string>

#include "options/arguments.hpp"

namespace hexagait::app {

/// What walks in a session.
struct SessionChoice {
  double speed_factor = 1.0;  ///< simulated seconds per second
  std::string live = {};      ///< command line of a live robot's program; empty: a simulated robot
  double late_limit = recording::Simulation{}.late_limit;  ///< see WalkerParams [s]
  bool stands = false;                                     ///< until somebody steers
};

using Attend = std::function<void(viewer::Session& session, const heading_control::Heading& heading,
                                  double seconds)>;

/// Walks in real time while somebody attends to it, writes what --record and --html name, and says
/// how it was.
/// @param command  begins messages
/// @param attend   returns when the walk is to end; it is given the heading until somebody steers, and
///                 --seconds, or infinity
/// @throws InvalidInput  for what is wrong of the arguments
[[nodiscard]] viewer::SessionStatistics walk_in_session(const char* command,
                                                        const WalkArguments& arguments,
                                                        const SessionChoice& choice,
                                                        const Attend& attend);

/// A live robot that a fault has stopped, other than an emergency stop: its walk has failed.
[[nodiscard]] bool has_failed(const viewer::SessionStatistics& statistics);

}  // namespace hexagait::app
