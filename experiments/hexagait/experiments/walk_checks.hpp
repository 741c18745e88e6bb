// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/claim.hpp>
#include <hexagait/walk/referee/summary.hpp>
#include <span>

namespace hexagait::experiments {

/// How many of them, as a share with its interval.
template <class Range, class Predicate>
[[nodiscard]] statistics::Proportion share_of(const Range& range, Predicate predicate) {
  int count = 0, all = 0;
  for (const auto& one : range) {
    ++all;
    count += predicate(one) ? 1 : 0;
  }
  return statistics::proportion(count, all);
}

/// A number of each.
template <class Range, class Value>
[[nodiscard]] std::vector<double> each(const Range& range, Value value) {
  std::vector<double> values;
  values.reserve(std::size(range));
  for (const auto& one : range) values.push_back(static_cast<double>(value(one)));
  return values;
}

/// The greatest of a number over some walks: NaN, which no bound contains, if one is NaN or if
/// there are none.
template <class Range, class Value>
[[nodiscard]] double worst(const Range& range, Value value) {
  return statistics::greatest(each(range, value));
}

/// What came of each walk.
template <class Range>
[[nodiscard]] std::vector<walk::Summary> summaries(const Range& walks) {
  std::vector<walk::Summary> all;
  all.reserve(std::size(walks));
  for (const auto& walk : walks) all.push_back(walk.summary);
  return all;
}

/// What no walk may do, whatever else it shows: none of them falls, and no controller stops by
/// itself with a fault.
/// @param summaries  of walks or of actions
/// @param what       they are called
/// @param share      of them that may fall after all [%]
template <class Range>
[[nodiscard]] std::vector<SafetyCheck> no_fall(const Range& summaries,
                                               const std::string& what = "walks",
                                               const Bound& share = exactly(0.0)) {
  using Fault = std::decay_t<decltype(std::begin(summaries)->fault)>;
  return {{{what + " that fell", share_of(summaries, [](const auto& s) { return s.fell; })}, share},
          {{what + " that a fault ended",
            share_of(summaries, [](const auto& s) { return s.fault != Fault::none; })},
           exactly(0.0)}};
}

/// How often a leg was lifted beside one that is off the ground, in the worst walk.
[[nodiscard]] Measured worst_lifts(std::span<const walk::Summary> walks);
/// Share of a walk's time with two neighbours off the ground [%].
[[nodiscard]] std::vector<double> flight_percents(std::span<const walk::Summary> walks);
/// The same of the worst walk.
[[nodiscard]] Measured worst_flight(std::span<const walk::Summary> walks);

/// What no_fall() says; and rule 1, by where the feet truly are. On flat ground with a constant
/// heading it is never broken. Where feet bounce or slide off edges, a foot that the controller takes
/// for support may be off the ground: then no walk breaks it more than so often, or for so long.
[[nodiscard]] std::vector<SafetyCheck> no_fall_and_rule_1(std::span<const walk::Summary> walks,
                                                          double most_flight_percent = 0.0,
                                                          double most_lifts = 0.0);

/// The same over rough ground, with the time of two neighbours off the ground as a mean of the walks: of
/// single walks, and of short ones, it is anything from 0.2 to 10 %.
[[nodiscard]] std::vector<SafetyCheck> no_fall_on_rough_ground(std::span<const walk::Summary> walks,
                                                               double most_flight_percent,
                                                               double most_lifts);

}  // namespace hexagait::experiments
