// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <hexagait/sim/random.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <vector>

namespace hexagait {
namespace {

using Words = std::vector<std::string>;

// kitten → sitten → sittin → sitting: two letters exchanged, one put in. Neighbours that are swapped
// are one mistake.
TEST(WordDistance, CountsLettersPutInLeftOutExchangedAndSwapped) {
  EXPECT_EQ(word_distance("kitten", "sitting"), 3);
  EXPECT_EQ(word_distance("hieght", "height"), 1);
  EXPECT_EQ(word_distance("wlak", "walk"), 1);
  EXPECT_EQ(word_distance("", "abc"), 3);
  EXPECT_EQ(word_distance("abc", ""), 3);
  EXPECT_EQ(word_distance("abc", "abc"), 0);
}

// The definition itself, without a table.
int distance_by_recursion(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return static_cast<int>(a.size() + b.size());
  const auto rest = [&](std::size_t i, std::size_t j) {
    return distance_by_recursion(a.substr(i), b.substr(j));
  };
  const int least = std::min({1 + rest(1, 0), 1 + rest(0, 1), (a[0] == b[0] ? 0 : 1) + rest(1, 1)});
  const bool swapped = a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0];
  return swapped ? std::min(least, 1 + rest(2, 2)) : least;
}

TEST(WordDistance, IsThatOfItsDefinitionOnRandomWords) {
  RandomSequence random{.seed = 1};
  const auto word = [&] {
    std::string letters(static_cast<std::size_t>(random.uniform(0.0, 7.0)), 'a');
    for (char& letter : letters) letter = random.u01() < 0.5 ? 'a' : 'b';
    return letters;
  };
  for (int k = 0; k < 300; ++k) {
    const std::string a = word(), b = word();
    EXPECT_EQ(word_distance(a, b), distance_by_recursion(a, b)) << a << " " << b;
    EXPECT_EQ(word_distance(a, b), word_distance(b, a));
  }
}

TEST(NearestWord, IsTheOneThatWasProbablyMeant) {
  const Words known = {"height", "duration", "profile_type", "profile_height"};
  EXPECT_EQ(nearest_word("hieght", known), "height");
  EXPECT_EQ(nearest_word("Duration", known), "duration");
  EXPECT_EQ(nearest_word("profile_heigth", known), "profile_height");
}

TEST(NearestWord, MayBeMeantByItsBeginning) {
  const Words known = {"dura", "profile_type", "profile_height"};
  EXPECT_EQ(nearest_word("pro", known), "profile_type");
  EXPECT_EQ(nearest_word("pr", known), std::nullopt);
}

// Of six letters two may be wrong, three not.
TEST(NearestWord, IsNoneIfMoreThanAThirdOfTheLettersAreWrong) {
  const Words known = {"height"};
  EXPECT_EQ(nearest_word("heixxt", known), "height");
  EXPECT_EQ(nearest_word("hexxxt", known), std::nullopt);
  EXPECT_EQ(nearest_word("", known), std::nullopt);
  EXPECT_EQ(nearest_word("height", {}), std::nullopt);
  EXPECT_EQ(nearest_word(std::string(65, 'a'), Words{std::string(65, 'a')}), std::nullopt);
}

}  // namespace
}  // namespace hexagait
