// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/picture_comparison.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

Picture Plain(int width, int height, std::uint8_t level) {
  return {width, height, std::vector<std::uint8_t>(3 * width * height, level)};
}

TEST(CompareTest, APictureEqualsItself) {
  const PictureComparison result = Compare(Plain(20, 10, 90), Plain(20, 10, 90));
  EXPECT_TRUE(result.equal);
  EXPECT_EQ(result.max_difference, 0);
  EXPECT_EQ(result.differing_share, 0.0);
}

TEST(CompareTest, AFewLevelsEverywhereAreTolerated) {
  const PictureComparison result = Compare(Plain(20, 10, 90), Plain(20, 10, 96), {6, 0.0});
  EXPECT_TRUE(result.equal);
  EXPECT_EQ(result.max_difference, 6);
  EXPECT_FALSE(Compare(Plain(20, 10, 90), Plain(20, 10, 97), {6, 0.0}).equal);
}

TEST(CompareTest, AsManyPixelsMayDifferAsTheToleranceSays) {
  const Picture expected = Plain(10, 10, 0);
  Picture actual = expected;
  for (const int pixel : {3, 41}) actual.rgb[3 * pixel + 1] = 200;
  EXPECT_DOUBLE_EQ(Compare(actual, expected).differing_share, 0.02);
  EXPECT_TRUE(Compare(actual, expected, {6, 0.02}).equal);
  EXPECT_FALSE(Compare(actual, expected, {6, 0.019}).equal);
}

TEST(CompareTest, APixelCountsOnceHoweverManyOfItsChannelsDiffer) {
  const Picture expected = Plain(10, 10, 0);
  Picture actual = expected;
  for (int channel = 0; channel < 3; ++channel) actual.rgb[3 * 7 + channel] = 100;
  EXPECT_DOUBLE_EQ(Compare(actual, expected).differing_share, 0.01);
}

TEST(CompareTest, PicturesOfDifferentSizesAreNeverEqual) {
  const PictureComparison result = Compare(Plain(20, 10, 90), Plain(10, 20, 90), {255, 1.0});
  EXPECT_FALSE(result.same_size);
  EXPECT_FALSE(result.equal);
}

TEST(DifferencePictureTest, ShowsWhereAndHowMuch) {
  Picture actual = Plain(4, 4, 50);
  actual.rgb[3 * 5] = 60;
  const Picture difference = DifferencePicture(actual, Plain(4, 4, 50));
  EXPECT_EQ(difference.rgb[3 * 5], 80);
  EXPECT_EQ(difference.rgb[3 * 5 + 1], 0);
  EXPECT_EQ(difference.rgb[3 * 4], 0);
}

TEST(WriteComparisonTest, LeavesThreePictures) {
  const TemporaryFolder folder;
  WriteComparison(Plain(4, 2, 10), Plain(4, 2, 12), folder.Path(""), "case");
  EXPECT_EQ(ReadPng(folder.Path("case.actual.png")), Plain(4, 2, 10));
  EXPECT_EQ(ReadPng(folder.Path("case.expected.png")), Plain(4, 2, 12));
  EXPECT_EQ(ReadPng(folder.Path("case.difference.png")), Plain(4, 2, 16));
}

}  // namespace
}  // namespace loopscope
