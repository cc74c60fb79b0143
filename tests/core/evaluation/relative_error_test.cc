// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/relative_error.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loopscope {
namespace {

using testing::ElementsAre;

/// A robot that went along x by 0.4 m a pose, as it is believed; it really went 0.5 m a pose, and
/// the frame of the reference is another one.
std::vector<PosePair> ShortWay() {
  std::vector<PosePair> pairs;
  const Pose2 reference_from_map(7.0, -3.0, 2.0);
  for (int i = 0; i < 10; ++i) {
    pairs.push_back(
        {1.0 * i, reference_from_map * Pose2(0.5 * i, 0.0, 0.0), Pose2(0.4 * i, 0.0, 0.0)});
  }
  return pairs;
}

TEST(RelativeError, ComparesFramesALengthOfTheEstimateApart) {
  EXPECT_THAT(RelativeErrorFrames(ShortWay(), DeltaInMeters{1.0}), ElementsAre(3, 6, 9));
  const auto error = EvaluateRelative(ShortWay(), DeltaInMeters{1.0});
  EXPECT_EQ(error->translation.count, 2);
  EXPECT_NEAR(error->translation.min, 0.3, 1e-12);
  EXPECT_NEAR(error->translation.max, 0.3, 1e-12);
  EXPECT_NEAR(error->rotation.max, 0.0, 1e-12);
}

TEST(RelativeError, ComparesEveryFewFrames) {
  EXPECT_THAT(RelativeErrorFrames(ShortWay(), DeltaInPoses{4}), ElementsAre(0, 4, 8));
  EXPECT_NEAR(EvaluateRelative(ShortWay(), DeltaInPoses{4})->translation.mean, 0.4, 1e-12);
  EXPECT_EQ(EvaluateRelative(ShortWay(), DeltaInPoses{1})->translation.count, 9);
}

TEST(RelativeError, IsSeenFromTheExpectedPose) {
  // Expected: a quarter turn at (1, 0). Estimated: half a turn at (1, 2), which is (2, 0) and a
  // quarter turn from there.
  const std::vector<PosePair> pairs = {{0.0, Pose2(), Pose2()},
                                       {1.0, Pose2(1.0, 0.0, M_PI / 2.0), Pose2(1.0, 2.0, M_PI)}};
  const auto error = EvaluateRelative(pairs, DeltaInPoses{1});
  EXPECT_NEAR(error->translation.mean, 2.0, 1e-12);
  EXPECT_NEAR(error->rotation.mean, M_PI / 2.0, 1e-12);
}

TEST(RelativeError, NeedsTwoFrames) {
  EXPECT_FALSE(EvaluateRelative(ShortWay(), DeltaInMeters{3.0}));
  EXPECT_FALSE(EvaluateRelative(ShortWay(), DeltaInPoses{10}));
  EXPECT_FALSE(EvaluateRelative({}, DeltaInMeters{1.0}));
}

}  // namespace
}  // namespace loopscope
