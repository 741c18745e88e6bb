// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>

#include <hexagait/sweep/report.hpp>
#include <nlohmann/json.hpp>

#include "scratch_sweep.hpp"

namespace hexagait::sweep {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
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
  header["libraries"]["ODE"] = "0.13";
  header["physics"]["friction"] = 0.5;
  std::ofstream(journal_path(at("b")), std::ios::binary)
      << journal_header(header.dump()) << journal.substr(end + 1);
  EXPECT_THAT(
      refusal([&] {
        merge({at("a"), at("b")}, at("out"));
      }),
      AllOf(HasSubstr("libraries.ODE: \""), HasSubstr("against \"0.13\""),
            HasSubstr("physics: nothing against {\"friction\":0.5}"), Not(HasSubstr("compiler"))));
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

// The end of the journal is cut in a line: that trial is missing. A line within it that was changed
// is told by its number.
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
    Journal journal(at(""));
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

using Reporting = ScratchSweep;

// The mean of a column by hand, and that of the differences, which is the difference of the means.
TEST_F(Reporting, AveragesAndComparesPairwise) {
  const Sweep sweep = slices(20);
  run(sweep, "a");
  double sum[2] = {};
  for (std::uint64_t k = 0; k < 60; ++k) {  // the first terrain
    std::istringstream cells(row(sweep, k));
    std::string cell;
    for (int i = 0; i < 9; ++i) std::getline(cells, cell, ',');
    if (k % 3 < 2) sum[k % 3] += std::stod(cell) / 20.0;
  }
  const Report report = make_report(at("a"), "");
  ASSERT_EQ(report.lines.size(), 9U);
  EXPECT_EQ(report.first, "tripod");
  EXPECT_NEAR(report.lines[0].value->mean, sum[0], 1e-12);
  EXPECT_NEAR(report.lines[1].value->mean, sum[1], 1e-12);
  EXPECT_NEAR(report.lines[1].difference->mean, sum[1] - sum[0], 1e-12);
  EXPECT_EQ(report.lines[1].difference->count, 20);
  EXPECT_FALSE(report.lines[0].difference);
}

// A wave gait never becomes a tripod: its cells are empty, and no mean is made of them.
TEST_F(Reporting, TellsHowManyTrialsHaveAValue) {
  run(slices(20, 200), "a");
  const Report report = make_report(at("a"), "tripod_after_slices");
  EXPECT_FALSE(report.lines[2].value);
  EXPECT_EQ(report.lines[2].trials, 20);
  EXPECT_EQ(report.lines[1].value->count, 20);
  EXPECT_THAT(in_words(report), AllOf(HasSubstr("0/20"), HasSubstr("none")));
  EXPECT_THAT(to_json(report), HasSubstr("\"difference\": null"));
}

TEST_F(Reporting, RefusesAMeasureThatIsNone) {
  run(slices(2), "a");
  EXPECT_THAT(refusal([&] { static_cast<void>(make_report(at("a"), "speed")); }),
              HasSubstr("did you mean 'speed_units_per_slice'"));
  EXPECT_THAT(refusal([&] { static_cast<void>(make_report(at("a"), "hash")); }),
              HasSubstr("not a number"));
  EXPECT_THAT(refusal([&] { static_cast<void>(make_report(at("b"), "")); }),
              HasSubstr("not the directory of a sweep"));
}

TEST_F(Reporting, DrawsAFigureAndKeepsWhatItIsMadeOf) {
  run(slices(3), "a");
  draw(make_report(at("a"), ""));
  for (const char* name : {"report.svg", "report.pdf", "report.png", "report.gp", "report.csv"})
    EXPECT_GT(std::filesystem::file_size(at("a") / name), 100U) << name;
}

}  // namespace
}  // namespace hexagait::sweep
