// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

namespace hexagait::viewer {

/// A file of the page, as the build has put it into the library.
struct PageFile {
  std::string_view path;     ///< as "/app.js"
  std::string_view type;     ///< as "text/javascript"
  std::string_view content;  ///< compressed by gzip
};

/// All of them; none if the library was built without Node.
[[nodiscard]] std::span<const PageFile> page_files();

/// A page that has all of these, and a replay, in itself: HTML with a place "@PATH@" for each file it
/// takes and "@REPLAY@" for the replay, all as base64. Empty if there are none.
[[nodiscard]] std::string_view page_alone();

/// What to do for a page, if there is none.
inline constexpr std::string_view kNoPage =
    "the page was not built: that needs Node.js and npm (Debian: apt-get install nodejs npm), and "
    "then to configure and build hexagait again";

}  // namespace hexagait::viewer
