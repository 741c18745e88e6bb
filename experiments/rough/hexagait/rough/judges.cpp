// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/experiments/walk_checks.hpp>
#include <hexagait/rough/tally.hpp>
#include <hexagait/statistics/differences.hpp>

namespace hexagait::experiments {
namespace {

// What is claimed of the free gait, and what is known of it.
struct Claimed {
  double height;  // of the boxes [m]
  double least;   // arrive [%]
  Bound band;     // where that is known not to hold; else kHolds
  Bound real;     // the same of the points by which the plant `real` arrives more often
};
constexpr double kMargin = -3.0;  // those points at least
constexpr double kRounding = 1e-9;
constexpr Bound kHolds{};
constexpr Claimed kClaims[] = {{0.15, 100.0, kHolds, kHolds},
                               {0.20, 99.0, kHolds, kHolds},
                               {0.25, 97.0, {94.0, 96.9}, {-13.0, -3.1}},
                               {0.30, 85.0, kHolds, {-14.0, -3.1}}};
constexpr const char* kWhyFalls =
    "feet roll off edges when the legs beside them have lifted, and odometry's tilt drifts";
constexpr const char* kWhyReal =
    "feet touch down faster where the height is a guess, and are felt late";
constexpr double kVeryRough =
    0.25;  // height from which the free gait is a wave most of the time [m]
constexpr const char* kWhySlower =
    "there it is a wave gait, which is slower and arrives more often";
constexpr const char* kWhyNoLead =
    "it waits for two neighbours instead of for all, which gains no more than the step times of "
    "`experiment lead` allow";

std::string in_cm(double height) { return fmt::format("{:g} cm", 100.0 * height); }

Check known(Check check, const Bound& band, const char* why) {
  return std::isfinite(band.least) ? std::move(check).expected_to_fail(band, why) : check;
}

// In percent of the waiting tripod's speed.
Measured ahead(const RoughPoint& free, const RoughPoint& tripod) {
  const RoughMean lead = free.lead.times(100.0 / tripod.speed.value);
  Measured measured(fmt::format("ahead of the waiting tripod on {}", in_cm(free.height)), "%",
                    lead.value);
  measured.interval = {lead.lower, lead.upper};
  return measured;
}

}  // namespace

Verdict judge_success(std::span<const RoughPoint> points) {
  Verdict verdict{.claim = "The free gait arrives over boxes of half the reach of its legs"};
  for (const Claimed& claimed : kClaims) {
    const RoughPoint* const free = point(points, "ideal", "free", claimed.height);
    if (free == nullptr) continue;
    verdict.checks.push_back(
        known(Check({"walks that arrive over boxes of " + in_cm(claimed.height), free->arrived},
                    at_least(claimed.least)),
              claimed.band, kWhyFalls));
  }
  return verdict;
}

Verdict judge_real(std::span<const RoughPoint> points) {
  Verdict verdict{.claim = "With the plant `real` it arrives as often, but for 3 points"};
  for (const Claimed& claimed : kClaims) {
    const RoughPoint* const ideal = point(points, "ideal", "free", claimed.height);
    const RoughPoint* const real = point(points, "real", "free", claimed.height);
    if (ideal == nullptr || real == nullptr) continue;
    const statistics::Difference d = statistics::difference(real->arrived, ideal->arrived);
    Measured less("arrive more often with `real` on " + in_cm(claimed.height), "points",
                  100.0 * d.value,
                  fmt::format("{} of {}", real->arrived.count, real->arrived.trials));
    less.interval = {100.0 * d.lower, 100.0 * d.upper};
    verdict.checks.push_back(
        known(Check(less, at_least(kMargin - kRounding)), claimed.real, kWhyReal));
  }
  return verdict;
}

Verdict judge_lead(std::span<const RoughPoint> points) {
  Verdict verdict{.claim =
                      "The free gait is no slower than the waiting tripod, by a margin of 1 %, "
                      "and 5 % faster on 15 and 20 cm"};
  for (const RoughPoint& free : points) {
    if (free.plant != "ideal" || free.controller != "free") continue;
    const RoughPoint* const tripod = point(points, "ideal", "tripod", free.height);
    if (tripod == nullptr || std::isnan(free.lead.value)) continue;
    const Measured measured = ahead(free, *tripod);
    const bool very_rough = free.height > kVeryRough - kRounding;
    verdict.checks.push_back(known(Check::of_interval(measured, above(-1.0)),
                                   very_rough ? between(-40.0, 0.0) : kHolds, kWhySlower));
    if (free.height == 0.15 || free.height == 0.20)
      verdict.checks.push_back(
          Check({fmt::format("speed over the waiting tripod's on {}", in_cm(free.height)), "",
                 1.0 + 0.01 * measured.value},
                at_least(1.05))
              .expected_to_fail(between(0.85, 1.05), kWhyNoLead));
  }
  return verdict;
}

}  // namespace hexagait::experiments
