// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/staged_files.hpp>
#include <string>
#include <vector>

namespace hexagait::figures {

/// Rows of text under a header, all as long as it: for a .csv file and for the page.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Quoted as Csv says.
void write_csv(StagedFiles& files, const std::string& name, const Table& table);

}  // namespace hexagait::figures
