// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/figures/csv.hpp>
#include <hexagait/figures/table.hpp>

namespace hexagait::figures {

void write_csv(StagedFiles& files, const std::string& name, const Table& table) {
  Csv csv;
  csv.cells(table.header);
  for (const auto& row : table.rows) csv.cells(row);
  files.write(name, csv.text());
}

}  // namespace hexagait::figures
