// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/walk/actions/action_check.hpp>

#include "commands/commands.hpp"
#include "terminal/output.hpp"
#include "words/action_words.hpp"

namespace hexagait::app {

int check_command(const ActionArguments& arguments) {
  const ActionInput input = action_input(arguments);
  const ActionReport report{.input = &input, .ahead = preview(input), .summary = {}};
  print_out(arguments.json
                ? check_json(report) + "\n"
                : findings(report) + (arguments.quiet ? "" : check_verdict(report) + "\n"));
  return walk::has_errors(report.ahead) ? kFailed : kOk;
}

}  // namespace hexagait::app
