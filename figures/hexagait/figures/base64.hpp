// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace hexagait::figures {

/// Bytes as text, for what a page of one file has in it: RFC 4648, with its padding.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace hexagait::figures
