// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace hexagait::viewer {

/// A page that plays a replay from disk: HTML with the files of page_files() and the replay in itself, as
/// base64. It asks nobody for anything.
/// @param replay  the bytes of the file; not checked
/// @pre there is a page: page_files() is not empty
[[nodiscard]] std::string replay_page(std::string_view replay);

}  // namespace hexagait::viewer
