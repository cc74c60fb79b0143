// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/changed_ranges.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/core/local/scan_of.h"

namespace loopscope {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

TEST(ShareOfChangedRanges, CountsBeamsThatComeBackFromElsewhere) {
  const LaserScan before = ScanOf(40, 2.0F);
  LaserScan now = before;
  EXPECT_EQ(ShareOfChangedRanges(before, now), 0.0);
  for (int i = 0; i < 10; ++i) now.ranges[i] += i % 2 == 0 ? 0.11F : -0.11F;
  for (int i = 10; i < 20; ++i) now.ranges[i] += 0.09F;
  EXPECT_DOUBLE_EQ(ShareOfChangedRanges(before, now), 0.25);
}

TEST(ShareOfChangedRanges, TakesTwoPercentOfAFarRangeForNoise) {
  const LaserScan before = ScanOf(40, 20.0F);
  EXPECT_EQ(ShareOfChangedRanges(before, ScanOf(40, 20.3F)), 0.0);
  EXPECT_EQ(ShareOfChangedRanges(before, ScanOf(40, 20.6F)), 1.0);
}

TEST(ShareOfChangedRanges, CountsOnlyBeamsThatCameBackBothTimes) {
  LaserScan before = ScanOf(80, 2.0F);
  LaserScan now = ScanOf(80, 3.0F);
  for (int i = 0; i < 20; ++i) before.ranges[i] = kNothing;
  for (int i = 20; i < 40; ++i) now.ranges[i] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(ShareOfChangedRanges(before, now), 1.0);
  for (int i = 40; i < 60; ++i) now.ranges[i] = kNothing;
  EXPECT_EQ(ShareOfChangedRanges(before, now), 0.0) << "20 beams tell nothing";
}

TEST(ShareOfChangedRanges, ComparesBeamsOfTheSameGeometryOnly) {
  LaserScan now = ScanOf(50, 3.0F);
  now.beam_geometry = 1;
  EXPECT_EQ(ShareOfChangedRanges(ScanOf(40, 2.0F), now), 0.0);
}

TEST(ShowsAnotherPlace, WhereTwoFifthsOfTheBeamsComeBackFromElsewhere) {
  ScanLog log;
  log.scans = {ScanOf(100, 2.0F), ScanOf(100, 2.0F)};
  for (int i = 0; i < 40; ++i) log.scans[1].ranges[i] = 3.0F;
  EXPECT_FALSE(ShowsAnotherPlace(log, 1));
  log.scans[1].ranges[40] = 3.0F;
  EXPECT_TRUE(ShowsAnotherPlace(log, 1));
  EXPECT_FALSE(ShowsAnotherPlace(log, 0)) << "there is none before";
}

}  // namespace
}  // namespace loopscope
