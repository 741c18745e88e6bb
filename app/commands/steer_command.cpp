// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/parse_number.hpp>

#include "commands/commands.hpp"
#include "live/page_server.hpp"
#include "live/walk_session.hpp"
#include "options/steer_options.hpp"

namespace hexagait::app {
namespace {

double speed(const std::string& text) {
  const auto number = parse_number<double>(text);
  if (number && 0.05 <= *number && *number <= 10.0) return *number;
  throw InvalidInput(fmt::format("--speed is '{}'; it must be from 0.05 to 10", text));
}

}  // namespace

int steer_command(const SteerArguments& arguments) {
  const bool live = !arguments.live.empty();
  if (live && arguments.walk.plant.given())
    throw InvalidInput("--live: a plant and its faults are of a simulated robot; leave them out");
  const auto attend = [&](viewer::Session& session, const auto& /*heading*/, double seconds) {
    // Without a page nobody can take over a robot that a fault has stopped.
    const auto ended = [&, live] {
      const Fault fault = session.statistics().fault;
      return live && (fault == Fault::plant_closed || (arguments.headless && fault != Fault::none));
    };
    if (arguments.headless)
      wait_for_end(seconds, ended);
    else
      serve_page("steer", arguments.address, arguments.walk.quiet, session, seconds, ended);
  };
  const viewer::SessionStatistics statistics =
      walk_in_session("steer", arguments.walk,
                      {.speed_factor = speed(arguments.speed),
                       .live = arguments.live,
                       .late_limit = late_limit(arguments.late_limit),
                       .stands = live && !arguments.headless},
                      attend);
  const bool failed = live ? has_failed(statistics) : arguments.headless && statistics.fell;
  return failed ? kFailed : kOk;
}

}  // namespace hexagait::app
