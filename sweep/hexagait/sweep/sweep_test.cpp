// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.hpp"

#include <hexagait/sweep/detail/header.hpp>
#include <hexagait/sweep/detail/scratch_sweep.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <set>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait::sweep {
namespace {

using Grid = ScratchSweep;

// At the edge of an abyss no leg finds ground.
TEST(Row, OfARobotThatIsStuckSaysForWhichLegItWaits) {
  const RobotModel robot = testing::argos();
  TrialConfig config;
  config.engine = Engine::ode;
  config.controller = *gait_state::parse_gait_choice("free");
  config.robot = &robot;
  config.terrain = "cliff:2.0";
  config.limits.distance = 3.0;
  config.limits.random_posture = 0.03;
  // From some starts it falls off the cliff, from some its legs hit the wall below; from most it finds no ground.
  std::string row;
  for (config.seed = 1; config.seed <= 16; ++config.seed) {
    row = run(config);
    if (row.starts_with("stuck,leg ") && row.find("it finds no ground; or") < row.find(",0."))
      break;
  }
  EXPECT_LE(config.seed, 16U) << row;
  EXPECT_EQ(std::ranges::count(row, ','), static_cast<long>(columns(Engine::ode).size()) + 1)
      << "outcome and reason come before";
}

// 3 controllers × 3 terrains × 7 seeds × 2 plants × 2 robots: 252 trials, each a cell of its own.
TEST_F(Grid, NumbersItsPointsOneToOne) {
  Sweep sweep = slices(7);
  sweep.robots.push_back({.name = "other", .model = {}});
  sweep.plants.push_back(recording::parse_plant("real"));
  ASSERT_EQ(num_trials(sweep), 252U);
  std::set<std::array<std::uint64_t, 5>> cells;
  for (std::uint64_t k = 0; k < 252; ++k) {
    const GridPoint c = grid_point(sweep, k);
    EXPECT_LT(c.robot, 2U);
    EXPECT_LT(c.plant, 2U);
    EXPECT_LT(c.terrain, 3U);
    EXPECT_LT(c.controller, 3U);
    EXPECT_LT(c.seed_index, 7U);
    cells.insert({c.robot, c.plant, c.terrain, c.controller, c.seed_index});
  }
  EXPECT_EQ(cells.size(), 252U);
}

// Trials 0, 1, 2 are the three controllers on the same ground: that is what is compared.
TEST_F(Grid, PutsTheControllersOfOneGroundSideBySide) {
  const Sweep sweep = slices(7);
  for (std::uint64_t k = 0; k < num_trials(sweep); k += 3)
    for (std::uint64_t c = 0; c < 3; ++c) {
      EXPECT_EQ(grid_point(sweep, k + c).controller, c);
      EXPECT_EQ(trial(sweep, k + c).seed, trial(sweep, k).seed);
      EXPECT_EQ(trial(sweep, k + c).terrain, trial(sweep, k).terrain);
    }
}

TEST_F(Grid, IsCutIntoShardsThatShareNothingAndLackNothing) {
  const Sweep sweep = slices(7);
  for (std::uint64_t count : {1U, 2U, 4U, 21U, 30U}) {
    std::set<std::uint64_t> trials;
    std::uint64_t sum = 0;
    for (std::uint64_t index = 0; index < count; ++index) {
      const Shard shard{index, count};
      sum += num_trials(sweep, shard);
      for (std::uint64_t p = 0; p < num_trials(sweep, shard); ++p) {
        trials.insert(trial_at(sweep, shard, p));
        EXPECT_TRUE(p == 0 || trial_at(sweep, shard, p) > trial_at(sweep, shard, p - 1));
      }
    }
    EXPECT_EQ(sum, num_trials(sweep)) << count;
    EXPECT_EQ(trials.size(), num_trials(sweep)) << count;
    EXPECT_EQ(*trials.rbegin(), num_trials(sweep) - 1) << count;
  }
}

// Seeds depend on master seed, terrain and index alone.
TEST_F(Grid, DrawsSeedsThatFurtherTerrainsAndSeedsDoNotMove) {
  const Sweep few = slices(4);
  Sweep more = slices(9);
  more.terrains.insert(more.terrains.begin(), ground(Engine::slice, "profile:3"));
  std::set<std::uint64_t> seeds;
  for (std::size_t t = 0; t < 3; ++t)
    for (std::uint64_t s = 0; s < 4; ++s) {
      EXPECT_EQ(seed(few, {.terrain = t, .seed_index = s}),
                seed(more, {.terrain = t + 1, .seed_index = s}));
      seeds.insert(seed(few, {.terrain = t, .seed_index = s}));
    }
  EXPECT_EQ(seeds.size(), 12U);
  Sweep other = few;
  other.master_seed = 2;
  EXPECT_NE(seed(other, {}), seed(few, {}));
}

TEST_F(Grid, TakesListedSeedsAsTheyAre) {
  Sweep sweep = slices(2);
  sweep.seeds = {17, 4};
  EXPECT_EQ(trial(sweep, 0).seed, 17U);
  EXPECT_EQ(trial(sweep, 3).seed, 4U);
  EXPECT_EQ(num_trials(sweep), 18U);
}

TEST_F(Grid, HasAsManyCellsInARowAsInItsHeader) {
  const auto commas = [](const std::string& text) { return std::ranges::count(text, ','); };
  const Sweep sweep = slices(1);
  for (std::uint64_t k = 0; k < num_trials(sweep); ++k)
    EXPECT_EQ(commas(row(sweep, k)), commas(csv_header(sweep)));
}

using SweepFile = ScratchSweep;

std::string argos(const std::string& name) {
  if (name != "argos") throw InvalidInput("robot is '" + name + "', which does not exist");
  return testing::source_path("robots/argos.urdf");
}

TEST_F(SweepFile, IsAGridOfAllThatItLists) {
  std::ofstream(at("a.yaml")) << "simulator: ode\ncontrollers: [free, 'wave:0.75']\n"
                                 "terrains: [flat, boxes]\nroughness: [0.05, 0.10]\nseeds: 5\n"
                                 "seconds: 3\nmaster_seed: 8\nmeasure: distance_m\n";
  const Sweep sweep = load_sweep(at("a.yaml"), argos);
  EXPECT_EQ(num_trials(sweep), 2U * 3U * 5U);
  EXPECT_EQ(sweep.terrains[2].terrain, "boxes:0.1");
  EXPECT_EQ(sweep.terrains[2].roughness, 0.10);
  EXPECT_EQ(sweep.robots[0].name, "argos");
  EXPECT_EQ(sweep.robots[0].model.num_legs(), 6);
  EXPECT_EQ(sweep.limits.seconds, 3.0);
  EXPECT_EQ(sweep.master_seed, 8U);
  EXPECT_EQ(sweep.measure, "distance_m");
}

// Plants are an axis: each trial has its own, with the seed of the others on its terrain, so that
// they are paired; all their numbers are in the header, which merging compares.
TEST_F(SweepFile, HasPlantsAsAnAxis) {
  std::ofstream(at("a.yaml")) << "simulator: ode\ncontrollers: [free]\nterrains: [flat]\nseeds: 2\n"
                                 "plants: [ideal, real+friction:0.4, joint_noise:2mrad]\n"
                                 "seconds: 0.1\n";
  const Sweep sweep = load_sweep(at("a.yaml"), argos);
  ASSERT_EQ(num_trials(sweep), 6U);
  EXPECT_EQ(trial(sweep, 2).plant.world.friction, 0.4);
  EXPECT_EQ(trial(sweep, 4).plant.faults.joint_noise, 0.002);
  EXPECT_EQ(trial(sweep, 4).seed, trial(sweep, 0).seed);
  EXPECT_NE(trial(sweep, 5).seed, trial(sweep, 0).seed);
  EXPECT_TRUE(row(sweep, 2).starts_with("2,free,argos,real+friction:0.4,flat,0,"));
  const std::string hash = row(sweep, 4).substr(row(sweep, 4).rfind(','));
  EXPECT_EQ(row(sweep, 4).substr(row(sweep, 4).rfind(',')), hash);
  EXPECT_FALSE(row(sweep, 0).ends_with(hash));

  std::ofstream(at("b.yaml")) << "simulator: ode\ncontrollers: [free]\nterrains: [flat]\nseeds: 2\n"
                                 "plants: [ideal, real+friction:0.4, joint_noise:1mrad]\n"
                                 "seconds: 0.1\n";
  const std::string one = to_header(sweep, {}),
                    other = to_header(load_sweep(at("b.yaml"), argos), {});
  EXPECT_THAT(differences(one, other, true),
              ::testing::Contains(::testing::HasSubstr("joint_noise_rad\":0.002")));
}

TEST_F(SweepFile, RefusesPlantsThatAreNone) {
  std::ofstream(at("x.yaml")) << "simulator: ode\ncontrollers: [free]\nterrains: [flat]\nseeds: 1\n"
                                 "plants: [rael, real, real, late_ticks:200%]\n";
  const std::string text = refusal([&] { static_cast<void>(load_sweep(at("x.yaml"), argos)); });
  for (const char* part :
       {":5:10: 'rael' is no plant; did you mean 'real'?", ":5:22: the plant 'real' is there twice",
        ":5:28: late_ticks is '200%'; it must be a share from 0 to 1"})
    EXPECT_THAT(text, ::testing::HasSubstr(part));
  std::ofstream(at("y.yaml"))
      << "simulator: box2d\ncontrollers: [free]\nterrains: [flat]\nseeds: 1\n"
         "plants: [real]\n";
  EXPECT_THAT(refusal([&] { static_cast<void>(load_sweep(at("y.yaml"), argos)); }),
              ::testing::HasSubstr("the simulator 'box2d' has no 'plants'"));
}

// Quantities are read as everywhere else; seeds have more digits than a double has.
TEST_F(SweepFile, ReadsUnitsAndLongSeeds) {
  std::ofstream(at("a.yaml"))
      << "simulator: ode\ncontrollers: [free]\nterrains: [boxes]\n"
         "roughness: [5cm]\nseeds: [18446744073709551615, 9007199254740993]\n"
         "seconds: 500ms\nrandom_posture: 2cm\n";
  const Sweep sweep = load_sweep(at("a.yaml"), argos);
  EXPECT_EQ(sweep.terrains[0].terrain, "boxes:0.05");
  EXPECT_EQ(sweep.seeds[0], 18446744073709551615U);
  EXPECT_EQ(sweep.seeds[1], 9007199254740993U);
  EXPECT_DOUBLE_EQ(sweep.limits.seconds, 0.5);
  EXPECT_DOUBLE_EQ(sweep.limits.random_posture, 0.02);
}

// Ten things are wrong; each is told with its line and column.
TEST_F(SweepFile, IsRefusedWithAllThatIsWrongAndWhere) {
  const std::string path = at("bad.yaml");
  std::ofstream(path)
      << "simulator: slice\ncontrolers: [free]\ncontrollers: [fre, tripod, tripod]\n"
         "terrains: []\nseeds: -3\nslices: many\nseconds: 3\nroughness: [-1]\n"
         "measure: sped\nseeds: 4\n";
  const std::string text = refusal([&] { static_cast<void>(load_sweep(path, argos)); });
  for (const char* line :
       {":2:1: unknown key of sweep \"controlers\"; did you mean \"controllers\"?",
        ":3:15: unknown controller \"fre\"; did you mean \"free\"?",
        ":3:28: the controller 'tripod' is there twice",
        ":4:11: terrains: is a list of 0; it must be a list such as [flat]",
        ":5:8: seeds: is \"-3\"; it must be a whole number of 1 or more",
        ":6:9: slices: is \"many\"; it must be a whole number from 1 to 1000000000",
        ":7:10: the simulator 'slice' has no 'seconds'",
        ":8:13: roughness: is \"-1\"; it must be a finite number of 0 or more",
        ":9:10: unknown measure \"sped\"; known: speed_units_per_slice",
        ":10:1: the key \"seeds\" stands here a second time"})
    EXPECT_THAT(text, ::testing::HasSubstr(path + line));
  EXPECT_EQ(std::ranges::count(text, '\n'), 9);
}

TEST_F(SweepFile, IsRefusedWhenItIsNone) {
  const auto says = [&](const std::string& text) {
    std::ofstream(at("x.yaml")) << text;
    return refusal([&] { static_cast<void>(load_sweep(at("x.yaml"), argos)); });
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(refusal([&] { static_cast<void>(load_sweep(at("none.yaml"), argos)); }),
              HasSubstr("can't be read"));
  EXPECT_THAT(refusal([&] { static_cast<void>(load_sweep(at(""), argos)); }),
              HasSubstr("is a directory; a sweep file is expected"));
  EXPECT_THAT(says("a: [b"), HasSubstr("x.yaml:1:"));
  EXPECT_THAT(says("- free"), HasSubstr("must be a map"));
  EXPECT_THAT(says(""), HasSubstr("must be a map"));
  EXPECT_THAT(says("simulator: odd"),
              HasSubstr(":1:12: unknown simulator \"odd\"; did you mean \"ode\""));
  const std::string ode = "simulator: ode\ncontrollers: [free]\nseeds: 1\n";
  EXPECT_THAT(says(ode), HasSubstr("sweep: the key \"terrains\" is missing"));
  EXPECT_THAT(says(ode + "terrains: [swamp]"), HasSubstr(":4:12: "));
  EXPECT_THAT(says(ode + "terrains: [boxes]"), HasSubstr("'boxes' lacks its roughness"));
  EXPECT_THAT(says(ode + "terrains: [flat]\nrobots: [nobody]"),
              HasSubstr(":5:10: robot is 'nobody'"));
  EXPECT_THAT(says(ode + "terrains: [boxes:0.1, boxes:0.10]"), HasSubstr("there twice"));
  EXPECT_THAT(says(ode + "terrains: [flat]\nrandom_posture: 0.9"),
              HasSubstr(":5:17: random_posture: is \"0.9\"; it must be a length of 0 to 0."));
  EXPECT_THAT(says("simulator: box2d\ncontrollers: [free]\nseeds: 1\nterrains: [flat]\n"
                   "random_posture: 0.06"),
              HasSubstr("a length of 0 to 0.05 m"));
  EXPECT_THAT(says(ode + "terrains: [flat, [boxes]]"),
              HasSubstr(":4:18: terrains: is a list of 1"));
  EXPECT_THAT(says(ode + "terrains: {a: 1}\nseconds: -1"), HasSubstr(":5:10: seconds: is \"-1\""));
}

}  // namespace
}  // namespace hexagait::sweep
