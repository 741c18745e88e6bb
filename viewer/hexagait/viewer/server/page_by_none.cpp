// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/viewer/server/page_files.hpp>

namespace hexagait::viewer {

std::span<const PageFile> page_files() { return {}; }

std::string_view page_alone() { return {}; }

}  // namespace hexagait::viewer
