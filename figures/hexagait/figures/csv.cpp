// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/figures/csv.hpp>

namespace hexagait::figures {
namespace {

void append(std::string& text, const Csv::Row& row) {
  for (const std::string& cell : row) {
    if (&cell != &row.front()) text += ',';
    const bool plain = cell.find_first_of(",\"\n\r") == std::string::npos;
    if (!plain) text += '"';
    for (const char letter : cell) text.append(letter == '"' ? 2 : 1, letter);
    if (!plain) text += '"';
  }
  text += '\n';
}

}  // namespace

Csv::Csv(std::string_view header) {
  for (std::size_t begin = 0; begin <= header.size();) {
    const std::size_t end = std::min(header.find(',', begin), header.size());
    header_.emplace_back(header.substr(begin, end - begin));
    begin = end + 1;
  }
}

std::string Csv::text() const {
  std::string text;
  if (!header_.empty()) append(text, header_);
  for (const Row& row : rows_) append(text, row);
  return text;
}

void Csv::add(double value) { add(std::isnan(value) ? "" : fmt::format("{:.9g}", value)); }

void write_tables(StagedFiles& files, const std::string& stem,
                  std::initializer_list<std::pair<std::string_view, const Csv&>> tables) {
  for (const auto& [name, csv] : tables)
    files.write(fmt::format("{}-{}.csv", stem, name), csv.text());
}

}  // namespace hexagait::figures
