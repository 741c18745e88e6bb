// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::app {

/// Figures that one command measures.
struct ResultsGroup {
  std::string title, command;
  std::vector<experiments::Verdict> verdicts;
  bool short_form = false;
};

/// The page of results, in Markdown: a section for each group, which says when and with what it was
/// measured, so that groups can be measured one by one.
class ResultsPage {
 public:
  ResultsPage() = default;
  /// The page that was written as this text.
  /// @throws InvalidInput  if it is not such a page
  explicit ResultsPage(std::string_view text);

  /// Adds the section of a group, or replaces it; as measured now, by this program.
  void set(const ResultsGroup& group);

  /// @param titles  of all groups, in the order of the page; sections of others are left out
  [[nodiscard]] std::string text(const std::vector<std::string>& titles) const;

 private:
  struct Section {
    std::string title, text;
  };
  std::vector<Section> sections_;
};

}  // namespace hexagait::app
