// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <hexagait/statistics/statistics.hpp>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexagait::experiments {

/// Limits of a number. NaN is within none.
struct Bound {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool open = false;  ///< the limits themselves are not within

  [[nodiscard]] bool contains(double value) const {
    return open ? least < value && value < most : least <= value && value <= most;
  }
};
[[nodiscard]] inline Bound at_most(double most) { return {.most = most}; }
[[nodiscard]] inline Bound at_least(double least) { return {.least = least}; }
[[nodiscard]] inline Bound below(double limit) { return {.most = limit, .open = true}; }
[[nodiscard]] inline Bound above(double limit) { return {.least = limit, .open = true}; }
[[nodiscard]] inline Bound between(double least, double most) { return {least, most}; }
[[nodiscard]] inline Bound exactly(double value) { return {value, value}; }

/// "at most 0.5 mm", "more than 0", "between 3 and 7 cm", "0".
[[nodiscard]] std::string to_string(const Bound& bound, const std::string& unit = "");

/// A number that was measured, in the unit in which it is reported.
struct Measured {
  struct Interval {
    double lower = 0.0, upper = 0.0;
  };
  std::string name;  ///< "distance from the path, mean"
  std::string unit;  ///< "cm"; empty: a count or a ratio
  double value = std::numeric_limits<double>::quiet_NaN();
  std::optional<Interval> interval = {};  ///< of 95 % confidence, if it is an estimate
  std::string detail = {};                ///< "20 of 20", "on profile:12", …

  Measured(std::string name, std::string unit, double value, std::string detail = {});
  /// A count; of a truth 0 or 1.
  Measured(std::string name_, std::string unit_, std::integral auto count, std::string detail_ = {})
      : Measured(std::move(name_), std::move(unit_), static_cast<double>(count),
                 std::move(detail_)) {}
  Measured(std::string name, std::string unit, const statistics::Estimate& estimate,
           std::string detail = {});
  /// In percent; the detail is "20 of 20".
  Measured(std::string name, const statistics::Proportion& proportion);
};

/// "distance from the path, mean: 0.42 cm", "all arrive: 100 % (20 of 20; 95 %: 83.9 to 100 %)".
[[nodiscard]] std::string to_string(const Measured& measured);

enum class Finding {
  holds,
  fails,
  fails_as_expected,   ///< it was declared to fail, and its value is in the band declared for it
  holds_unexpectedly,  ///< it was declared to fail
  fails_otherwise,     ///< it was declared to fail, and its value is outside of the band
};

/// A number and its bound. The number is the value; or, of_interval(), each value that it may have
/// with 95 % confidence. So
///
///     of_interval({"ahead", "cm/s", a − b}, above(0.0))        superiority
///     of_interval({"ahead", "cm/s", a − b}, above(-margin))    non-inferiority, with that margin
///
/// A check that is known to fail says so, by how much, and why: then it is accounted for if it
/// fails by as much, and not if it holds or fails by more.
class Check {
 public:
  Check(Measured measured, Bound bound) : measured_(std::move(measured)), bound_(bound) {}
  [[nodiscard]] static Check of_interval(Measured measured, Bound bound);

  /// @param band    where the value is expected, in its unit
  /// @param reason  one clause, no full stop
  [[nodiscard]] Check expected_to_fail(Bound band, std::string reason) &&;

  [[nodiscard]] Finding finding() const;
  [[nodiscard]] bool is_accounted_for() const {
    return finding() == Finding::holds || finding() == Finding::fails_as_expected;
  }
  [[nodiscard]] const Measured& measured() const { return measured_; }
  [[nodiscard]] const Bound& bound() const { return bound_; }
  [[nodiscard]] const std::optional<Bound>& band() const { return band_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  Measured measured_;
  Bound bound_;
  bool by_interval_ = false;
  std::optional<Bound> band_;
  std::string reason_;
};

/// A check of what must never happen: falls, faults, neighbours in the air together. Nothing excuses
/// it: it has no expected_to_fail(), and it is judged in short forms too.
class SafetyCheck {
 public:
  SafetyCheck(Measured measured, Bound bound) : check_(std::move(measured), bound) {}
  [[nodiscard]] const Check& check() const { return check_; }

 private:
  Check check_;
};

/// A claim of a paper, or of ours, tested: it holds if all its checks do.
struct Verdict {
  std::string claim;
  std::vector<SafetyCheck> safety = {};
  std::vector<Check> checks = {};
  std::string remark = {};      ///< what else was seen; decides nothing
  std::string not_judged = {};  ///< why the checks (not safety) are not judged

  [[nodiscard]] bool holds() const;
  /// It holds, or fails as it was declared to.
  [[nodiscard]] bool is_accounted_for() const;

  /// "holds", "FAILS", "as expected, does not hold", "not judged".
  [[nodiscard]] std::string word() const;
  /// A line per check, each measured value with its bound, and what is wrong with it.
  [[nodiscard]] std::vector<std::string> lines() const;
};

/// The claims, of which a short form can judge nothing but safety.
[[nodiscard]] Verdict judged_in_full_only(Verdict verdict, bool short_form);
[[nodiscard]] std::vector<Verdict> judged_in_full_only(std::vector<Verdict> verdicts,
                                                       bool short_form);

/// A verdict on a claim that was not made for what was walked, such as another plant: nothing is
/// judged, not even safety, and what was measured becomes a remark.
/// @param why  one clause, no full stop
[[nodiscard]] Verdict only_told(const Verdict& verdict, std::string why);

}  // namespace hexagait::experiments
