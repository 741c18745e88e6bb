// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/model/robot_model.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <limits>
#include <set>

namespace hexagait::sim3d {
namespace {

using Kind = TerrainSpec::Kind;

TEST(ParseTerrain, ReadsTheKindAndTheHeightInAnyUnit) {
  EXPECT_EQ(parse_terrain("flat"), TerrainSpec{});
  for (const char* text : {"boxes:0.10", "boxes:0.1m", "boxes:10cm", "boxes:100mm"}) {
    EXPECT_EQ(parse_terrain(text).kind, Kind::boxes) << text;
    EXPECT_DOUBLE_EQ(parse_terrain(text).height, 0.1) << text;
  }
  EXPECT_EQ(parse_terrain("steps:0").kind, Kind::steps);
  EXPECT_EQ(parse_terrain("steps:0").height, 0.0);
  EXPECT_EQ(parse_terrain("step:12cm"), (TerrainSpec{Kind::step, 0.12}));
}

TEST(ParseTerrain, ReadsBackWhatToStringWrites) {
  for (const double height : {0.0, 0.1, 1.0 / 3.0, 1e-9}) {
    for (const Kind kind : {Kind::boxes, Kind::steps, Kind::step}) {
      const TerrainSpec spec{kind, height};
      EXPECT_EQ(parse_terrain(to_string(spec)), spec);
    }
  }
  EXPECT_EQ(to_string({}), "flat");
}

TEST(ParseTerrain, RefusesWhatItDoesNotKnowAndSaysWhatWouldBeRight) {
  for (const std::string text :
       {"", "hills:0.1", "boxes", "boxes:", "boxes:abc", "boxes:-0.1", "steps:nan", "steps:inf",
        "boxes:0.1ft", "boxes:0.1 m", "boxes:0.1:2", "flat:0.1", "boxes:1e999"}) {
    try {
      (void)parse_terrain(text);
      ADD_FAILURE() << "accepted \"" << text << "\"";
    } catch (const InvalidInput& refusal) {
      EXPECT_THAT(refusal.what(), testing::HasSubstr("\"" + text + "\""));
      EXPECT_THAT(refusal.what(), testing::HasSubstr("flat boxes:H steps:H step:H"));
    }
  }
}

TEST(Terrain, RefusesAHeightOrACellThatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Terrain({Kind::boxes, -0.1}, 1), InvalidInput);
  EXPECT_THROW(Terrain({Kind::boxes, nan}, 1), InvalidInput);
  EXPECT_THROW(Terrain({Kind::boxes, 0.1, 0.0}, 1), InvalidInput);
  EXPECT_THROW(Terrain({Kind::boxes, 0.1, nan}, 1), InvalidInput);
}

TEST(Terrain, HasAStepAtTheFrontEndOfTheStartPad) {
  const Terrain terrain({Kind::step, 0.12}, 1);
  for (const double y : {-50.0, -0.1, 0.0, 0.7, 1000.0}) {
    for (const double x : {-40.0, 0.0, 0.599}) EXPECT_EQ(terrain.height_at(x, y), 0.0) << x;
    for (const double x : {0.601, 0.9, 3.0, 700.0}) EXPECT_EQ(terrain.height_at(x, y), 0.12) << x;
  }
}

TEST(Terrain, IsAFunctionOfSpecAndSeed) {
  for (const Kind kind : {Kind::boxes, Kind::steps}) {
    const Terrain terrain({kind, 0.2}, 7), same({kind, 0.2}, 7), other({kind, 0.2}, 8);
    int equal_to_other = 0;
    for (int k = 0; k < 100; ++k) {
      const double x = 1.0 + 0.3 * k;
      EXPECT_EQ(terrain.height_at(x, 2.0), same.height_at(x, 2.0));
      equal_to_other += terrain.height_at(x, 2.0) == other.height_at(x, 2.0) ? 1 : 0;
    }
    EXPECT_EQ(equal_to_other, 0);
  }
}

TEST(Terrain, IsFlatUnderTheStart) {
  RandomSequence random{.seed = 1};
  for (const Kind kind : {Kind::flat, Kind::boxes, Kind::steps, Kind::step}) {
    const Terrain terrain({kind, 0.2}, 3);
    for (int k = 0; k < 1000; ++k) {
      // Half a sample of the heightfield lies on the ramp that leads off the pad.
      EXPECT_EQ(terrain.height_at(random.uniform(-0.58, 0.58), random.uniform(-0.58, 0.58)), 0.0);
    }
  }
}

// Uniform in [0, h): mean h/2, standard deviation of the mean of N cells h/√(12 N).
TEST(Terrain, HasLevelsUniformFromZeroToTheHeight) {
  constexpr double kHeight = 0.2;
  constexpr int kCells = 200;
  const Terrain terrain({Kind::boxes, kHeight}, 11);
  double sum = 0.0, highest = 0.0;
  std::set<double> levels;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const double level = terrain.level(i - 300, j + 10);
      ASSERT_GE(level, 0.0);
      ASSERT_LT(level, kHeight);
      sum += level;
      highest = std::max(highest, level);
      levels.insert(level);
    }
  }
  constexpr int kCount = kCells * kCells;
  EXPECT_NEAR(sum / kCount, kHeight / 2, 4.0 * kHeight / std::sqrt(12.0 * kCount));
  EXPECT_GT(highest, 0.999 * kHeight);
  EXPECT_EQ(levels.size(), kCount);  // every cell draws a number of its own
}

