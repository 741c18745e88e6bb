// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <concepts>
#include <hexagait/experiments/manifest.hpp>

namespace hexagait::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const double kNaN = std::nan("");
const double kInf = std::numeric_limits<double>::infinity();

Check speed(double value, const Bound& bound) { return {{"speed", "m/s", value}, bound}; }

TEST(Bound, ContainsItsLimitsUnlessItIsOpen) {
  EXPECT_TRUE(at_most(3.0).contains(3.0));
  EXPECT_FALSE(below(3.0).contains(3.0));
  EXPECT_TRUE(at_least(3.0).contains(3.0));
  EXPECT_FALSE(above(3.0).contains(3.0));
  EXPECT_TRUE(between(1.0, 3.0).contains(1.0));
  EXPECT_TRUE(exactly(3.0).contains(3.0));
  EXPECT_FALSE(exactly(3.0).contains(std::nextafter(3.0, 4.0)));
  EXPECT_EQ(to_string(at_most(0.5), "mm"), "at most 0.5 mm");
  EXPECT_EQ(to_string(above(0.0)), "more than 0");
  EXPECT_EQ(to_string(between(3.0, 7.0), "cm"), "3 to 7 cm");
}

TEST(Bound, ContainsNothingThatWasNotMeasured) {
  for (const Bound& bound : {Bound{}, at_most(kInf), at_least(-kInf), between(-kInf, kInf)})
    EXPECT_FALSE(bound.contains(kNaN));
}

TEST(Check, HoldsWhereItsValueIsWithinTheBound) {
  EXPECT_EQ(speed(0.2, at_least(0.2)).finding(), Finding::holds);
  EXPECT_EQ(speed(0.19, at_least(0.2)).finding(), Finding::fails);
  EXPECT_EQ(speed(kNaN, at_least(0.2)).finding(), Finding::fails);
}

// Ahead by 1 ± 0.5 is superior; by 1 ± 1.5 it is neither superior nor inferior by a margin of 0.2.
TEST(Check, OfAnIntervalHoldsOnlyIfAllOfItIsWithinTheBound) {
  const auto ahead = [](double half_width, const Bound& bound) {
    return Check::of_interval({"ahead", "", statistics::Estimate{9, 1.0, 1.0, half_width}}, bound)
        .finding();
  };
  EXPECT_EQ(ahead(0.5, above(0.0)), Finding::holds);
  EXPECT_EQ(ahead(1.5, above(0.0)), Finding::fails);
  EXPECT_EQ(ahead(1.5, above(-0.2)), Finding::fails) << "a wide interval proves nothing";
  EXPECT_EQ(ahead(1.1, above(-0.2)), Finding::holds);
  EXPECT_EQ(ahead(1.5, below(0.0)), Finding::fails);
  EXPECT_EQ(ahead(kInf, Bound{}), Finding::holds);
  EXPECT_EQ(Check::of_interval({"ahead", "", 1.0}, above(0.0)).finding(), Finding::fails)
      << "it has no interval";
}

TEST(Check, ThatIsExpectedToFailIsAccountedForInItsBandAlone) {
  const auto finding = [](double value) {
    return speed(value, at_least(0.2)).expected_to_fail(between(0.10, 0.15), "it limps").finding();
  };
  EXPECT_EQ(finding(0.12), Finding::fails_as_expected);
  EXPECT_EQ(finding(0.30), Finding::holds_unexpectedly);
  EXPECT_EQ(finding(0.18), Finding::fails_otherwise);
  EXPECT_EQ(finding(0.05), Finding::fails_otherwise);
  EXPECT_EQ(finding(kNaN), Finding::fails_otherwise);
}

template <class T>
concept CanBeExcused = requires(T check) {
  std::move(check).expected_to_fail(Bound{}, "");
};
static_assert(CanBeExcused<Check>);
static_assert(!CanBeExcused<SafetyCheck>, "nothing excuses a fall");
static_assert(!std::constructible_from<SafetyCheck, Check>, "not even by a detour");

TEST(Verdict, HoldsIfAllItsChecksDo) {
  Verdict verdict{.claim = "It goes",
                  .safety = {{{"falls", "", 0.0}, exactly(0.0)}},
                  .checks = {speed(0.3, at_least(0.2)), speed(0.3, at_most(0.4))}};
  EXPECT_TRUE(verdict.holds());
  EXPECT_EQ(verdict.word(), "holds");
  verdict.checks.push_back(speed(0.3, at_most(0.2)));
  EXPECT_FALSE(verdict.holds());
  EXPECT_FALSE(verdict.is_accounted_for());
  EXPECT_EQ(verdict.word(), "FAILS");
}

TEST(Verdict, WithoutAnyCheckHoldsNothing) {
  EXPECT_FALSE((Verdict{.claim = "It goes"}.holds()));
  EXPECT_FALSE((Verdict{.claim = "It goes"}.is_accounted_for()));
}

