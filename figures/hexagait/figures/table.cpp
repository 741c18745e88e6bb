// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/figures/table.hpp>
#include <ostream>

namespace hexagait::figures {
namespace {

void write_row(std::ostream& out, const std::vector<std::string>& row) {
  for (std::size_t k = 0; k < row.size(); ++k) {
    const bool has_comma = row[k].find(',') != std::string::npos;
    out << (k > 0 ? "," : "") << (has_comma ? "\"" + row[k] + "\"" : row[k]);
  }
  out << '\n';
}

}  // namespace

void write_csv(StagedFiles& files, const std::string& name, const Table& table) {
  std::ofstream out = files.create(name);
  write_row(out, table.header);
  for (const auto& row : table.rows) write_row(out, row);
}

}  // namespace hexagait::figures
