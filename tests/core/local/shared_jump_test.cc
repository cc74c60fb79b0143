// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/shared_jump.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

const Pose2 kLast(3.0, -1.0, 0.4);

/// The poses that follow kLast, one motion after the other.
std::vector<Pose2> Chain(const std::vector<Pose2>& motions) {
  std::vector<Pose2> poses;
  Pose2 pose = kLast;
  for (const Pose2& motion : motions) {
    pose = pose * motion;
    poses.push_back(pose);
  }
  return poses;
}

TEST(FirstOfSharedJump, IsWherePredictedIfThereIsNoJump) {
  const auto predicted = Chain({{0.3, 0.1, 0.2}, {0.5, 0.0, -0.1}, {0.0, 0.2, 0.3}});
  EXPECT_THAT(FirstOfSharedJump(kLast, predicted, predicted.back()),
              PoseNear(predicted.front(), 1e-12, 1e-12));
}

TEST(FirstOfSharedJump, IsWhatWasFoundOfASingleScan) {
  const Pose2 found = kLast * Pose2(0.7, -0.2, 0.9);
  EXPECT_THAT(FirstOfSharedJump(kLast, Chain({{0.3, 0.1, 0.2}}), found),
              PoseNear(found, 1e-12, 1e-12));
}

TEST(FirstOfSharedJump, TakesAsMuchOfTheMissingTurnAsItTurned) {
  const auto predicted = Chain({{0.0, 0.0, 0.3}, {0.0, 0.0, 0.1}, {0.0, 0.0, 0.2}});
  const Pose2 found = kLast * Pose2(0.0, 0.0, 0.4);
  EXPECT_THAT(FirstOfSharedJump(kLast, predicted, found),
              PoseNear(kLast * Pose2(0.0, 0.0, 0.2), 1e-9, 1e-3));
}

TEST(FirstOfSharedJump, TakesAsMuchOfTheMissingWayAsItMoved) {
  const auto predicted = Chain({{0.3, 0.0, 0.0}, {0.9, 0.0, 0.0}});
  const Pose2 found = kLast * Pose2(1.6, 0.0, 0.0);
  EXPECT_THAT(FirstOfSharedJump(kLast, predicted, found),
              PoseNear(kLast * Pose2(0.4, 0.0, 0.0), 1e-3, 1e-9));
}

TEST(FirstOfSharedJump, FollowsABendThatWasMeasuredTooTight) {
  // Four motions of 10 deg instead of 15: all of what is missing is rotation.
  const Pose2 measured(0.5, 0.0, DegreesToRadians(15.0));
  const Pose2 real(0.5, 0.0, DegreesToRadians(10.0));
  EXPECT_THAT(FirstOfSharedJump(kLast, Chain({measured, measured, measured, measured}),
                                kLast * real * real * real * real),
              PoseNear(kLast * real, 1e-9, 1e-9));
}

TEST(FirstOfSharedJump, SharesEvenlyIfNothingWasMeasured) {
  EXPECT_THAT(FirstOfSharedJump(kLast, {kLast, kLast}, kLast * Pose2(0.2, 0.0, 0.0)),
              PoseNear(kLast * Pose2(0.1, 0.0, 0.0), 1e-9, 1e-9));
}

}  // namespace
}  // namespace loopscope
