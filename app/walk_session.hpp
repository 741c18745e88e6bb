// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/viewer/session.hpp>

#include "arguments.hpp"

namespace hexagait::app {

using Attend = std::function<void(viewer::Session& session, const heading_control::Heading& heading,
                                  double seconds)>;

/// Walks in real time while somebody attends to it, writes what --record and --html name, and says
/// how it was.
/// @param command       begins messages
/// @param speed_factor  simulated seconds per second
/// @param attend        returns when the walk is to end; it is given the heading until somebody steers,
///                      and --seconds, or infinity
/// @throws InvalidInput  for what is wrong of the arguments
[[nodiscard]] viewer::SessionStatistics walk_in_session(const char* command,
                                                        const WalkArguments& arguments,
                                                        double speed_factor, const Attend& attend);

}  // namespace hexagait::app
