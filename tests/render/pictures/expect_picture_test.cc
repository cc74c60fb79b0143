// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/render/pictures/expect_picture.h"

#include <gtest/gtest-spi.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

Picture Plain(std::uint8_t level) { return {4, 3, std::vector<std::uint8_t>(36, level)}; }

class ExpectPictureTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folders_.baselines); }

  const TemporaryFolder folder_;
  const PictureFolders folders_{folder_.Path("baselines"), folder_.Path("results")};
};

TEST_F(ExpectPictureTest, AcceptsTheBaseline) {
  WritePng(Plain(100), folders_.baselines + "/case.png");
  ExpectPicture(Plain(100), "case", folders_);
}

TEST_F(ExpectPictureTest, WithoutABaselineFailsAndLeavesTheCandidate) {
  EXPECT_NONFATAL_FAILURE(ExpectPicture(Plain(100), "case", folders_), "no baseline");
  EXPECT_EQ(ReadPng(folders_.results + "/case.png"), Plain(100));
}

TEST_F(ExpectPictureTest, OnADifferenceFailsAndLeavesAllThreePictures) {
  WritePng(Plain(100), folders_.baselines + "/case.png");
  EXPECT_NONFATAL_FAILURE(ExpectPicture(Plain(120), "case", folders_), "by up to 20 levels");
  EXPECT_EQ(ReadPng(folders_.results + "/case.actual.png"), Plain(120));
  EXPECT_EQ(ReadPng(folders_.results + "/case.expected.png"), Plain(100));
  EXPECT_EQ(ReadPng(folders_.results + "/case.difference.png"), Plain(160));
}

}  // namespace
}  // namespace loopscope
