// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/trajectory.h"

#include <gmock/gmock.h>

#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

const Trajectory kTrajectory = {
    {10.0, Pose2(0.0, 0.0, 3.0)}, {12.0, Pose2(4.0, 2.0, -3.0)}, {12.5, Pose2(4.0, 0.1, -2.0)}};

TEST(PoseAt, IsThePoseOfAStampToTheLastBit) {
  for (const TimedPose& pose : kTrajectory)
    EXPECT_EQ(PoseAt(kTrajectory, pose.time), pose.map_from_base);
}

TEST(PoseAt, IsBetweenTheNeighboursInProportionToTime) {
  EXPECT_THAT(PoseAt(kTrajectory, 10.5),
              PoseNear(Pose2(1.0, 0.5, 3.0 + 0.25 * (2.0 * M_PI - 6.0)), 1e-12, 1e-12));
  EXPECT_THAT(PoseAt(kTrajectory, 12.25), PoseNear(Pose2(4.0, 1.05, -2.5), 1e-12, 1e-12));
}

TEST(PoseAt, StaysAtTheEnds) {
  EXPECT_EQ(PoseAt(kTrajectory, 9.0), kTrajectory.front().map_from_base);
  EXPECT_EQ(PoseAt(kTrajectory, 99.0), kTrajectory.back().map_from_base);
  EXPECT_EQ(PoseAt({{5.0, Pose2(1.0, 2.0, 3.0)}}, 6.0), Pose2(1.0, 2.0, 3.0));
}

TEST(PoseAt, IsTheFirstOfPosesWithTheSameStamp) {
  const Trajectory twice = {{1.0, Pose2(1.0, 0.0, 0.0)}, {1.0, Pose2(2.0, 0.0, 0.0)}};
  EXPECT_EQ(PoseAt(twice, 1.0), twice.front().map_from_base);
}

}  // namespace
}  // namespace loopscope
