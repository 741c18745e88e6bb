// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/replay/replay_file.hpp>
#include <hexagait/viewer/replay/replay_host.hpp>
#include <hexagait/viewer/replay/replay_page.hpp>
#include <hexagait/viewer/server/page_files.hpp>
#include <iterator>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "files/output_file.hpp"
#include "live/page_server.hpp"
#include "options/replay_options.hpp"
#include "terminal/output.hpp"

namespace hexagait::app {
namespace {

std::string content(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const bool is_directory = std::filesystem::is_directory(file);
  if (!stream || is_directory)
    throw InvalidInput(fmt::format("replay: '{}' can't be read: {}", file,
                                   std::strerror(is_directory ? EISDIR : errno)));
  return {std::istreambuf_iterator<char>(stream), {}};
}

viewer::ReplayFacts facts_of(const std::string& file, const std::string& replay) {
  try {
    return viewer::check_replay(replay);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("replay: '{}' {}", file, error.what()));
  }
}

std::string in_print(const viewer::ReplayFacts& facts, std::size_t bytes, bool json) {
  if (json)
    return nlohmann::ordered_json{{"schema", 1},
                                  {"robot", facts.robot},
                                  {"terrain", facts.terrain},
                                  {"seed", facts.seed},
                                  {"seconds", facts.seconds},
                                  {"frames", facts.frames},
                                  {"scenes", facts.scenes},
                                  {"bytes", bytes}}
               .dump(2) +
           "\n";
  return fmt::format("{} on {}, {:.1f} s, {} frames, {:.0f} kB\n", facts.robot, facts.terrain,
                     facts.seconds, facts.frames, 1e-3 * static_cast<double>(bytes));
}

}  // namespace

int replay_command(const ReplayArguments& arguments) {
  std::optional<OutputFile> html = output_file("--html", arguments.html, {".html"});
  if (html && viewer::page_files().empty())
    throw InvalidInput(fmt::format("--html: {}", viewer::kNoPage));
  std::string replay = content(arguments.file);
  const viewer::ReplayFacts facts = facts_of(arguments.file, replay);
  if (html) write_text("--html", *html, viewer::replay_page(replay));
  if (arguments.json || (html && !arguments.quiet))
    print_out(in_print(facts, replay.size(), arguments.json));
  if (html || arguments.json) return kOk;
  viewer::ReplayHost host(std::move(replay));
  serve_page("replay", arguments.address, arguments.quiet, host);
  return kOk;
}

}  // namespace hexagait::app
