// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/text_file.hpp>

namespace hexagait {

std::string read_text(const std::string& path, std::size_t max_size, std::string_view what) {
  const auto refuse = [&](const std::string& reason) {
    throw InvalidInput(path + ": " + reason + "; " + std::string(what) + " is expected");
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse("is a directory");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file.is_open()) refuse(std::string("can't be read: ") + std::strerror(errno));

  std::string text(max_size + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) refuse("can't be read");
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > max_size)
    throw InvalidInput(path + ": has more than " + std::to_string(max_size) +
                       " bytes; so many are read");
  return text;
}

}  // namespace hexagait
