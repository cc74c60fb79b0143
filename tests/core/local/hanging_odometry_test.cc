// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/hanging_odometry.h"

#include <limits>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

LaserScan ScanOf(int num_beams, float range) {
  LaserScan scan;
  scan.ranges.assign(num_beams, range);
  return scan;
}

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

class OdometryHanging : public ::testing::Test {
 protected:
  OdometryHanging() {
    log_.odometry = {{0.0, Pose2(1.0, 2.0, 3.0)}, {1.0, Pose2(1.0, 2.0, 3.0)}};
    log_.scans = {ScanOf(40, 2.0F), ScanOf(40, 3.0F)};
    log_.scans[0].num_odometry_before = 1;
    log_.scans[1].num_odometry_before = 2;
  }

  ScanLog log_;
};

TEST_F(OdometryHanging, IsToldByScansThatChange) {
  EXPECT_TRUE(OdometryHangs(log_, 1, 0.5));
  EXPECT_FALSE(OdometryHangs(log_, 0, 0.5)) << "there is none before";
  EXPECT_FALSE(OdometryHangs(log_, 1, 1.0)) << "not more than all can change";
}

TEST_F(OdometryHanging, IsNoneWhereTheRobotRests) {
  log_.scans[1].ranges = log_.scans[0].ranges;
  EXPECT_FALSE(OdometryHangs(log_, 1, 0.5));
}

TEST_F(OdometryHanging, IsNoneWhereItMeasuredAMotion) {
  log_.odometry[1].odom_from_base = Pose2(1.0, 2.0, 3.0001);
  EXPECT_FALSE(OdometryHangs(log_, 1, 0.5));
}

TEST_F(OdometryHanging, IsNoneWhereThereIsNone) {
  log_.scans[0].num_odometry_before = 0;
  EXPECT_FALSE(OdometryHangs(log_, 1, 0.5));
}

}  // namespace
}  // namespace loopscope
