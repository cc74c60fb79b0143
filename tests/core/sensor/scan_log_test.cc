// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/sensor/scan_log.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(BeamGeometry, TurnsCounterClockwiseFromTheFirstBeam) {
  const BeamGeometry beams{181, -1.5, 0.5};
  EXPECT_DOUBLE_EQ(beams.Angle(0), -1.5);
  EXPECT_DOUBLE_EQ(beams.Angle(4), 0.5);
}

TEST(BeamGeometry, DiffersInEachOfItsParts) {
  const BeamGeometry beams{181, -1.5, 0.5};
  EXPECT_TRUE(beams == (BeamGeometry{181, -1.5, 0.5}));
  EXPECT_FALSE(beams == (BeamGeometry{180, -1.5, 0.5}));
  EXPECT_FALSE(beams == (BeamGeometry{181, -1.4, 0.5}));
  EXPECT_FALSE(beams == (BeamGeometry{181, -1.5, 0.6}));
}

TEST(OdometryOfScan, IsTheLastReadingBeforeItInTheLogWhateverTheStamps) {
  ScanLog log;
  log.odometry = {
      {7.0, Pose2(1.0, 0.0, 0.0)}, {3.0, Pose2(2.0, 0.0, 0.0)}, {5.0, Pose2(3.0, 0.0, 0.0)}};
  log.scans.resize(3);
  log.scans[1].num_odometry_before = 2;
  log.scans[2].num_odometry_before = 3;
  EXPECT_FALSE(OdometryOfScan(log, 0));
  EXPECT_EQ(OdometryOfScan(log, 1)->time, 3.0);
  EXPECT_EQ(OdometryOfScan(log, 2)->odom_from_base.x(), 3.0);
}

}  // namespace
}  // namespace loopscope
