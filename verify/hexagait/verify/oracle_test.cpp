// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <hexagait/verify/detail/theorems.hpp>
#include <map>
#include <set>
#include <string>

// The theorems once more, for the abstract rule `< a >` -> `> a <` on strings: nothing here is the
// library's. Legs stand in ring order, leg k between relations k − 1 and k.
namespace hexagait::verify {
namespace {

struct Model {
  std::string state = "<><><>";
  std::array<int, 6> air{};
  std::array<bool, 6> slipped{};
  auto operator<=>(const Model&) const = default;
};

bool is_inside(const std::string& s, std::size_t k) { return s[(k + 5) % 6] == '<' && s[k] == '>'; }

Model advanced(Model m, int step_time) {
  for (std::size_t k = 0; k < 6; ++k) {
    if (m.air[k] == 1 && !m.slipped[k]) std::swap(m.state[(k + 5) % 6], m.state[k]);
    if (m.air[k] > 0 && --m.air[k] == 0) m.slipped[k] = false;
  }
  const auto air = m.air;
  for (std::size_t k = 0; k < 6; ++k)
    if (is_inside(m.state, k) && air[(k + 5) % 6] + air[k] + air[(k + 1) % 6] == 0)
      m.air[k] = step_time;
  return m;
}

// Slices until the first situation that comes back, from the first slice's lifts.
int transient(Model m, int step_time) {
  std::map<Model, int> seen;
  int slice = 0;
  for (m = advanced(m, step_time); seen.emplace(m, slice).second; ++slice)
    m = advanced(m, step_time);
  const std::set<std::string> tripod = {"<><><>", "><><><"};
  EXPECT_TRUE(tripod.contains(m.state)) << m.state;
  return seen[m];
}

// All 20 * 4^6 situations of T = 3: 81 920, the slowest after 8 slices.
TEST(Oracle, ConvergesFromAsManySituationsAsSlowly) {
  constexpr int kStepTime = 3;
  int situations = 0, worst = 0;
  std::string state = "<<<>>>";
  do {
    for (int code = 0; code < 1 << 12; ++code) {
      Model m{.state = state, .air = {}, .slipped = {}};
      for (std::size_t k = 0; k < 6; ++k) {
        m.air[k] = code >> (2 * k) & 3;
        m.slipped[k] = m.air[k] > 0 && !is_inside(state, k);
      }
      worst = std::max(worst, transient(m, kStepTime));
      ++situations;
    }
  } while (std::next_permutation(state.begin(), state.end()));

  const Theorem theorem =
      convergence({}, {.legs = {6}, .step_time = 3, .step_time_8 = 0}, [](double) {});
  for (const auto& row : theorem.table.rows) {
    if (row[1] != CaseValue("all") || row[2] != CaseValue(std::int64_t{kStepTime})) continue;
    EXPECT_EQ(row[3], CaseValue(std::int64_t{situations}));
    EXPECT_EQ(row[4], CaseValue(std::int64_t{worst}));
  }
  EXPECT_EQ(situations, 81'920);
  EXPECT_EQ(worst, 8);
}

// As the paper words it: `> > <` and `> < <` replace each other until three are `<`.
TEST(Oracle, AdjustsEveryStateWithoutMovingAPair) {
  for (int bits = 1; bits < 63; ++bits) {
    std::string state;
    for (int k = 0; k < 6; ++k) state += (bits >> k & 1) != 0 ? '<' : '>';
    const std::string before = state;
    for (auto less = std::ranges::count(state, '<'); less != 3;
         less = std::ranges::count(state, '<')) {
      std::size_t k = 0;
      const std::string pattern = less < 3 ? ">><" : "><<";
      while (k < 6 && (state + state).substr(k, 3) != pattern) ++k;
      ASSERT_LT(k, 6U) << "no rule applies to " << state;
      state[(k + 1) % 6] = less < 3 ? '<' : '>';
    }
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(is_inside(state, k), is_inside(before, k));
  }
}

}  // namespace
}  // namespace hexagait::verify
