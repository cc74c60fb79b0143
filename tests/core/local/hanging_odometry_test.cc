// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/hanging_odometry.h"

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
