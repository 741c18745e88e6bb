// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/sim2d/slice_model.hpp>
#include <vector>

namespace hexagait::sim2d {
namespace {

constexpr const char* kGaits[] = {"free", "unadjusted", "tripod", "wave:0.6"};

SliceConfig config(const std::string& gait, const std::string& terrain) {
  return {.gait = gait_state::parse_gait_choice(gait).value(),
          .terrain = parse_slice_terrain(terrain).value()};
}

// How long the k-th step of each leg took, of a run: [leg][k].
std::vector<std::vector<int>> step_times(const SliceConfig& c, const SliceSeed& seed) {
  std::vector<std::vector<int>> times(6);
  std::vector<int> now(6);
  run_slices(c, seed, [&](const SliceRecord& record, const SliceRobot& robot) {
    for (LegId leg = 0; leg < 6; ++leg) {
      const auto i = static_cast<std::size_t>(leg);
      if (record.lifted.contains(leg)) now[i] = 0;
      now[i] += record.airborne.contains(leg) ? 1 : 0;
      if (record.airborne.contains(leg) && !robot.airborne().contains(leg))
        times[i].push_back(now[i]);
    }
  });
  return times;
}

TEST(SliceTerrain, IsSpeltAsItIsRead) {
  for (const char* text : {"flat", "descent:3-7", "descent:1-1", "profile:0", "profile:2.5"})
    EXPECT_EQ(to_string(parse_slice_terrain(text).value()), text);
  for (const char* text : {"", "Flat", "descent", "descent:", "descent:3", "descent:7-3",
                           "descent:0-3", "descent:3-7 ", "descent:1-1001", "descent:1.5-2",
                           "profile:", "profile:-1", "profile:nan", "profile:inf", "profile:2m"})
    EXPECT_FALSE(parse_slice_terrain(text)) << text;
}

TEST(Descent, IsFiveSlicesOnFlatGround) {
  for (const char* gait : kGaits)
    for (const auto& leg : step_times(config(gait, "flat"), {2, 3}))
      for (const int time : leg) ASSERT_EQ(time, 1 + 5);
}

// Uniform in 3 … 7: of 60 000 draws 12 000 each, standard deviation √(60 000 · 0.2 · 0.8) = 98.
TEST(Descent, IsUniformInItsRange) {
  const SliceTerrain terrain = parse_slice_terrain("descent:3-7").value();
  std::vector<int> counts(5);
  for (LegId leg = 0; leg < 6; ++leg)
    for (int step = 0; step < 10'000; ++step)
      ++counts.at(static_cast<std::size_t>(descent_of(terrain, {9, 4}, leg, step) - 3));
  for (const int count : counts) EXPECT_NEAR(count, 12'000, 5 * 98);
}

// Paired: whoever walks, the k-th step of a leg takes the time drawn for it.
TEST(Descent, OfAStepIsTheSameForEveryController) {
  const SliceSeed seed{4, 2};
  for (const char* gait : kGaits) {
    const SliceConfig c = config(gait, "descent:1-9");
    const auto times = step_times(c, seed);
    for (LegId leg = 0; leg < 6; ++leg) {
      const auto& of_leg = times[static_cast<std::size_t>(leg)];
      ASSERT_GT(of_leg.size(), 5U);
      for (std::size_t k = 0; k < of_leg.size(); ++k)
        ASSERT_EQ(of_leg[k], 1 + descent_of(c.terrain, seed, leg, static_cast<int>(k))) << gait;
    }
  }
}

TEST(Descent, DiffersFromLegToLegStepToStepAndTrialToTrial) {
  const SliceTerrain terrain = parse_slice_terrain("descent:1-1000").value();
  const int draw = descent_of(terrain, {1, 1}, 1, 1);
  EXPECT_NE(draw, descent_of(terrain, {1, 1}, 2, 1));
  EXPECT_NE(draw, descent_of(terrain, {1, 1}, 1, 2));
  EXPECT_NE(descent_of(terrain, {1, 1}, 1, 2), descent_of(terrain, {1, 1}, 2, 1));
  EXPECT_NE(draw, descent_of(terrain, {1, 2}, 1, 1));
  EXPECT_NE(draw, descent_of(terrain, {2, 1}, 1, 1));
}

TEST(Profile, OfNoRoughnessIsFlatGround) {
  for (const char* gait : kGaits)
    for (std::uint32_t trial = 0; trial < 20; ++trial)
      EXPECT_EQ(run_slices(config(gait, "profile:0"), {6, trial}).hash,
                run_slices(config(gait, "flat"), {6, trial}).hash);
}

// Heights are uniform in 0 … 4: mean 2, standard deviation of a mean of 6000 is 4/√12/√6000 =
// 0.015.
TEST(Profile, HasHeightsUniformUpToTheRoughness) {
  const SliceTerrain terrain = parse_slice_terrain("profile:4").value();
  double sum = 0.0;
  for (LegId leg = 0; leg < 6; ++leg)
    for (std::int64_t cell = -500; cell < 500; ++cell) {
      const double height = cell_height(terrain, {1, 1}, leg, cell);
      ASSERT_TRUE(0.0 <= height && height < 4.0);
      sum += height;
    }
  EXPECT_NEAR(sum / 6000.0, 2.0, 5 * 0.015);
}

TEST(Profile, HasCellsAsLongAsTheySayOnBothSidesOfZero) {
  const SliceTerrain terrain{.kind = SliceTerrain::Kind::profile, .cell = 40.0};
  EXPECT_EQ(cell_at(terrain, 0.0), 0);
  EXPECT_EQ(cell_at(terrain, 39.9), 0);
  EXPECT_EQ(cell_at(terrain, 40.0), 1);
  EXPECT_EQ(cell_at(terrain, -0.1), -1);
}

// (slice 3), followed from outside: heights of the last footholds, the ground below each foot in
// the air, and whether it stands.
void expect_landings(const std::string& terrain) {
  const SliceConfig c = config("free", terrain);
  const SliceSeed seed{8, 1};
  const auto ground = [&](LegId leg, double x) {
    return cell_height(c.terrain, seed, leg, static_cast<std::int64_t>(std::floor(x / 50.0)));
  };
  SliceRobot robot(c, seed);
  LegArray<double> foothold(6);
  for (LegId leg = 0; leg < 6; ++leg) foothold[leg] = ground(leg, robot.foot()[leg]);
  LegArray<int> slices(6, 0);
  for (int slice = 0; slice < 500; ++slice) {
    const LegSet air = robot.advance().airborne;
    double level = 0.0;
    for (const double height : foothold) level += height / 6.0;
    for (LegId leg = 0; leg < 6; ++leg) {
      if (!air.contains(leg)) continue;
      const double below = ground(leg, robot.position() + 25.0);
      const int descended = slices[leg]++;
      const bool stands = descended >= 1 && 5.0 - descended + level - below <= 0.5;
      ASSERT_EQ(stands, !robot.airborne().contains(leg)) << "leg " << leg << ", slice " << slice;
      if (!stands) continue;
      foothold[leg] = below;
      slices[leg] = 0;
    }
  }
}

TEST(Profile, FeetStandInTheFirstSliceInWhichTheyAreWithinHalfASliceOfTheGround) {
  expect_landings("profile:4");
  expect_landings("profile:30");  // also on ground that is higher than a foot is raised
}

}  // namespace
}  // namespace hexagait::sim2d
