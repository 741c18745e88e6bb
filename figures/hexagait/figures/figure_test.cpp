// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/figures/figure.hpp>
#include <iterator>

namespace hexagait::figures {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Variables, AreALineEachAsGnuplotSpellsThem) {
  const Variables variables = {{"legs", 6},
                               {"step", 2.0},
                               {"name", "it's {all}"},
                               {"means", std::vector<double>{1.5, 8.0}},
                               {"names", std::vector<std::string>{"a", "b"}}};
  EXPECT_EQ(variables.text(),
            "legs = 6\nstep = 2.00000000\nname = 'it''s {all}'\n"
            "array means[2] = [1.50000000, 8.00000000]\narray names[2] = ['a', 'b']\n");
}

TEST(Variables, PlacePanelsAndBoxes) {
  const Variables variables = {{"path", Panel{0.1, 0.5, 0.2, 0.4}},
                               {"path", Box{{-1.0, 0.0}, {1.0, 2.0}}}};
  EXPECT_EQ(variables.text(),
            "path_panel = panel(0.1, 0.5, 0.2, 0.4); path_top = 0.4\n"
            "path_range = 'set xrange [-1.0000:1.0000]; set yrange [0.0000:2.0000]'\n");
}

std::string drawn(StagedFiles& files, const Figure& figure, std::string_view script) {
  draw_figure(files, figure, {{"area", Panel{0.1, 0.9, 0.1, 0.8}}}, script);
  std::ifstream svg(files.staging() / (figure.stem + ".svg"));
  return {std::istreambuf_iterator<char>(svg), {}};
}

constexpr std::string_view kScript = "eval area_panel\neval heading('a', 'Panel')\nplot [0:1] x";

TEST(Figure, IsDrawnInAllFormatsByAScriptThatStandsAlone) {
  StagedFiles files(::testing::TempDir());
  const Figure figure{.stem = "figure", .headline = "Top", .subtitle = "below", .height = 500};
  const std::string svg = drawn(files, figure, kScript);
  EXPECT_THAT(svg, HasSubstr("width=\"1500\" height=\"500\""));
  EXPECT_THAT(svg, HasSubstr("Top"));
  EXPECT_THAT(svg, HasSubstr("Panel"));
  EXPECT_EQ(files.names(),
            (std::vector<std::string>{"figure.gp", "figure.svg", "figure.pdf", "figure.png"}));
  for (const std::string& name : files.names())
    EXPECT_GT(std::filesystem::file_size(files.staging() / name), 500U) << name;
}

// The panel keeps its size: 0.7 · 500 px.
TEST(Figure, WithoutTitlesIsAsMuchLessTall) {
  StagedFiles files(::testing::TempDir());
  const Figure figure{.stem = "figure", .headline = "", .subtitle = "", .height = 500};
  EXPECT_THAT(drawn(files, figure, kScript), HasSubstr("width=\"1500\" height=\"435\""));
}

// 15 pt are 20 px, and a letter some 12 px wide.
TEST(Figure, LongTitlesAreSetInSmallerLetters) {
  StagedFiles files(::testing::TempDir());
  const std::string shorter(100, 'n'), longer(200, 'n');
  EXPECT_THAT(drawn(files, {.stem = "figure", .headline = shorter, .subtitle = ""}, kScript),
              HasSubstr("font-size=\"20.00\""));
  EXPECT_THAT(drawn(files, {.stem = "figure", .headline = longer, .subtitle = ""}, kScript),
              Not(HasSubstr("font-size=\"20.00\"")));
}

TEST(Figure, ThatGnuplotRefusesSaysWhy) {
  StagedFiles files(::testing::TempDir());
  try {
    drawn(files, {.stem = "figure", .headline = "", .subtitle = ""}, "plot 'missing.csv'");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("missing.csv"));
  }
}

}  // namespace
}  // namespace hexagait::figures
