// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/lanes.hpp>
#include <hexagait/math/trigonometry.hpp>

namespace hexagait::portable {

struct LaneSinCos {
  Lanes s, c;
};

/// The numbers of sincos(), in both lanes.
struct SinCosTerms {
  Lanes few_turns, two_over_pi, rounder, half_pi_head, half_pi_tail, half, one;
  Lanes sine[8], cosine[8];  ///< of r³, r⁵, … and of r⁴, r⁶, …
};
extern const SinCosTerms kSinCosTerms;  // not constexpr: compilers would pair them up in each use

/// Sines and cosines of two angles [rad], with the bits that sincos() gives for each.
[[nodiscard]] inline LaneSinCos sincos(Lanes x) noexcept {
  const SinCosTerms& terms = kSinCosTerms;
  if (!all(magnitude(x) < terms.few_turns)) {
    const SinCos first = sincos(x[0]), second = sincos(x[1]);
    return {Lanes{first.s, second.s}, Lanes{first.c, second.c}};
  }
  const Lanes shifted = x * terms.two_over_pi + terms.rounder, k = shifted - terms.rounder;
  const Lanes r = (x - k * terms.half_pi_head) - k * terms.half_pi_tail;
  const Lanes z = r * r;
  Lanes sine_tail = terms.sine[7], cosine_tail = terms.cosine[7];
  for (int i = 6; i >= 0; --i) {
    sine_tail = terms.sine[i] + z * sine_tail;
    cosine_tail = terms.cosine[i] + z * cosine_tail;
  }
  const Lanes s = r + r * (z * sine_tail);
  const Lanes c = terms.one - (terms.half * z - z * z * cosine_tail);

  // k = 0: s, c; 1: c, −s; 2: −s, −c; 3: −c, s.
  const LaneBits quarter = reinterpret_cast<LaneBits>(shifted), next = quarter + 1;
  const LaneBits sine = reinterpret_cast<LaneBits>(s), cosine = reinterpret_cast<LaneBits>(c);
  const LaneBits exchange = (sine ^ cosine) & -(quarter & 1);
  return {reinterpret_cast<Lanes>(sine ^ exchange ^ (quarter >> 1 << 63)),
          reinterpret_cast<Lanes>(cosine ^ exchange ^ (next >> 1 << 63))};
}

}  // namespace hexagait::portable
