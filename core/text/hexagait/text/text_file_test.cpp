// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/text_file.hpp>

namespace hexagait {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class TextFile : public ::testing::Test {
 protected:
  TextFile() { std::ofstream(path_) << "four"; }
  ~TextFile() override { std::filesystem::remove(path_); }
  const std::string path_ = ::testing::TempDir() + "text-" + std::to_string(getpid());
};

TEST_F(TextFile, IsReadUpToTheLargestSize) {
  EXPECT_EQ(read_text(path_, 4), "four");
  EXPECT_THAT([&] { (void)read_text(path_, 3); },
              ThrowsMessage<InvalidInput>(HasSubstr("more than 3 bytes")));
}

TEST_F(TextFile, ThatCannotBeReadSaysWhyAndWhatIsExpected) {
  EXPECT_THAT(
      [] { (void)read_text("/no/such/file", 9, "a URDF"); },
      ThrowsMessage<InvalidInput>("/no/such/file: can't be read: No such file or directory; "
                                  "a URDF is expected"));
  EXPECT_THAT([] { (void)read_text("/", 9); },
              ThrowsMessage<InvalidInput>("/: is a directory; a YAML file is expected"));
}

TEST_F(TextFile, WithoutThePermissionToReadSaysSo) {
  if (geteuid() == 0) GTEST_SKIP() << "the superuser may read everything";
  std::filesystem::permissions(path_, std::filesystem::perms::none);
  EXPECT_THAT([&] { (void)read_text(path_, 9); },
              ThrowsMessage<InvalidInput>(HasSubstr("Permission denied")));
}

}  // namespace
}  // namespace hexagait