TEST(Verdict, ThatFailsAsExpectedDoesNotHoldAndIsAccountedFor) {
  Verdict verdict{
      .claim = "It goes",
      .checks = {speed(0.12, at_least(0.2)).expected_to_fail(between(0.10, 0.15), "it limps")}};
  EXPECT_FALSE(verdict.holds());
  EXPECT_TRUE(verdict.is_accounted_for());
  EXPECT_EQ(verdict.word(), "as expected, does not hold");
  EXPECT_EQ(verdict.lines().front(),
            "speed: 0.12 m/s; claimed: at least 0.2 m/s; expected: 0.1 to 0.15 m/s, because it "
            "limps");
  verdict.safety = {{{"falls", "", 1.0}, exactly(0.0)}};
  EXPECT_FALSE(verdict.is_accounted_for()) << "a fall is not what was expected";
}

TEST(Verdict, ThatHoldsAgainstExpectationFails) {
  const Verdict verdict{
      .claim = "It goes",
      .checks = {speed(0.3, at_least(0.2)).expected_to_fail(between(0.10, 0.15), "it limps")}};
  EXPECT_FALSE(verdict.is_accounted_for());
  EXPECT_EQ(verdict.word(), "FAILS");
  EXPECT_THAT(verdict.lines().front(), HasSubstr("HOLDS, but was expected to be 0.1 to 0.15 m/s"));
}

TEST(Verdict, OfAShortFormIsNotJudgedButForSafety) {
  const Verdict full{.claim = "It goes",
                     .safety = {{{"falls", "", 0.0}, exactly(0.0)}},
                     .checks = {speed(0.1, at_least(0.2))}};
  EXPECT_EQ(judged_in_full_only(full, false).word(), "FAILS");
  Verdict shorter = judged_in_full_only(full, true);
  EXPECT_EQ(shorter.word(), "not judged");
  EXPECT_FALSE(shorter.holds());
  EXPECT_TRUE(shorter.is_accounted_for());
  EXPECT_THAT(shorter.lines().back(), HasSubstr("not judged: it needs the full length"));
  shorter.safety = {{{"falls", "", 1.0}, exactly(0.0)}};
  EXPECT_FALSE(shorter.is_accounted_for());
}

TEST(Verdict, OfAnotherPlantTellsWhatWasMeasuredAndJudgesNothing) {
  const Verdict told = only_told({.claim = "It goes",
                                  .safety = {{{"falls", "", 1.0}, exactly(0.0)}},
                                  .checks = {speed(0.1, at_least(0.2))},
                                  .remark = "it limps"},
                                 "it is a claim about the ideal plant");
  EXPECT_EQ(told.word(), "not judged");
  EXPECT_FALSE(told.holds());
  EXPECT_TRUE(told.is_accounted_for());
  EXPECT_THAT(told.lines().front(), HasSubstr("it is a claim about the ideal plant"));
  EXPECT_THAT(told.lines().back(),
              AllOf(HasSubstr("falls: 1"), HasSubstr("0.1"), HasSubstr("it limps")));
}

TEST(Measured, SaysHowWellAProportionIsKnown) {
  EXPECT_EQ(to_string(Measured("all arrive", statistics::proportion(20, 20))),
            "all arrive: 100 % (20 of 20; 95 %: 83.89 to 100 %)");
  EXPECT_EQ(to_string(Measured("speed", "m/s", kNaN)), "speed: not measured");
}

// Only a short form, or another plant, may leave a claim unjudged, and an experiment without claims
// shows nothing.
TEST(Manifest, IsAccountedForIfEachOfItsClaimsIs) {
  Manifest manifest;
  EXPECT_FALSE(manifest.is_accounted_for());
  manifest.outcome.verdicts = {{.claim = "It goes", .checks = {speed(0.3, at_least(0.2))}}};
  EXPECT_TRUE(manifest.is_accounted_for());
  manifest.outcome.verdicts.front().not_judged = "some reason";
  EXPECT_FALSE(manifest.is_accounted_for());
  manifest.short_form = true;
  EXPECT_TRUE(manifest.is_accounted_for());
  manifest.short_form = false;
  manifest.plant = recording::parse_plant("real");
  EXPECT_TRUE(manifest.is_accounted_for());
}

TEST(Manifest, HasEachValueWithItsBoundAndItsBand) {
  Manifest manifest{.experiment = "fig0", .title = "", .outcome = {}, .outputs = {}};
  manifest.outcome.verdicts = {
      {.claim = "It goes",
       .checks = {speed(0.12, at_least(0.2)).expected_to_fail(between(0.10, 0.15), "it limps")}}};
  EXPECT_THAT(
      to_json(manifest),
      AllOf(HasSubstr("\"holds\": false"), HasSubstr("\"as_expected\": true"),
            HasSubstr("\"value\": 0.12"), HasSubstr("\"least\": 0.2"), HasSubstr("\"most\": 0.15"),
            HasSubstr("\"finding\": \"fails_as_expected\""), HasSubstr("it limps")));
}

}  // namespace
}  // namespace hexagait::experiments
