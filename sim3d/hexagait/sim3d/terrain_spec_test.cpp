// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <limits>
#include <numbers>
#include <set>

namespace hexagait::sim3d {
namespace {

using Kind = TerrainKind;

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(ParseTerrain, ReadsTheKindAndTheHeightInAnyUnit) {
  EXPECT_EQ(parse_terrain("flat"), TerrainSpec{});
  for (const char* text : {"boxes:0.10", "boxes:0.1m", "boxes:10cm", "boxes:100mm"})
    EXPECT_EQ(parse_terrain(text), (TerrainSpec{Kind::boxes, 0.1})) << text;
  EXPECT_EQ(parse_terrain("steps:0"), (TerrainSpec{Kind::steps, 0.0}));
  EXPECT_EQ(parse_terrain("step:-12cm"), (TerrainSpec{Kind::step, -0.12})) << "down";
}

TEST(ParseTerrain, ReadsASecondDimensionOrTakesTheUsualOne) {
  const auto only = [](const char* text) { return parse_terrain(text).parts.at(0); };
  EXPECT_EQ(only("boxes:17cm"), (TerrainPart{Kind::boxes, 0.17, kCellEdge}));
  EXPECT_EQ(only("rubble:2cm,5cm"), (TerrainPart{Kind::rubble, 0.02, 0.05}));
  EXPECT_EQ(only("stairs:17cm"), (TerrainPart{Kind::stairs, 0.17, 0.29}));
  EXPECT_EQ(only("stairs:17cm,0.35"), (TerrainPart{Kind::stairs, 0.17, 0.35}));
  EXPECT_EQ(only("slope:10deg"), (TerrainPart{Kind::slope, 10.0 * kDegree, 0.0}));
  EXPECT_EQ(only("slope:10deg,90deg"), (TerrainPart{Kind::slope, 10.0 * kDegree, 90.0 * kDegree}));
  EXPECT_EQ(only("stones:25cm,0"), (TerrainPart{Kind::stones, 0.25, 0.0}));
  EXPECT_EQ(only("ice:0.1"), (TerrainPart{Kind::ice, 0.1, 0.0}));
  EXPECT_EQ(only("cliff:3m"), (TerrainPart{Kind::cliff, 3.0, 1.0}));
  EXPECT_EQ(only("cliff:3m,20cm"), (TerrainPart{Kind::cliff, 3.0, 0.2}));
  EXPECT_EQ(only("arena:4m"), (TerrainPart{Kind::arena, 4.0, 0.04}));
  EXPECT_EQ(only("arena:4m,0.1"), (TerrainPart{Kind::arena, 4.0, 0.1}));
}

TEST(ParseTerrain, ReadsSums) {
  const TerrainSpec sum = parse_terrain("slope:0.2+boxes:1e-1+waves:5cm,2");
  EXPECT_EQ(sum.parts,
            (std::vector<TerrainPart>{
                {Kind::slope, 0.2, 0.0}, {Kind::boxes, 0.1, 0.3}, {Kind::waves, 0.05, 2.0}}));
  EXPECT_DOUBLE_EQ(sum.roughness(), 0.15);
  EXPECT_EQ(parse_terrain("boxes:1e+0+steps:+0.5").parts.size(), 2U) << "signs of numbers";
}

TEST(ParseTerrain, ReadsBackWhatToStringWrites) {
  for (const double size : {0.0, 0.1, 1.0 / 3.0, 1e-9, 1e9})
    for (const Kind kind : {Kind::boxes, Kind::steps, Kind::step, Kind::rubble}) {
      TerrainSpec spec{kind, size};
      EXPECT_EQ(parse_terrain(to_string(spec)), spec);
      spec.parts.push_back({Kind::boxes, size, 0.05});
      spec.parts.push_back({Kind::stairs, -size, 0.3});
      spec.parts.push_back({Kind::waves, size, 1e9});
      EXPECT_EQ(parse_terrain(to_string(spec)), spec) << to_string(spec);
    }
  EXPECT_EQ(to_string({}), "flat");
  EXPECT_EQ(to_string({Kind::boxes, 0.1}), "boxes:0.1");
}

TEST(ParseTerrain, RefusesWhatItDoesNotKnowAndSaysWhatWouldBeRight) {
  for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
           {"", "unknown kind"},
           {"hills:0.1", "unknown kind"},
           {"boxs:0.1", "did you mean"},
           {"boxes", "the height is missing"},
           {"boxes:", ""},
           {"boxes:abc", "abc"},
           {"boxes:-0.1", "the height must be 0 or more, not -0.1"},
           {"steps:nan", ""},
           {"steps:inf", ""},
           {"boxes:0.1ft", ""},
           {"boxes:0.1 m", ""},
           {"boxes:0.1:2", ""},
           {"boxes:0.1,0", "the width must be 5 mm or more, not 0"},
           {"boxes:0.1,2,3", ""},
           {"step:0.1,2", "step takes one number, the height"},
           {"flat:0.1", "unknown kind"},
           {"boxes:1e999", ""},
           {"boxes:0.1+", "unknown kind"},
           {"boxes:0.1+hills:1", "unknown kind"},
           {"slope:70deg", "the angle must be -60 to 60 degrees"},
           {"slope:10", ""},
           {"ditches:1", "the width must be 0.01 to 0.8 m"},
           {"stairs:0.1,0", "the tread must be 0.05 m or more"},
           {"stones:0", "the edge must be 0.02 m or more"},
           {"stones:0.2,-0.1", "the gap must be 0 or more"},
           {"waves:0.1,0", "the length must be 0.05 m or more"},
           {"cliff:1m", "the edge must be 1.2 m or more"},
           {"cliff:3m,0", "the depth must be 0.05 m or more"},
           {"arena:1m", "the edge must be 2 m or more"},
           {"arena:3m,0.6", "the share must be 0 to 0.5"},
           {"ice:11", "the friction must be 0 to 10"}}) {
    try {
      (void)parse_terrain(text);
      ADD_FAILURE() << "accepted \"" << text << "\"";
    } catch (const InvalidInput& refusal) {
      EXPECT_THAT(refusal.what(), ::testing::HasSubstr("\"" + text + "\": "));
      EXPECT_THAT(refusal.what(), ::testing::HasSubstr(reason));
      EXPECT_THAT(refusal.what(), ::testing::HasSubstr("flat boxes:H,WIDTH steps:H,WIDTH step:H"));
    }
  }
}

TEST(Terrain, RefusesWhatCannotBeWritten) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Terrain(TerrainSpec(Kind::boxes, -0.1), 1), InvalidInput);
  EXPECT_THROW(Terrain(TerrainSpec(Kind::boxes, nan), 1), InvalidInput);
  TerrainSpec spec(Kind::boxes, 0.1);
  for (const double cell : {0.0, 0.001, nan}) {
    spec.parts[0].extent = cell;
    EXPECT_THROW(Terrain(spec, 1), InvalidInput);
  }
}

TEST(KnownTerrains, AreAllUnderstoodAndComplete) {
  std::set<Kind> kinds;
  for (const TerrainDescription& known : known_terrains()) {
    const TerrainSpec spec = parse_terrain(known.example);
    kinds.insert(spec.parts.empty() ? Kind::flat : spec.parts[0].kind);
    EXPECT_EQ(known.syntax.substr(0, known.syntax.find(':')),
              known.example.substr(0, known.example.find(':')));
  }
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(Kind::soft) + 1) << "soft is the last";
}

}  // namespace
}  // namespace hexagait::sim3d
