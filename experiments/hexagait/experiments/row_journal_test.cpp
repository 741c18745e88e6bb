// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/experiments/row_journal.hpp>

namespace hexagait::experiments {
namespace {

namespace fs = std::filesystem;

class RowJournals : public ::testing::Test {
 protected:
  RowJournals() { fs::remove(file_); }
  ~RowJournals() override { fs::remove(file_); }
  const fs::path file_ =
      fs::temp_directory_path() /
      ("hexagait-journal-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
       ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(RowJournals, GoOnWhereTheyEnded) {
  {
    RowJournal journal(file_, "key 1");
    journal.add(3, "third row");
    journal.add(1, "first row");
  }
  const RowJournal journal(file_, "key 1");
  EXPECT_EQ(journal.rows(),
            (std::map<std::uint64_t, std::string>{{1, "first row"}, {3, "third row"}}));
}

// A killed process may leave half a row.
TEST_F(RowJournals, LeaveOutWhatWasNotWrittenToItsEnd) {
  {
    RowJournal journal(file_, "key");
    journal.add(1, "whole");
  }
  std::ofstream(file_, std::ios::app) << "2 hal";
  EXPECT_EQ(RowJournal(file_, "key").rows().size(), 1U);
}

TEST_F(RowJournals, BeginAnewWithAnotherKey) {
  {
    RowJournal journal(file_, "key 1");
    journal.add(1, "row");
  }
  EXPECT_TRUE(RowJournal(file_, "key 12").rows().empty());
  EXPECT_TRUE(RowJournal(file_, "key 1").rows().empty());
}

TEST_F(RowJournals, AreGoneWhenRemoved) {
  RowJournal journal(file_, "key");
  journal.remove();
  EXPECT_FALSE(fs::exists(file_));
}

}  // namespace
}  // namespace hexagait::experiments
