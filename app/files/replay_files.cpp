// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/replay_files.hpp"

#include <fmt/format.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/replay/replay_page.hpp>
#include <hexagait/viewer/server/page_files.hpp>

namespace hexagait::app {

ReplayFiles::ReplayFiles(const std::string& record, const std::string& html)
    : record_(output_file("--record", record, {".replay"})),
      html_(output_file("--html", html, {".html"})) {
  if (html_ && viewer::page_files().empty())
    throw InvalidInput(fmt::format("--html: {}", viewer::kNoPage));
  if (record_ && !html_) file_ = record_->files.open(record_->path.filename());
}

std::vector<std::pair<const char*, const OutputFile*>> ReplayFiles::files() const {
  std::vector<std::pair<const char*, const OutputFile*>> all;
  if (record_) all.emplace_back("--record", &*record_);
  if (html_) all.emplace_back("--html", &*html_);
  return all;
}

std::ostream& ReplayFiles::stream() { return html_ ? static_cast<std::ostream&>(kept_) : file_; }

void ReplayFiles::finish(const std::string& problem) {
  if (!problem.empty()) refuse_output("--record", *record_, problem);
  if (html_) write_text("--html", *html_, viewer::replay_page(kept_.view()));
  if (html_ && record_) write_text("--record", *record_, kept_.view());
  if (html_ || !record_) return;
  write_output("--record", *record_, [&] {
    file_.close();
    if (!file_) refuse_output("--record", *record_, "write error");
    record_->files.publish();
  });
}

}  // namespace hexagait::app
