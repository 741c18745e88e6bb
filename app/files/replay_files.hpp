// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "files/output_file.hpp"

namespace hexagait::app {

/// The files that --record and --html name, both made of one replay.
class ReplayFiles {
 public:
  /// @param record, html  names of the files; empty: none
  /// @throws InvalidInput  for a name that can't be written, or --html without a page
  ReplayFiles(const std::string& record, const std::string& html);

  [[nodiscard]] bool wanted() const { return record_ || html_; }
  /// Options and their files.
  [[nodiscard]] std::vector<std::pair<const char*, const OutputFile*>> files() const;

  /// Takes the replay. A page has all of it in it, so with --html it is kept in memory; else it
  /// goes to its file as it comes. The file's stream throws unless its exceptions() are changed.
  [[nodiscard]] std::ostream& stream();

  /// Puts the files in their places.
  /// @param problem  why the replay could not be written; empty: it could
  /// @throws InvalidInput  naming the file that could not be written
  void finish(const std::string& problem = "");

 private:
  std::optional<OutputFile> record_, html_;
  std::ofstream file_;
  std::ostringstream kept_;
};

}  // namespace hexagait::app
