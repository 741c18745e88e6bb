// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/usage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>

namespace hexagait::app {
namespace {

// Of a command, with their dashes.
std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

}  // namespace

void group(CLI::App& command, const char* heading) {
  for (CLI::Option* option : command.get_options())
    if (option->get_group() == "Options" && !option->check_lname("help")) option->group(heading);
}

void refuse_empty_values(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({}))
    for (CLI::Option* option : command->get_options())
      if (option->get_expected_min() > 0)
        option->check(
            [](const std::string& value) {
              return std::string(value.empty() ? "is empty; it needs a value" : "");
            },
            "");
}

void check_words(const CLI::App& app, std::span<const char* const> words) {
  const CLI::App* command = &app;
  std::string title = "hexagait";
  if (!words.empty() && words.front()[0] != '-') {
    const std::string name = words.front();
    std::vector<std::string> commands;
    for (const CLI::App* known : app.get_subcommands({})) {
      commands.push_back(known->get_name());
      if (known->get_name() == name) command = known;
    }
    if (command == &app)
      throw InvalidInput(fmt::format("unknown command '{}'{}; hexagait --help lists the commands",
                                     name, did_you_mean(name, commands)));
    title += " " + name;
    words = words.subspan(1);
  }
  const std::vector<std::string> names = option_names(*command);
  for (const std::string word : words) {
    if (word == "--") return;
    const std::string option = word.substr(0, word.find('='));
    if (!option.starts_with("--") || std::ranges::find(names, option) != names.end()) continue;
    throw InvalidInput(fmt::format("unknown option '{}' of {}{}; {} --help lists its options",
                                   option, title, did_you_mean(option, names), title));
  }
}

}  // namespace hexagait::app
