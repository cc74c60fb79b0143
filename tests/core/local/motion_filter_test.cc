// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/motion_filter.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

/// One limit at a time: the others never are reached.
MotionFilterOptions OnlyTime() { return {5.0, 1e9, M_PI}; }
MotionFilterOptions OnlyDistance() { return {1e9, 0.2, M_PI}; }
MotionFilterOptions OnlyAngle() { return {1e9, 1e9, 0.1}; }

TEST(MotionFilter, KeepsTheFirstScan) {
  MotionFilter filter{MotionFilterOptions()};
  EXPECT_FALSE(filter.IsSimilar(7.0, Pose2(1.0, 2.0, 3.0)));
  EXPECT_TRUE(filter.IsSimilar(7.0, Pose2(1.0, 2.0, 3.0)));
}

TEST(MotionFilter, KeepsAScanThatWasTakenFarEnoughAway) {
  MotionFilter filter(OnlyDistance());
  filter.IsSimilar(0.0, Pose2(1.0, 1.0, 0.5));
  EXPECT_TRUE(filter.IsSimilar(0.0, Pose2(1.0, 1.19, 0.5)));
  EXPECT_FALSE(filter.IsSimilar(0.0, Pose2(1.0, 1.21, 0.5)));
}

TEST(MotionFilter, KeepsAScanThatWasTurnedEnoughTheShorterWay) {
  MotionFilter filter(OnlyAngle());
  filter.IsSimilar(0.0, Pose2(0.0, 0.0, M_PI - 0.05));
  EXPECT_TRUE(filter.IsSimilar(0.0, Pose2(0.0, 0.0, -M_PI + 0.04)));
  EXPECT_FALSE(filter.IsSimilar(0.0, Pose2(0.0, 0.0, -M_PI + 0.06)));
}

TEST(MotionFilter, KeepsAScanThatWasTakenLongAfterOrBefore) {
  MotionFilter filter(OnlyTime());
  filter.IsSimilar(100.0, Pose2());
  EXPECT_TRUE(filter.IsSimilar(105.0, Pose2()));
  EXPECT_TRUE(filter.IsSimilar(95.0, Pose2()));
  EXPECT_FALSE(filter.IsSimilar(94.0, Pose2()));
  EXPECT_FALSE(filter.IsSimilar(100.0, Pose2()));
}

TEST(MotionFilter, ComparesWithTheLastScanThatWasKept) {
  MotionFilter filter(OnlyDistance());
  int num_kept = 0;
  for (int i = 0; i <= 30; ++i) {
    if (!filter.IsSimilar(0.0, Pose2(0.03 * i, 0.0, 0.0))) ++num_kept;
  }
  EXPECT_EQ(num_kept, 5);  // at 0, 0.21, 0.42, 0.63, 0.84
}

}  // namespace
}  // namespace loopscope
