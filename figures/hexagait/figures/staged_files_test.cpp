// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <functional>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <iterator>

namespace hexagait::figures {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class StagedFilesTest : public ::testing::Test {
 protected:
  StagedFilesTest() {
    std::string pattern = ::testing::TempDir() + "hexagait-staged-XXXXXX";
    root_ = mkdtemp(pattern.data());
  }
  ~StagedFilesTest() override { fs::remove_all(root_); }

  [[nodiscard]] std::string content(const std::string& name) const {
    std::ifstream file(root_ / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] auto entries() const {
    return std::distance(fs::directory_iterator(root_), fs::directory_iterator());
  }

  fs::path root_;
};

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(StagedFilesTest, AppearOnlyWhenTheyArePublished) {
  std::ofstream(root_ / "a.csv") << "old";
  StagedFiles files(root_);
  files.write("a.csv", "new");
  files.create("b.csv") << "b";
  EXPECT_EQ(content("a.csv"), "old");
  EXPECT_FALSE(fs::exists(root_ / "b.csv"));
  files.publish();
  EXPECT_EQ(content("a.csv"), "new");
  EXPECT_EQ(content("b.csv"), "b");
}

TEST_F(StagedFilesTest, LeaveNothingBehindIfTheyAreNotPublished) {
  {
    StagedFiles files(root_);
    files.write("a.csv", "a");
    StagedFiles moved(std::move(files));
    moved.write("b.csv", "b");
    EXPECT_GT(entries(), 0);
  }
  EXPECT_EQ(entries(), 0);
}

TEST_F(StagedFilesTest, DoNotReplaceADirectory) {
  fs::create_directory(root_ / "taken");
  StagedFiles files(root_);
  EXPECT_THAT(message_of([&] { files.write("taken", ""); }),
              AllOf(HasSubstr((root_ / "taken").string()), HasSubstr("is not a file")));
}

TEST_F(StagedFilesTest, NeedADirectoryThatExists) {
  EXPECT_THAT(message_of([&] { StagedFiles files(root_ / "missing"); }),
              AllOf(HasSubstr((root_ / "missing").string()), HasSubstr("No such file")));
}

// /dev/full takes a write and finds no room for it.
TEST_F(StagedFilesTest, NameTheFileForWhichTheDiskHasNoRoom) {
  StagedFiles files(root_);
  fs::create_symlink("/dev/full", files.staging() / "a.csv");
  EXPECT_THAT(message_of([&] { files.write("a.csv", "a"); }),
              AllOf(HasSubstr((root_ / "a.csv").string()), HasSubstr("No space left")));
}

// FNV-1a of "a", 64 bits, from the list of its authors.
TEST_F(StagedFilesTest, AreHashedByTheirBytes) {
  StagedFiles files(root_);
  files.write("a.csv", "a");
  EXPECT_EQ(files.hash("a.csv"), 0xaf63dc4c8601ec8cU);
}

}  // namespace
}  // namespace hexagait::figures
