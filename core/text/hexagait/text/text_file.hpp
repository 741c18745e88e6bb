// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace hexagait {

/// All of a file that is no longer than `max_size` bytes.
/// @param what  the kind of file that is expected, for messages
/// @throws InvalidInput  with the reason if it can't be read or is a directory; if it is longer
[[nodiscard]] std::string read_text(const std::string& path, std::size_t max_size,
                                    std::string_view what = "a YAML file");

}  // namespace hexagait
