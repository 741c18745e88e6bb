// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace hexagait {

/// The purpose of a stream of random numbers. Purposes have separate streams, so that every
/// controller meets the same terrain and an additional draw for one purpose does not affect the
/// others.
enum class RandomStream : std::uint32_t {
  terrain = 1,
  posture = 2,
  commands = 3,
  noise = 4,
  test = 5,
  masses = 6,   ///< of links that differ from the model
  sensors = 7,  ///< noise, bounce and losses between plant and controller
  senses = 8,   ///< noise of whiskers, infrared and inclinometer
  turns = 9,    ///< of a robot that navigates
  seeds = 16,   ///< of the trials of a sweep
};

/// A counter-based random number: a pure function of (seed, stream, trial, draw), with no state.
/// Philox4x32-10 (Salmon et al. 2011), key = seed, counter = (draw, draw >> 32, trial, stream).
/// @returns uniform in [0, 1) with 53 random bits
[[nodiscard]] double random_u01(std::uint64_t seed, RandomStream stream, std::uint32_t trial,
                                std::uint64_t draw) noexcept;

/// Successive draws of one stream. Copyable; the copy continues identically.
struct RandomSequence {
  std::uint64_t seed = 0;
  RandomStream stream = RandomStream::test;
  std::uint32_t trial = 0;
  std::uint64_t draw = 0;

  /// Uniform in [0, 1).
  [[nodiscard]] double u01() noexcept { return random_u01(seed, stream, trial, draw++); }

  /// Uniform in [lower, upper).
  [[nodiscard]] double uniform(double lower, double upper) noexcept {
    return lower + (upper - lower) * u01();
  }
};

/// A bell-shaped number of mean 0, never beyond 3.5 standard deviations: the sum of four uniform
/// numbers, less its mean, has the variance 4/12.
/// @param u01  draws the k-th of them, in [0, 1)
template <class U01>
[[nodiscard]] double bell(double deviation, const U01& u01) {
  constexpr double kSqrt3 = 1.7320508075688772;
  double sum = -2.0;
  for (int k = 0; k < 4; ++k) sum += u01(k);
  return deviation * kSqrt3 * sum;
}

}  // namespace hexagait
