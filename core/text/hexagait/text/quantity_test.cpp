// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/text/quantity.hpp>
#include <hexagait/text/violations.hpp>
#include <limits>
#include <numbers>

namespace hexagait {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(Quantity, IsInSiUnitsWithoutAUnitAndIsConvertedWithOne) {
  const struct {
    const char* text;
    Dimension dimension;
    double value;
  } cases[] = {{"0.5", Dimension::number, 0.5},
               {"+0.5", Dimension::number, 0.5},
               {"0.05", Dimension::length, 0.05},
               {"0.05m", Dimension::length, 0.05},
               {"-5cm", Dimension::length, -0.05},
               {"50mm", Dimension::length, 0.05},
               {"2", Dimension::time, 2.0},
               {"2s", Dimension::time, 2.0},
               {"20ms", Dimension::time, 0.02},
               {"500us", Dimension::time, 5e-4},
               {"2min", Dimension::time, 120.0},
               {"0.5", Dimension::angle, 0.5},
               {"-0.5rad", Dimension::angle, -0.5},
               {"90deg", Dimension::angle, std::numbers::pi / 2.0},
               {"deg(90)", Dimension::angle, std::numbers::pi / 2.0},
               {"rad(0.5)", Dimension::angle, 0.5},
               {"720deg", Dimension::angle, 4.0 * std::numbers::pi},
               {"-6.283185307179586", Dimension::angle, -2.0 * std::numbers::pi},
               {"8", Dimension::angular_rate, 8.0},
               {"180deg", Dimension::angular_rate, std::numbers::pi}};
  for (const auto& [text, dimension, value] : cases) {
    const Quantity read = parse_quantity(text, dimension);
    EXPECT_THAT(read.problem, IsEmpty()) << text;
    EXPECT_DOUBLE_EQ(read.value, value) << text;
  }
}

// 2π is 6.2832: a whole turn may be written in radians, more is taken for degrees without a unit.
TEST(Quantity, RefusesABareAngleOfMoreThanATurnAndSaysWhatToWrite) {
  EXPECT_EQ(parse_quantity("45", Dimension::angle).problem,
            "'45': an angle without a unit is in radians and at most 2π; write 45deg");
  EXPECT_THAT(parse_quantity("-6.3", Dimension::angle).problem, HasSubstr("write -6.3deg"));
  EXPECT_THAT(parse_quantity("1e300", Dimension::angle).problem, HasSubstr("at most 2π"));
  EXPECT_THAT(parse_quantity("6.28", Dimension::angle).problem, IsEmpty());
}

TEST(Quantity, RefusesWhatWouldOverflow) {
  for (const Dimension dimension : {Dimension::number, Dimension::length, Dimension::time,
                                    Dimension::angle, Dimension::angular_rate}) {
    const std::string unit = dimension == Dimension::angle ? "rad" : "";
    EXPECT_THAT(parse_quantity("1e9" + unit, dimension).problem, IsEmpty());
    EXPECT_THAT(parse_quantity("-1.1e9" + unit, dimension).problem, HasSubstr("at most 1e9"));
    EXPECT_THAT(parse_quantity("1e200" + unit, dimension).problem, HasSubstr("out of range"));
  }
}

TEST(Quantity, RefusesWhatIsNoNumberOrHasAnotherUnit) {
  for (const char* text : {"", "deg", "nan", "inf", "3turns", "1 deg", "1,5", "0.5 ", "deg(x)",
                           "deg(1deg)", "deg()", "+-1", "5cm", "--1", "1e999"})
    EXPECT_THAT(parse_quantity(text, Dimension::angle).problem,
                AllOf(StartsWith("'"), HasSubstr("is not a finite angle such as 30deg")))
        << text;
  EXPECT_THAT(parse_quantity("5s", Dimension::length).problem,
              HasSubstr("'5s' is not a length such as"));
  EXPECT_THAT(parse_quantity("5cm", Dimension::time).problem, HasSubstr("is not a time such as"));
  EXPECT_THAT(parse_quantity("5m", Dimension::number).problem, HasSubstr("is not a finite number"));
}

// As printf's %.6g in the C locale writes them, whatever the locale of the program is.
TEST(Words, OfANumberHaveSixDigitsAndAPoint) {
  EXPECT_EQ(in_words(0.1), "0.1");
  EXPECT_EQ(in_words(1.0 / 3.0), "0.333333");
  EXPECT_EQ(in_words(-2.0), "-2");
  EXPECT_EQ(in_words(1e200), "1e+200");
  EXPECT_EQ(in_words(std::numeric_limits<double>::infinity()), "inf");
}

}  // namespace
}  // namespace hexagait