TEST(Terrain, BoxesHaveTheLevelOfTheCellAllOverTheCell) {
  const Terrain terrain({Kind::boxes, 0.2}, 5);
  for (int k = 0; k < 50; ++k) {
    const double level = terrain.level(k, -k - 3), x = 0.3 * k, y = 0.3 * (-k - 3);
    EXPECT_EQ(terrain.height_at(x + 1e-6, y + 1e-6), level);
    EXPECT_EQ(terrain.height_at(x + 0.3 - 1e-6, y + 0.3 - 1e-6), level);
  }
}

TEST(Terrain, StepsHaveTheLevelsOfTheBoxesAwayFromTheBoundaries) {
  const Terrain boxes({Kind::boxes, 0.2}, 5), steps({Kind::steps, 0.2}, 5);
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 1000; ++k) {
    const double x = 0.3 * std::floor(random.uniform(-1000, 1000)) + random.uniform(0.013, 0.287);
    const double y = 0.3 * std::floor(random.uniform(-1000, 1000)) + random.uniform(0.013, 0.287);
    EXPECT_NEAR(steps.height_at(x, y), boxes.height_at(x, y), 1e-12);
  }
}

// Between two samples the height changes by less than h, so along a line by less than
// √2 h ε/spacing over a distance ε.
TEST(Terrain, StepsHaveNoVerticalFaces) {
  const Terrain terrain({Kind::steps, 0.2}, 5);
  constexpr double kStep = 1e-4;
  const double most = std::sqrt(2.0) * 0.2 * kStep / terrain.sample_spacing();
  double largest = 0.0;
  for (int k = 0; k < 50000; ++k) {
    const double s = 3.0 + kStep * k;
    const double change =
        terrain.height_at(s + kStep, 0.71 * (s + kStep)) - terrain.height_at(s, 0.71 * s);
    EXPECT_LE(std::abs(change), most);
    largest = std::max(largest, std::abs(change));
  }
  EXPECT_GT(largest, 0.1 * most);
}

// Whatever the seed.
TEST(Terrain, OfAStepIsUpFromTheEndOfTheStartPadOn) {
  for (const std::uint64_t seed : {1U, 2U}) {
    const Terrain terrain(parse_terrain("step:12cm"), seed);
    for (int k = -60; k <= 60; ++k) {
      const double y = 0.3 * k + 0.1;
      EXPECT_EQ(terrain.height_at(-20.0, y), 0.0);
      EXPECT_EQ(terrain.height_at(0.6 - 1e-9, y), 0.0);
      EXPECT_EQ(terrain.height_at(0.6 + 1e-9, y), 0.12);
      EXPECT_EQ(terrain.height_at(20.0, y), 0.12);
    }
  }
}

TEST(KnownTerrains, AreAllUnderstood) {
  for (const TerrainDescription& known : known_terrains()) {
    std::string text(known.syntax);
    if (const auto h = text.find('H'); h != std::string::npos) text.replace(h, 1, "0.1");
    EXPECT_NO_THROW((void)parse_terrain(text)) << text;
  }
}

}  // namespace
}  // namespace hexagait::sim3d
