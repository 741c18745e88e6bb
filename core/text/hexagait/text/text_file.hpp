// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hexagait {

/// All of a file that is no longer than `max_size` bytes.
/// @throws InvalidInput  if it can't be read, or is longer
[[nodiscard]] std::string read_text(const std::string& path, std::size_t max_size);

}  // namespace hexagait
