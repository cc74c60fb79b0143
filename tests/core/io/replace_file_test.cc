// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/replace_file.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::HasSubstr;

TEST(ReplaceFile, LeavesOnlyTheNewContent) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("a.txt", "something longer than the new content");
  ReplaceFile(path, "new");
  EXPECT_EQ(ContentOf(path), "new");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(ReplaceFile, WritesThroughALink) {
  const TemporaryFolder folder;
  const std::string target = folder.Write("target.txt", "old");
  std::filesystem::create_symlink(target, folder.Path("link.txt"));
  ReplaceFile(folder.Path("link.txt"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.Path("link.txt")));
  EXPECT_EQ(ContentOf(target), "new");
}

TEST(ReplaceFile, ThrowsOneLineWhereThereIsNoFolder) {
  const TemporaryFolder folder;
  const std::string message = MessageOf([&] { ReplaceFile(folder.Path("none/a.txt"), "new"); });
  EXPECT_EQ(message, folder.Path("none/a.txt") + ": cannot be written: No such file or directory");
}

TEST(ReplaceFile, ThrowsWhereTheDeviceIsFull) {
  EXPECT_THAT(MessageOf([] { ReplaceFile("/dev/full", "new"); }), HasSubstr("No space left"));
}

TEST(ReplaceFile, LeavesTheOldContentIfItFails) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("a.txt", "old");
  std::filesystem::create_directory(path + ".part");  // in the way, for root too
  EXPECT_THAT(MessageOf([&] { ReplaceFile(path, "new"); }), HasSubstr("cannot be written"));
  EXPECT_EQ(ContentOf(path), "old");
}

}  // namespace
}  // namespace loopscope
