// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/figures/base64.hpp>
#include <hexagait/viewer/replay/replay_page.hpp>
#include <hexagait/viewer/server/page_files.hpp>

namespace hexagait::viewer {
namespace {

void put(std::string& page, const std::string& place, std::string_view bytes) {
  const std::size_t at = page.find(place);
  if (at != std::string::npos) page.replace(at, place.size(), figures::base64(bytes));
}

}  // namespace

std::string replay_page(std::string_view replay) {
  std::string page(page_alone());
  for (const PageFile& file : page_files()) put(page, fmt::format("@{}@", file.path), file.content);
  put(page, "@REPLAY@", replay);
  return page;
}

}  // namespace hexagait::viewer
