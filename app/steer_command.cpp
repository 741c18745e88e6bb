// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/parse_number.hpp>

#include "commands.hpp"
#include "page_server.hpp"
#include "steer_options.hpp"
#include "walk_session.hpp"

namespace hexagait::app {
namespace {

double speed(const std::string& text) {
  const auto number = parse_number<double>(text);
  if (number && 0.05 <= *number && *number <= 10.0) return *number;
  throw InvalidInput(fmt::format("--speed is '{}'; it must be from 0.05 to 10", text));
}

}  // namespace

int steer_command(const SteerArguments& arguments) {
  const auto attend = [&](viewer::Session& session, const auto& /*heading*/, double seconds) {
    if (arguments.headless)
      wait_for_end(seconds);
    else
      serve_page("steer", arguments.address, arguments.walk.quiet, session, seconds);
  };
  const viewer::SessionStatistics statistics =
      walk_in_session("steer", arguments.walk, speed(arguments.speed), attend);
  return arguments.headless && statistics.fell ? kFailed : kOk;
}

}  // namespace hexagait::app
