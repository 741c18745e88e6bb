// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

namespace hexagait {

/// FNV-1a hash of no bytes, 64 bits.
inline constexpr std::uint64_t kFnv1aBasis = 14695981039346656037ULL;

/// FNV-1a hash of a number's bytes, the lowest first.
/// @param hash  of the preceding bytes
template <std::unsigned_integral Word>
[[nodiscard]] constexpr std::uint64_t fnv1a(Word word, std::uint64_t hash) noexcept {
  for (std::size_t byte = 0; byte < sizeof word; ++byte)
    hash = (hash ^ (static_cast<std::uint64_t>(word) >> (8 * byte) & 0xffU)) * 1099511628211ULL;
  return hash;
}

/// FNV-1a hash of a text.
/// @param hash  of the preceding bytes
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view text,
                                            std::uint64_t hash = kFnv1aBasis) noexcept {
  for (const char letter : text) hash = fnv1a(static_cast<unsigned char>(letter), hash);
  return hash;
}

}  // namespace hexagait
