// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <hexagait/text/invalid_input.hpp>

#include "terminal/output.hpp"

namespace hexagait::app {

std::optional<OutputFile> output_file(const char* option, const std::string& name,
                                      const std::vector<std::string>& suffixes) {
  if (name.empty()) return {};
  const std::filesystem::path path(name);
  if (std::ranges::find(suffixes, path.extension().string()) == suffixes.end())
    throw InvalidInput(fmt::format("{} is '{}'; it must be a file that ends in {}", option, name,
                                   fmt::join(suffixes, ", ")));
  try {
    OutputFile result{path, figures::StagedFiles(path.parent_path())};
    result.files.expect(path.filename());
    return result;
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{} is '{}': {}", option, name, error.what()));
  }
}

void write_output(const char* option, const OutputFile& file, const std::function<void()>& write) {
  if (const std::string problem = write_problem(write); !problem.empty())
    refuse_output(option, file, problem);
}

void write_text(const char* option, OutputFile& file, std::string_view text) {
  write_output(option, file, [&] {
    std::ofstream out = file.files.open(file.path.filename());
    out << text;
    out.close();
    file.files.publish();
  });
}

void refuse_output(const char* option, const OutputFile& file, const std::string& problem) {
  throw InvalidInput(
      fmt::format("{} is '{}', which can't be written: {}", option, file.path.string(), problem));
}

}  // namespace hexagait::app
