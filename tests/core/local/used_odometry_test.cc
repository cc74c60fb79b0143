// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/used_odometry.h"

#include <gtest/gtest.h>

#include "tests/core/local/scan_of.h"

namespace loopscope {
namespace {

class OdometryHanging : public ::testing::Test {
 protected:
  OdometryHanging() {
    log_.odometry = {{0.0, Pose2(1.0, 2.0, 3.0)}, {1.0, Pose2(1.0, 2.0, 3.0)}};
    log_.scans = {ScanOf(40, 2.0F), ScanOf(40, 3.0F)};
    log_.scans[0].num_odometry_before = 1;
    log_.scans[1].num_odometry_before = 2;
  }

  bool Hangs(int scan, double max_changed_share) const {
    return OdometryHangs(log_, ReadOdometryOfScans(log_), scan, max_changed_share);
  }

  ScanLog log_;
};

TEST_F(OdometryHanging, IsToldByScansThatChange) {
  EXPECT_TRUE(Hangs(1, 0.5));
  EXPECT_FALSE(Hangs(0, 0.5)) << "there is none before";
  EXPECT_FALSE(Hangs(1, 1.0)) << "not more than all can change";
}

TEST_F(OdometryHanging, IsNoneWhereTheRobotRests) {
  log_.scans[1].ranges = log_.scans[0].ranges;
  EXPECT_FALSE(Hangs(1, 0.5));
}

TEST_F(OdometryHanging, IsNoneWhereItMeasuredAMotion) {
  log_.odometry[1].odom_from_base = Pose2(1.0, 2.0, 3.0001);
  EXPECT_FALSE(Hangs(1, 0.5));
}

TEST_F(OdometryHanging, IsNoneWhereThereIsNone) {
  log_.scans[0].num_odometry_before = 0;
  EXPECT_FALSE(Hangs(1, 0.5));
}

TEST(UsedOdometry, IsSpreadOverTheScansWhereItIsSlow) {
  ScanLog log;
  for (int i = 0; i < 60; ++i) {
    log.odometry.push_back({0.1 * i, Pose2(0.1 * (i - i % 2), 0.0, 0.0)});
    log.scans.push_back(ScanOf(40, 2.0F));
    log.scans.back().num_odometry_before = i + 1;
  }
  EXPECT_NEAR(UsedOdometry(log, {})[31]->x(), 3.1, 1e-12);
}

TEST(OdometryLeaps, By100MetersOrMore) {
  ScanLog log;
  log.odometry = {{0.0, Pose2(5e6, 2.0, 3.0)}, {1.0, Pose2()}};
  log.scans = {ScanOf(40, 2.0F), ScanOf(40, 2.0F)};
  log.scans[0].num_odometry_before = 1;
  log.scans[1].num_odometry_before = 2;
  const auto leaps_to = [&](double x) {
    log.odometry[1].odom_from_base = Pose2(x, 2.0, 1.0);
    const bool leaps = OdometryLeaps(ReadOdometryOfScans(log), 1);
    EXPECT_EQ(UsedOdometry(log, {})[1].has_value(), !leaps);
    return leaps;
  };
  EXPECT_FALSE(leaps_to(5e6 + 90.0)) << "a map may be far from where odometry begins";
  EXPECT_TRUE(leaps_to(5e6 + 110.0));
  EXPECT_TRUE(leaps_to(1e308));
  EXPECT_FALSE(OdometryLeaps(ReadOdometryOfScans(log), 0)) << "there is none before";
  log.scans[0].num_odometry_before = 0;
  EXPECT_FALSE(OdometryLeaps(ReadOdometryOfScans(log), 1));
}

}  // namespace
}  // namespace loopscope
