// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hexagait {

/// Limits of a URDF, which bound the memory and the depth of calls of the XML parser, and its time: each attribute of an
/// element is compared with all before it.
inline constexpr std::size_t kMaxUrdfText = 10'000'000;  ///< [bytes]
inline constexpr int kMaxUrdfDepth = 64;                 ///< of nested elements
inline constexpr std::size_t kMaxUrdfElements = 100'000;
inline constexpr std::size_t kMaxUrdfAttributes = 100;  ///< of an element
inline constexpr std::size_t kMaxUrdfLinks = 1'000;

/// What of an XML text exceeds the limits, with its line; empty: nothing. One pass over the text;
/// whether it is XML is left to the parser.
[[nodiscard]] std::string too_large(std::string_view xml);

}  // namespace hexagait
