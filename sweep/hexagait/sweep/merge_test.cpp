// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <sys/resource.h>

#include <hexagait/sweep/detail/scratch_sweep.hpp>
#include <hexagait/sweep/report.hpp>
#include <nlohmann/json.hpp>

namespace hexagait::sweep {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Merging = ScratchSweep;

std::string merged(const std::vector<std::filesystem::path>& parts,
                   const std::filesystem::path& directory) {
  merge(parts, directory);
  std::ifstream stream(directory / "trials.csv", std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// 9 groups per seed and 7 seeds: 21 groups do not divide by 2 or 5.
TEST_F(Merging, OfShardsInAnyOrderGivesTheBytesOfOneProcess) {
  const Sweep sweep = slices(7);
  const std::string whole = run(sweep, "whole");
  run(sweep, "c", 2, {2, 3});
  run(sweep, "a", 1, {0, 3});
  run(sweep, "b", 3, {1, 3});
  EXPECT_EQ(merged({at("b"), at("c"), at("a")}, at("abc")), whole);
  EXPECT_EQ(merged({at("whole")}, at("again")), whole);

  // Halves of a half go with the other half.
  run(sweep, "half", 1, {0, 2});
  run(sweep, "q2", 1, {1, 4});
  run(sweep, "q4", 1, {3, 4});
  EXPECT_EQ(merged({at("q4"), at("half"), at("q2")}, at("uneven")), whole);
  EXPECT_EQ(run(sweep, "uneven"), whole);  // a merged sweep is one that is done
}

TEST_F(Merging, RefusesGapsAndOverlapsAndListsThem) {
  const Sweep sweep = slices(4);  // 36 trials in 12 groups of 3
  run(sweep, "a", 1, {0, 2});
  run(sweep, "b", 1, {1, 2});
  run(sweep, "q", 1, {3, 4});  // groups 3, 7, 11
  const auto refused = [&](const std::vector<std::filesystem::path>& parts) {
    const std::string text = refusal([&] { merge(parts, at("out")); });
    EXPECT_FALSE(std::filesystem::exists(at("out")));
    return text;
  };
  EXPECT_THAT(refused({at("a")}), AllOf(HasSubstr("trials 3 to 5 missing"),
                                        HasSubstr("trials 33 to 35 missing"), HasSubstr("1/2")));
  EXPECT_THAT(refused({at("b"), at("a"), at("q")}),
              AllOf(HasSubstr("trials 9 to 11 there twice: in '" + at("b").string() + "' and '" +
                              at("q").string()),
                    HasSubstr("trials 33 to 35 there twice"), Not(HasSubstr("missing"))));
  EXPECT_THAT(refused({at("a"), at("q")}), HasSubstr("trials 3 to 5 missing"));
  EXPECT_THAT(refused({at("a"), at("none")}), HasSubstr("none"));
}

TEST_F(Merging, RefusesPartsOfDifferentSweeps) {
  Sweep sweep = slices(4);
  run(sweep, "a", 1, {0, 2});
  sweep.master_seed = 2;
  run(sweep, "b", 1, {1, 2});
  EXPECT_THAT(refusal([&] {
                merge({at("a"), at("b")}, at("out"));
              }),
              AllOf(HasSubstr("different sweeps"), HasSubstr("seeds.master: 1 against 2"),
                    Not(HasSubstr("shard:"))));
  EXPECT_THAT(refusal([&] { merge({at("a"), at("b")}, at("a")); }), HasSubstr("one of the parts"));
}

// One message names the field, wherever in the header it is.
TEST_F(Merging, RefusesPartsOfDifferentPhysicsNamingTheField) {
  const Sweep sweep = slices(4);
  run(sweep, "a", 1, {0, 2});
  run(sweep, "b", 1, {1, 2});
  const std::string journal = content(journal_path(at("b")));
  const std::size_t end = journal.find('\n');
  auto header = nlohmann::ordered_json::parse(journal.substr(17, end - 17));
  header["libraries"]["Eigen"] = "2.0";
  header["physics"]["friction"] = 0.5;
  std::ofstream(journal_path(at("b")), std::ios::binary)
      << journal_header(header.dump()) << journal.substr(end + 1);
  EXPECT_THAT(
      refusal([&] {
        merge({at("a"), at("b")}, at("out"));
      }),
      AllOf(HasSubstr("libraries.Eigen: \""), HasSubstr("against \"2.0\""),
            HasSubstr("physics: nothing against {\"friction\":0.5}"), Not(HasSubstr("compiler"))));
}

// Slices know no ODE: machines with unlike ones make the same rows of them.
TEST_F(Merging, ComparesOnlyTheSimulatorsThatTookPart) {
  run(slices(1), "a");
  const std::string header = JournalReader(at("a")).header();
  EXPECT_THAT(header,
              AllOf(HasSubstr("\"Eigen\""), Not(HasSubstr("ODE")), Not(HasSubstr("Box2D"))));
}

TEST_F(Merging, NeedsNoMoreDescriptorsThanAFewHoweverManyTheParts) {
  const Sweep sweep = slices(4);  // 12 groups
  std::vector<std::filesystem::path> parts;
  for (std::uint64_t k = 0; k < 12; ++k) {
    parts.push_back(at("part" + std::to_string(k)));
    run(sweep, "part" + std::to_string(k), 1, {k, 12});
  }
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  rlimit few = before;
  few.rlim_cur = 10;
  setrlimit(RLIMIT_NOFILE, &few);
  const std::string whole = merged(parts, at("whole"));
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_EQ(whole, run(sweep, "one"));
}

// A journal that was cut within its last line lacks that trial. A line that was changed is reported
// by its number.
TEST_F(Merging, RefusesAJournalThatIsCutOrChanged) {
  const Sweep sweep = slices(4);
  run(sweep, "a");
  const std::filesystem::path path = journal_path(at("a"));
  const std::string journal = content(path);
  std::ofstream(path, std::ios::binary) << journal.substr(0, journal.size() - 5);
  EXPECT_THAT(refusal([&] { merge({at("a")}, at("out")); }), HasSubstr("trial 35 missing"));

  std::string changed = journal;
  changed[journal.find('\n') + 40] ^= 1;
  std::ofstream(path, std::ios::binary) << changed;
  EXPECT_THAT(refusal([&] { merge({at("a")}, at("out")); }), HasSubstr("journal.txt:2: damaged"));

  std::ofstream(path, std::ios::binary) << journal << journal.substr(journal.find('\n') + 1);
  EXPECT_THAT(refusal([&] { merge({at("a")}, at("out")); }), HasSubstr("is there twice"));
}

using JournalOrder = ScratchSweep;

// Lines in reverse, as far apart as the window allows, come out in order.
TEST_F(JournalOrder, IsRestoredWithinTheWindow) {
  {
    Journal journal(journal_path(at("")));
    journal.resume("{}", 0);
    for (std::uint64_t block = 0; block < 3; ++block) {
      std::string text;
      for (std::uint64_t k = kWindow; k-- > 0;) {
        const std::uint64_t position = block * kWindow + k;
        text += journal_line(position, "0.1", std::to_string(position) + ",x");
      }
      ASSERT_FALSE(journal.append(text));
    }
  }
  JournalReader reader(at(""));
  std::uint64_t expected = 0;
  while (const auto entry = reader.next()) ASSERT_EQ(entry->position, expected++);
  EXPECT_EQ(expected, 3 * kWindow);
}

TEST_F(JournalOrder, KnowsWhatIsDoneWithinTheWindow) {
  DoneWindow done;
  for (const std::uint64_t p : {2U, 1U, 65535U}) done.mark(p);
  EXPECT_EQ(done.low(), 0U);
  EXPECT_TRUE(done.done(65535) && done.done(1) && !done.done(0) && !done.done(65536));
  done.mark(0);
  EXPECT_EQ(done.low(), 3U);
  EXPECT_TRUE(done.done(0) && done.done(65535) && !done.done(65536) && !done.done(3));
}

class Reporting : public ScratchSweep {
 protected:
  static constexpr const char* kHead =
      "trial,controller,robot,plant,terrain,roughness,seed,outcome,reason,";

  // A sweep whose trials.csv is replaced.
  void rows(const std::string& text) {
    if (!std::filesystem::exists(at("a"))) run(slices(1), "a");
    std::ofstream(at("a") / "trials.csv") << kHead << "speed_units_per_slice,fraction_of_bound\n"
                                          << text;
  }
  [[nodiscard]] Report report(const ReportOptions& options = {}) const {
    return make_report(at("a"), options);
  }
};

// The mean of a column by hand, and that of the differences, which is the difference of the means.
TEST_F(Reporting, AveragesAndComparesPairwise) {
  const Sweep sweep = slices(20);
  run(sweep, "a");
  double sum[2] = {};
  for (std::uint64_t k = 0; k < 60; ++k) {  // the first terrain
    std::istringstream cells(row(sweep, k));
    std::string cell;
    for (int i = 0; i < 10; ++i) std::getline(cells, cell, ',');
    if (k % 3 < 2) sum[k % 3] += std::stod(cell) / 20.0;
  }
  const Report of = report();
  ASSERT_EQ(of.lines.size(), 9U);
  EXPECT_EQ(of.first, "tripod");
  EXPECT_NEAR(of.lines[0].value->value, sum[0], 1e-12);
  EXPECT_NEAR(of.lines[1].value->value, sum[1], 1e-12);
  EXPECT_NEAR(of.lines[1].difference->difference.value, sum[1] - sum[0], 1e-12);
  EXPECT_NEAR(*of.lines[1].difference->percent, 100.0 * (sum[1] / sum[0] - 1.0), 1e-9);
  EXPECT_EQ(of.lines[1].difference->count, 20);
  EXPECT_FALSE(of.lines[0].difference);
}

// Seed 7 of the second controller is missing, and the rows are shuffled: 3 − 1 and 10 − 5.
TEST_F(Reporting, PairsBySeedWhateverTheOrderAndWhateverIsMissing) {
  rows(
      "5,free,r,ideal,flat,0,9,walked,,10,\n"
      "0,tripod,r,ideal,flat,0,8,walked,,1,\n"
      "2,tripod,r,ideal,flat,0,7,walked,,100,\n"
      "1,free,r,ideal,flat,0,8,walked,,3,\n"
      "4,tripod,r,ideal,flat,0,9,walked,,5,\n");
  const Report of = report();
  EXPECT_EQ(of.first, "free");
  const Compared& difference = *of.lines[1].difference;
  EXPECT_EQ(difference.count, 2);
  EXPECT_DOUBLE_EQ(difference.difference.value, -3.5);
  EXPECT_DOUBLE_EQ(*difference.percent, -100.0 * 3.5 / 6.5);
}

TEST_F(Reporting, RefusesADamagedTableWithItsLine) {
  const std::string good = "0,free,r,ideal,flat,0,1,walked,,3,\n";
  const auto says = [&](const std::string& text) {
    rows(good + text);
    return refusal([&] { static_cast<void>(report()); });
  };
  EXPECT_THAT(says("1,free,r,ideal,flat,0,2\n"),
              HasSubstr("trials.csv:3: has 7 cells, the header 11"));
  EXPECT_THAT(says("1,free,r,ideal,flat,0,2,walked,,fast,\n"),
              HasSubstr(":3: the column 'speed_units"));
  EXPECT_THAT(says("1,free,r,ideal,flat,0,x,walked,,3,\n"),
              HasSubstr(":3: the column 'seed' has 'x'"));
  EXPECT_THAT(says("1,free,r,ideal,flat,0,2,flew,,3,\n"),
              HasSubstr("the column 'outcome' has 'flew'"));
  EXPECT_THAT(says(good),
              HasSubstr("'free' with 'r', 'ideal' on 'flat' and seed 1 is there twice"));
  rows("");
  EXPECT_THAT(refusal([&] { static_cast<void>(report()); }), HasSubstr("has no trials"));
  std::ofstream(at("a") / "trials.csv") << "trial,speed_units_per_slice\n";
  EXPECT_THAT(refusal([&] { static_cast<void>(report()); }),
              HasSubstr("there is no column 'robot'"));
}

// A robot that fell in the first second was fast: it counts among the falls, not in the mean.
TEST_F(Reporting, CountsFallsApartUnlessAllTrialsAreAskedFor) {
  rows(
      "0,free,r,ideal,flat,0,1,walked,,1,\n1,free,r,ideal,flat,0,2,late,,3,\n2,free,r,ideal,flat,0,"
      "3,fell,,50,"
      "\n"
      "3,free,r,ideal,flat,0,4,stuck,,0,\n4,free,r,ideal,flat,0,5,timed_out,it took longer,,\n");
  const Report of = report();
  EXPECT_DOUBLE_EQ(of.lines[0].value->value, 2.0);
  EXPECT_THAT(in_words(of), AllOf(HasSubstr("2/5"), HasSubstr("1 fell, 1 stuck, 1 timed_out")));
  const auto json = nlohmann::json::parse(to_json(of));
  EXPECT_EQ(json["lines"][0]["outcomes"]["fell"], 1);
  EXPECT_EQ(json["lines"][0]["outcomes"]["walked"], 1);
  EXPECT_DOUBLE_EQ(report({.all_trials = true}).lines[0].value->value, 13.5);
}

// No fall in 20 trials is a proportion of at most 16 %, not 0 ± 0.
TEST_F(Reporting, GivesProportionsAnIntervalThatIsNeverEmpty) {
  Sweep sweep;
  sweep.engine = Engine::box2d;
  sweep.controllers = {*gait_state::parse_gait_choice("free")};
  sweep.robots.push_back({.name = "genghis2d", .model = {}});
  sweep.terrains = {ground(Engine::box2d, "flat")};
  sweep.num_seeds = 1;
  sweep.limits.seconds = 0.1;
  sweep.measure = "fell";
  run(sweep, "a");
  std::string text = std::string(kHead) + "fell\n";
  for (int seed = 0; seed < 20; ++seed)
    text +=
        fmt::format("0,free,r,ideal,flat,0,{0},walked,,0\n1,tripod,r,ideal,flat,0,{0},{1},,{2}\n",
                    seed, seed < 5 ? "fell" : "walked", seed < 5 ? 1 : 0);
  std::ofstream(at("a") / "trials.csv") << text;
  const Report of = report();
  EXPECT_EQ(of.lines[0].value->value, 0.0);
  EXPECT_NEAR(of.lines[0].value->upper, 0.161, 1e-3);
  EXPECT_EQ(of.lines[1].value->count, 20);  // falls are what is counted
  EXPECT_NEAR(of.lines[1].value->value, 0.25, 1e-12);
  EXPECT_GT(of.lines[1].difference->difference.lower, 0.0);
  EXPECT_THAT(in_words(of), AllOf(HasSubstr("0 % (0 to 16 %)"), HasSubstr("25 % (")));
}

// Terrains have their own seeds: the difference of the means, without pairs.
TEST_F(Reporting, ComparesTerrainsAndRobotsToo) {
  run(slices(20), "a");
  const Report of = report({.compare = Compare::terrains});
  EXPECT_EQ(of.first, "flat");
  EXPECT_FALSE(of.paired);
  EXPECT_FALSE(of.lines[1].difference);  // free on flat ground
  EXPECT_EQ(of.lines[4].terrain, "descent:3-7");
  EXPECT_NEAR(of.lines[4].difference->difference.value,
              of.lines[4].value->value - of.lines[1].value->value, 1e-12);
  EXPECT_THAT(in_words(of), AllOf(HasSubstr("less flat"), HasSubstr("not paired")));

  rows("0,free,a,ideal,flat,0,1,walked,,4,\n1,free,b,ideal,flat,0,1,walked,,5,\n");
  const Report robots = report({.compare = Compare::robots});
  EXPECT_TRUE(robots.paired);
  EXPECT_DOUBLE_EQ(*robots.lines[1].difference->percent, 25.0);
}

// The same seeds on the same terrain: pairs. A table of imperfect plants names them.
TEST_F(Reporting, ComparesPlantsPairwise) {
  rows(
      "0,free,r,ideal,flat,0,1,walked,,4,\n1,free,r,ideal,flat,0,2,walked,,6,\n"
      "2,free,r,real,flat,0,2,walked,,3,\n3,free,r,real,flat,0,1,walked,,2,\n");
  const Report of = report({.compare = Compare::plants});
  EXPECT_TRUE(of.paired);
  EXPECT_EQ(of.lines[1].plant, "real");
  EXPECT_DOUBLE_EQ(of.lines[1].difference->difference.value, -2.5);
  EXPECT_EQ(of.lines[1].difference->count, 2);
  EXPECT_THAT(in_words(of), AllOf(HasSubstr("less ideal"), HasSubstr("  real ")));
  EXPECT_EQ(nlohmann::json::parse(to_json(of))["lines"][1]["plant"], "real");
}

// A wave gait never becomes a tripod: its cells are empty, and no mean is made of them.
TEST_F(Reporting, TellsHowManyTrialsHaveAValue) {
  run(slices(20, 200), "a");
  const Report of = report({.measure = "tripod_after_slices"});
  EXPECT_FALSE(of.lines[2].value);
  EXPECT_EQ(of.lines[2].trials(), 20);
  EXPECT_EQ(of.lines[1].value->count, 20);
  EXPECT_THAT(in_words(of), AllOf(HasSubstr("0/20"), HasSubstr("none")));
  EXPECT_THAT(to_json(of), HasSubstr("\"difference\": null"));
}

TEST(WithError, RoundsToWhatTheErrorLeaves) {
  EXPECT_EQ(with_error(0.067381, 0.0052), "0.067 ± 0.005");
  EXPECT_EQ(with_error(0.067381, 0.0012), "0.0674 ± 0.0012");
  EXPECT_EQ(with_error(-3.14159, 0.2), "-3.1 ± 0.2");
  EXPECT_EQ(with_error(1234.5, 56.0), "1230 ± 60");
  EXPECT_EQ(with_error(12.0, 0.0), "12 ± 0");
  EXPECT_EQ(with_error(1.0, 1.3e-16), "1 ± 0");
  EXPECT_EQ(with_error(0.5, std::numeric_limits<double>::infinity()), "0.5");
}

TEST_F(Reporting, RefusesAMeasureThatIsNone) {
  run(slices(2), "a");
  EXPECT_THAT(refusal([&] { static_cast<void>(report({.measure = "speed"})); }),
              HasSubstr("did you mean 'speed_units_per_slice'"));
  EXPECT_THAT(refusal([&] { static_cast<void>(report({.measure = "hash"})); }),
              HasSubstr("not a number"));
  EXPECT_THAT(refusal([&] { static_cast<void>(make_report(at("b"), {})); }),
              HasSubstr("not the directory of a sweep"));
}

TEST_F(Reporting, DrawsAFigureAndKeepsWhatItIsMadeOf) {
  run(slices(3), "a");
  draw(report(), "Speed");
  draw(report({.measure = "steps"}), "");
  for (const char* stem : {"report-speed_units_per_slice", "report-steps"})
    for (const char* suffix : {".svg", ".pdf", ".png", ".gp", ".csv"})
      EXPECT_GT(std::filesystem::file_size(at("a") / (std::string(stem) + suffix)), 100U) << stem;
  EXPECT_THAT(content(at("a") / "report-speed_units_per_slice.svg"),
              AllOf(HasSubstr("speed [units per slice]"), HasSubstr("wave:0.75")));
  EXPECT_THAT(content(at("a") / "report-steps.svg"), Not(HasSubstr("confidence")));
}

}  // namespace
}  // namespace hexagait::sweep
