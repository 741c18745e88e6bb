// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/text_file.hpp>

namespace hexagait {

std::string read_text(const std::string& path, std::size_t max_size) {
  std::ifstream file(path, std::ios::binary);
  std::string text(max_size + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  // A folder opens, but can't be read.
  if (!file.is_open() || file.bad())
    throw InvalidInput(path + ": can't be read; a YAML file is expected");
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > max_size)
    throw InvalidInput(path + ": has more than " + std::to_string(max_size) +
                       " bytes; so many are read");
  return text;
}

}  // namespace hexagait
