// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <hexagait/experiments/claim.hpp>

namespace hexagait::experiments {
namespace {

std::string number(double value) {
  return fmt::format("{:.4g}", value == 0.0 ? 0.0 : value);  // no "-0"
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? number(value) : number(value) + ' ' + unit;
}

std::string line(const Check& check) {
  const std::string& unit = check.measured().unit;
  const Finding finding = check.finding();
  const std::string text =
      to_string(check.measured()) + "; claimed: " + to_string(check.bound(), unit);
  if (!check.band()) return text + (finding == Finding::fails ? ": FAILS" : "");
  const char* const found = finding == Finding::fails_as_expected ? "expected:"
                            : finding == Finding::holds_unexpectedly
                                ? "HOLDS, but was expected to be"
                                : "FAILS, and was expected to be";
  return fmt::format("{}; {} {}, because {}", text, found, to_string(*check.band(), unit),
                     check.reason());
}

}  // namespace

std::string to_string(const Bound& bound, const std::string& unit) {
  if (bound.least == bound.most) return with_unit(bound.least, unit);
  if (!std::isfinite(bound.least))
    return (bound.open ? "less than " : "at most ") + with_unit(bound.most, unit);
  if (!std::isfinite(bound.most))
    return (bound.open ? "more than " : "at least ") + with_unit(bound.least, unit);
  return fmt::format("{} to {}", number(bound.least), with_unit(bound.most, unit));
}

Measured::Measured(std::string name_, std::string unit_, double value_, std::string detail_)
    : name(std::move(name_)), unit(std::move(unit_)), value(value_), detail(std::move(detail_)) {}

Measured::Measured(std::string name_, std::string unit_, const statistics::Estimate& estimate,
                   std::string detail_)
    : Measured(std::move(name_), std::move(unit_), estimate.mean, std::move(detail_)) {
  interval = {estimate.lower(), estimate.upper()};
}

Measured::Measured(std::string name_, const statistics::Proportion& proportion)
    : Measured(std::move(name_), "%", 100.0 * proportion.share(),
               fmt::format("{} of {}", proportion.count, proportion.trials)) {
  interval = {100.0 * proportion.lower, 100.0 * proportion.upper};
}

std::string to_string(const Measured& m) {
  std::string more = m.detail;
  if (m.interval)
    more += fmt::format("{}95 %: {} to {}", more.empty() ? "" : "; ", number(m.interval->lower),
                        with_unit(m.interval->upper, m.unit));
  const std::string value = std::isnan(m.value) ? "not measured" : with_unit(m.value, m.unit);
  return fmt::format("{}: {}{}", m.name, value, more.empty() ? "" : " (" + more + ")");
}

Check Check::of_interval(Measured measured, Bound bound) {
  Check check(std::move(measured), bound);
  check.by_interval_ = true;
  return check;
}

Check Check::expected_to_fail(Bound band, std::string reason) && {
  band_ = band;
  reason_ = std::move(reason);
  return std::move(*this);
}

Finding Check::finding() const {
  // A check by interval without an interval can't hold.
  const bool holds = !by_interval_
                         ? bound_.contains(measured_.value)
                         : measured_.interval && bound_.contains(measured_.interval->lower) &&
                               bound_.contains(measured_.interval->upper);
  if (!band_) return holds ? Finding::holds : Finding::fails;
  if (holds) return Finding::holds_unexpectedly;
  return band_->contains(measured_.value) ? Finding::fails_as_expected : Finding::fails_otherwise;
}

bool Verdict::holds() const {
  return not_judged.empty() && !(safety.empty() && checks.empty()) &&
         std::ranges::all_of(
             safety, [](const SafetyCheck& c) { return c.check().finding() == Finding::holds; }) &&
         std::ranges::all_of(checks, [](const Check& c) { return c.finding() == Finding::holds; });
}

bool Verdict::is_accounted_for() const {
  const bool judges = !(safety.empty() && checks.empty()) || !not_judged.empty();
  return judges &&
         std::ranges::all_of(safety,
                             [](const SafetyCheck& c) { return c.check().is_accounted_for(); }) &&
         (!not_judged.empty() || std::ranges::all_of(checks, &Check::is_accounted_for));
}

std::string Verdict::word() const {
  if (!is_accounted_for()) return "FAILS";
  if (!not_judged.empty()) return "not judged";
  return holds() ? "holds" : "as expected, does not hold";
}

std::vector<std::string> Verdict::lines() const {
  std::vector<std::string> all;
  for (const SafetyCheck& safe : safety) all.push_back(line(safe.check()));
  if (not_judged.empty())
    for (const Check& check : checks) all.push_back(line(check));
  else
    all.push_back("not judged: " + not_judged);
  if (!remark.empty()) all.push_back(remark);
  return all;
}

Verdict judged_in_full_only(Verdict verdict, bool short_form) {
  if (short_form) verdict.not_judged = "it needs the full length";
  return verdict;
}

std::vector<Verdict> judged_in_full_only(std::vector<Verdict> verdicts, bool short_form) {
  for (Verdict& verdict : verdicts) verdict = judged_in_full_only(std::move(verdict), short_form);
  return verdicts;
}

Verdict only_told(const Verdict& verdict, std::string why) {
  std::vector<std::string> told;
  for (const SafetyCheck& safe : verdict.safety) told.push_back(to_string(safe.check().measured()));
  for (const Check& check : verdict.checks) told.push_back(to_string(check.measured()));
  if (!verdict.remark.empty()) told.push_back(verdict.remark);
  return {.claim = verdict.claim,
          .remark = fmt::format("{}", fmt::join(told, "; ")),
          .not_judged = std::move(why)};
}

}  // namespace hexagait::experiments
