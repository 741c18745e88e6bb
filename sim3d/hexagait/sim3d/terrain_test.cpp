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

TEST(Terrain, HasAStepAtTheFrontEndOfTheStartPad) {
  const Terrain terrain(TerrainSpec(TerrainKind::step, 0.12), 1);
  for (const double y : {-50.0, -0.1, 0.0, 0.7, 1000.0}) {
    for (const double x : {-40.0, 0.0, 0.599}) EXPECT_EQ(terrain.height_at(x, y), 0.0) << x;
    for (const double x : {0.601, 0.9, 3.0, 700.0}) EXPECT_EQ(terrain.height_at(x, y), 0.12) << x;
  }
}

TEST(Terrain, IsAFunctionOfSpecAndSeed) {
  for (const TerrainKind kind : {TerrainKind::boxes, TerrainKind::steps}) {
    const Terrain terrain(TerrainSpec(kind, 0.2), 7), same({kind, 0.2}, 7), other({kind, 0.2}, 8);
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
  for (const TerrainKind kind :
       {TerrainKind::flat, TerrainKind::boxes, TerrainKind::steps, TerrainKind::step}) {
    const Terrain terrain(TerrainSpec(kind, 0.2), 3);
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
  const Terrain terrain(TerrainSpec(TerrainKind::boxes, kHeight), 11);
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

TEST(Terrain, HasCellsOfTheWidthThatIsAskedForAndAPadOfTwo) {
  for (const char* text : {"boxes:0.2,0.1", "steps:0.2,0.1", "rubble:0.2,0.1"}) {
    const Terrain terrain(parse_terrain(text), 5), wide(parse_terrain("boxes:0.2"), 5);
    for (const double x : {-0.19, 0.0, 0.19}) EXPECT_EQ(terrain.height_at(x, -x), 0.0) << text;
    EXPECT_NE(terrain.height_at(0.25, 0.0), 0.0) << text;
    EXPECT_NEAR(terrain.sample_spacing(), 0.1 / Terrain::kSamplesPerCell, 1e-15);
    if (terrain.spec().parts[0].kind == TerrainKind::rubble) continue;
    for (int k = 7; k < 30; ++k)
      EXPECT_EQ(terrain.height_at(0.1 * k + 0.05, 0.05), wide.height_at(0.3 * k + 0.15, 0.15));
  }
}

TEST(Terrain, BoxesHaveTheLevelOfTheCellAllOverTheCell) {
  const Terrain terrain(TerrainSpec(TerrainKind::boxes, 0.2), 5);
  for (int k = 0; k < 50; ++k) {
    const double level = terrain.level(k, -k - 3), x = 0.3 * k, y = 0.3 * (-k - 3);
    EXPECT_EQ(terrain.height_at(x + 1e-6, y + 1e-6), level);
    EXPECT_EQ(terrain.height_at(x + 0.3 - 1e-6, y + 0.3 - 1e-6), level);
  }
}

TEST(Terrain, StepsHaveTheLevelsOfTheBoxesAwayFromTheBoundaries) {
  const Terrain boxes({TerrainKind::boxes, 0.2}, 5), steps({TerrainKind::steps, 0.2}, 5);
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
  const Terrain terrain(TerrainSpec(TerrainKind::steps, 0.2), 5);
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

// Ten steps up, five level, ten down, five level.
TEST(Terrain, OfStairsGoesUpAndDown) {
  const Terrain terrain(parse_terrain("stairs:0.1,0.5"), 1);
  // The pad ends with the second tread, at 1.0.
  const auto level = [&](int n) { return terrain.height_at(1.25 + 0.5 * n, -3.0); };
  EXPECT_EQ(terrain.height_at(0.99, 0.0), 0.0);
  for (int n = 0; n < 10; ++n) EXPECT_NEAR(level(n), 0.1 * (n + 1), 1e-12) << n;
  for (int n = 10; n < 15; ++n) EXPECT_NEAR(level(n), 1.0, 1e-12);
  for (int n = 15; n < 25; ++n) EXPECT_NEAR(level(n), 0.1 * (24 - n), 1e-12) << n;
  for (int n = 25; n < 30; ++n) EXPECT_EQ(level(n), 0.0);
  EXPECT_NEAR(level(30), 0.1, 1e-12) << "and again";
  EXPECT_EQ(Terrain(parse_terrain("stairs:-0.1,0.5"), 1).height_at(1.25, 0.0), -0.1);
}

TEST(Terrain, HasDitchesAcrossTheWay) {
  const Terrain terrain(parse_terrain("ditches:0.3"), 1);
  for (const double y : {-2.0, 0.0, 5.0})
    for (const double period : {0.0, 1.5, -3.0}) {
      EXPECT_EQ(terrain.height_at(1.19 + period, y), 0.0);
      EXPECT_EQ(terrain.height_at(1.21 + period, y), -1.0);
      EXPECT_EQ(terrain.height_at(1.49 + period, y), -1.0);
      EXPECT_EQ(terrain.height_at(1.51 + period, y), 0.0);
    }
}

// The share of stones is (edge/(edge + gap))².
TEST(Terrain, HasStonesOverAnAbyss) {
  const Terrain terrain(parse_terrain("stones:0.25,0.15"), 1);
  RandomSequence random{.seed = 6};
  int on_stones = 0;
  constexpr int kCount = 20000;
  for (int k = 0; k < kCount; ++k) {
    const double z = terrain.height_at(random.uniform(2.0, 402.0), random.uniform(-200.0, 200.0));
    EXPECT_TRUE(z == 0.0 || z == -1.0);
    on_stones += z == 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(on_stones / double{kCount}, 0.625 * 0.625, 0.015);
}

TEST(Terrain, OfACliffGoesDownBeyondTheEdgesOfASquare) {
  const Terrain terrain(parse_terrain("cliff:3m,20cm"), 1);
  for (const double along : {-1.49, -0.3, 0.0, 1.49})
    for (const double sign : {-1.0, 1.0}) {
      EXPECT_EQ(terrain.height_at(sign * 1.499, along), 0.0);
      EXPECT_EQ(terrain.height_at(sign * 1.501, along), -0.2);
      EXPECT_EQ(terrain.height_at(along, sign * 1.499), 0.0);
      EXPECT_EQ(terrain.height_at(along, sign * 1.501), -0.2);
    }
  EXPECT_EQ(terrain.height_at(1e6, 0.0), -0.2) << "it does not come up again";
}

// 4 m are 14 cells, of which the outermost ring is at 1.8 to 2.1 m: every way out is barred.
TEST(Terrain, OfAnArenaIsBetweenWallsAndCliffs) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Terrain terrain(parse_terrain("arena:4m,0"), seed);
    int walls = 0, cliffs = 0;
    for (double t = -1.95; t < 2.0; t += 0.3)
      for (const auto& [x, y] : {std::pair{1.95, t}, {-1.95, t}, {t, 1.95}, {t, -1.95}}) {
        const double z = terrain.height_at(x, y);
        EXPECT_EQ(std::abs(z), 1.0) << x << " " << y;
        ++(z > 0.0 ? walls : cliffs);
      }
    EXPECT_GE(walls, 8) << "there are both";
    EXPECT_GE(cliffs, 8);
    RandomSequence random{.seed = seed};
    for (int k = 0; k < 1000; ++k) {
      const double x = random.uniform(-1.8, 1.8), y = random.uniform(-1.8, 1.8);
      EXPECT_EQ(terrain.height_at(x, y), 0.0) << "a share of none";
      EXPECT_EQ(terrain.height_at(2.1 + random.uniform(0.0, 50.0), y), -1.0) << "beyond";
    }
  }
}

TEST(Terrain, OfAnArenaHasPitsAndPillarsOnTheShareOfItsCells) {
  const Terrain terrain(parse_terrain("arena:200m,0.1"), 7);
  RandomSequence random{.seed = 8};
  int pits = 0, pillars = 0;
  constexpr int kCount = 20000;
  for (int k = 0; k < kCount; ++k) {
    const double z = terrain.height_at(random.uniform(-99.0, 99.0), random.uniform(-99.0, 99.0));
    EXPECT_TRUE(z == 0.0 || std::abs(z) == 1.0);
    pits += z < 0.0 ? 1 : 0;
    pillars += z > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(pits / double{kCount}, 0.05, 0.006);
  EXPECT_NEAR(pillars / double{kCount}, 0.05, 0.006);
}

// By differences, far from where the slope begins.
TEST(Terrain, RisesInTheDirectionOfTheSlope) {
  for (const double direction : {0.0, 0.5, 1.5707963267948966, 3.0, -2.0}) {
    const Terrain terrain(parse_terrain("slope:0.3," + std::to_string(direction)), 1);
    const double x = 7.0, y = -2.0, z = terrain.height_at(x, y);
    const double along = terrain.height_at(x + 1.0, y) - z,
                 across = terrain.height_at(x, y + 1.0) - z;
    EXPECT_NEAR(along, std::tan(0.3) * std::cos(direction), 1e-5);
    EXPECT_NEAR(across, std::tan(0.3) * std::sin(direction), 1e-5);
    for (const double before : {-5.0, 0.0, 0.55}) EXPECT_EQ(terrain.height_at(before, 3.0), 0.0);
  }
}

// Whatever the terrain: flat where the robot starts, and within its bounds.
TEST(Terrain, OfEveryKindIsFlatUnderTheStartAndWithinItsBounds) {
  RandomSequence random{.seed = 1};
  for (const TerrainDescription& known : known_terrains()) {
    if (known.reads_file) continue;
    const Terrain terrain(parse_terrain(known.example), 3);
    double lowest = 1.0, highest = -1.0;
    for (int k = 0; k < 2000; ++k) {
      EXPECT_EQ(terrain.height_at(random.uniform(-0.58, 0.58), random.uniform(-0.58, 0.58)), 0.0)
          << known.example;
      const double z = terrain.height_at(random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0));
      EXPECT_GE(z, terrain.lowest());
      EXPECT_LE(z, terrain.highest());
      lowest = std::min(lowest, z), highest = std::max(highest, z);
    }
    if (!std::isfinite(terrain.highest())) continue;
    const double range = terrain.highest() - terrain.lowest();
    EXPECT_GE(highest - lowest, 0.9 * range) << known.example << ": bounds that say something";
  }
}

// With vertical faces as ramps.
TEST(Terrain, OfASumHasTheSumOfTheHeights) {
  const Terrain sum(parse_terrain("slope:10deg,40deg+boxes:0.1+waves:0.05"), 9);
  const Terrain slope(parse_terrain("slope:10deg,40deg"), 9), steps(parse_terrain("steps:0.1"), 9),
      waves(parse_terrain("waves:0.05"), 9);
  RandomSequence random{.seed = 2};
  for (int k = 0; k < 500; ++k) {
    const double x = random.uniform(-10.0, 10.0), y = random.uniform(-10.0, 10.0);
    EXPECT_NEAR(sum.height_at(x, y),
                slope.height_at(x, y) + steps.height_at(x, y) + waves.height_at(x, y), 1e-12);
  }
}

// All four corners of each cell are within the height, and it is level in no cell.
TEST(Terrain, TiltsTheCellsOfRubble) {
  const Terrain terrain(parse_terrain("rubble:0.2"), 5);
  for (int i = 3; i < 200; ++i) {
    const double x = 0.3 * i + 0.15, y = -0.3 * i - 0.15, r = 0.1;
    const double z = terrain.height_at(x, y), dx = terrain.height_at(x + r, y) - z,
                 dy = terrain.height_at(x, y + r) - z;
    EXPECT_NEAR(terrain.height_at(x - r, y - r), z - dx - dy, 1e-9) << "a plane";
    EXPECT_GT(std::abs(dx) + std::abs(dy), 0.0);
    EXPECT_LE(std::abs(dx), 0.05 * r / 0.15 + 1e-12);
  }
}

TEST(Terrain, HasIceOnHalfOfTheGround) {
  const Terrain terrain(parse_terrain("boxes:0.1+ice:0.05"), 5), dry(parse_terrain("boxes:0.1"), 5);
  RandomSequence random{.seed = 3};
  int icy = 0;
  constexpr int kCount = 20000;
  for (int k = 0; k < kCount; ++k) {
    const double x = random.uniform(-300.0, 300.0), y = random.uniform(-300.0, 300.0);
    const double friction = terrain.friction_at(x, y, 0.9);
    EXPECT_TRUE(friction == 0.9 || friction == 0.05);
    icy += friction == 0.05 ? 1 : 0;
    EXPECT_EQ(dry.friction_at(x, y, 0.9), 0.9);
    EXPECT_EQ(terrain.height_at(x, y), dry.height_at(x, y));
  }
  EXPECT_NEAR(icy / double{kCount}, 0.5, 0.03);
  EXPECT_EQ(terrain.friction_at(0.5, -0.5, 0.9), 0.9) << "not on the start pad";
}

TEST(CellAxis, HasCellsOfTwoWidthsInTurn) {
  const CellAxis axis{0.25, 0.15};
  for (int i = -9; i < 9; ++i) {
    EXPECT_NEAR(axis.edge(i + 1) - axis.edge(i), i % 2 == 0 ? 0.25 : 0.15, 1e-12) << i;
    EXPECT_EQ(axis.index(axis.middle(i)), i);
    EXPECT_EQ(axis.index(axis.edge(i) + 1e-9), i);
    EXPECT_EQ(axis.index(axis.edge(i) - 1e-9), i - 1);
  }
  EXPECT_EQ(axis.edge(0), 0.0);
}

}  // namespace
}  // namespace hexagait::sim3d
