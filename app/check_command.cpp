// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "action_words.hpp"
#include "commands.hpp"

namespace hexagait::app {

int check_command(const ActionArguments& arguments) {
  const ActionInput input = action_input(arguments);
  const ActionReport report{.input = &input, .ahead = preview(input), .summary = {}};
  if (arguments.json)
    fmt::print("{}\n", check_json(report));
  else if (arguments.quiet)
    fmt::print("{}", findings(report));
  else
    fmt::print("{}{}\n", findings(report), check_verdict(report));
  return has_errors(report.ahead) ? kFailed : kOk;
}

}  // namespace hexagait::app
