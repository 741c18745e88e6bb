// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <hexagait/experiments/row_journal.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <iterator>

namespace hexagait::experiments {
namespace {

// "NUMBER ROW"; false if it is not one.
bool read(const std::string& line, std::uint64_t& number, std::string& row) {
  const char* const end = line.data() + line.size();
  const auto [rest, error] = std::from_chars(line.data(), end, number);
  if (error != std::errc() || rest == end || *rest != ' ') return false;
  row.assign(rest + 1, end);
  return true;
}

}  // namespace

RowJournal::RowJournal(const std::filesystem::path& file, const std::string& key) : path_(file) {
  std::ifstream before(path_);
  std::string text((std::istreambuf_iterator<char>(before)), {});
  text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
  const bool same = text.starts_with(key + "\n");
  for (std::size_t at = same ? key.size() + 1 : text.size(); at < text.size();) {
    const std::size_t end = text.find('\n', at);
    std::uint64_t number = 0;
    std::string row;
    if (read(text.substr(at, end - at), number, row)) rows_[number] = row;
    at = end + 1;
  }
  file_.open(path_, std::ios::trunc);
  file_ << key << '\n';
  for (const auto& [number, row] : rows_) file_ << number << ' ' << row << '\n';
  if (!file_.flush()) throw InvalidInput("can't write '" + path_.string() + "'");
}

void RowJournal::add(std::uint64_t number, const std::string& row) {
  rows_[number] = row;
  file_ << number << ' ' << row << '\n';
  if (!file_.flush()) throw InvalidInput("can't write '" + path_.string() + "'");
}

void RowJournal::remove() {
  file_.close();
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace hexagait::experiments
