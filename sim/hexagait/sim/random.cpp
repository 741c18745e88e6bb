// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Random123/philox.h>

#include <hexagait/sim/random.hpp>

namespace hexagait {

double random_u01(std::uint64_t seed, RandomStream stream, std::uint32_t trial,
                  std::uint64_t draw) noexcept {
  using Philox = r123::Philox4x32;
  const Philox::ctr_type counter = {{static_cast<std::uint32_t>(draw),
                                     static_cast<std::uint32_t>(draw >> 32), trial,
                                     static_cast<std::uint32_t>(stream)}};
  const Philox::key_type key = {
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const Philox::ctr_type word = Philox{}(counter, key);

  // 53 bits of two words, as a multiple of 2⁻⁵³.
  const std::uint64_t bits = (static_cast<std::uint64_t>(word[0]) << 32) | word[1];
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace hexagait
