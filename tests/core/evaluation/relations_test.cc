// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/relations.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

const Trajectory kTrajectory = {{10.0, Pose2(1.0, 2.0, M_PI / 2.0)},
                                {12.0, Pose2(1.0, 6.0, M_PI / 2.0)}};

TEST(Relations, ATrajectoryThatAgreesHasNoError) {
  const Pose2 error = ErrorOf({10.0, 12.0, Pose2(4.0, 0.0, 0.0)}, kTrajectory);
  EXPECT_NEAR(error.translation.norm(), 0.0, 1e-12);
  EXPECT_NEAR(error.rotation, 0.0, 1e-12);
}

TEST(Relations, PosesAreInterpolatedInBetween) {
  const Pose2 error = ErrorOf({10.5, 11.5, Pose2(1.75, 0.0, 0.0)}, kTrajectory);
  EXPECT_NEAR(error.x(), 0.25, 1e-12);
}

TEST(Relations, TimesOutsideAreMovedToTheEnds) {
  const Pose2 error = ErrorOf({-5.0, 99.0, Pose2(4.0, 0.0, 0.0)}, kTrajectory);
  EXPECT_NEAR(error.translation.norm(), 0.0, 1e-12);
}

TEST(Relations, TheErrorIsTheMotionTimesTheInverseOfTheExpectedOne) {
  // Turned by 90 degrees in between: (4, 0, 0) * (3, 0, 90 deg)^-1 = (4, 0) + (0, 3) turned back.
  const Pose2 error = ErrorOf({10.0, 12.0, Pose2(3.0, 0.0, M_PI / 2.0)}, kTrajectory);
  EXPECT_NEAR(error.x(), 4.0, 1e-12);
  EXPECT_NEAR(error.y(), 3.0, 1e-12);
  EXPECT_NEAR(error.rotation, -M_PI / 2.0, 1e-12);
}

TEST(Relations, ADisplacementIsRightEvenIfTheRotationIsWrong) {
  const Relation turned{10.0, 12.0, Pose2(4.0, 0.0, M_PI / 2.0)};
  EXPECT_NEAR(DisplacementErrorOf(turned, kTrajectory), 0.0, 1e-12);
  EXPECT_NEAR(ErrorOf(turned, kTrajectory).translation.norm(), std::sqrt(32.0), 1e-12);
  EXPECT_NEAR(DisplacementErrorOf({10.0, 12.0, Pose2(1.0, 4.0, 0.3)}, kTrajectory), 5.0, 1e-12);
  EXPECT_NEAR(EvaluateRelations({turned}, kTrajectory).translation_apart.max, 0.0, 1e-12);
}

TEST(Relations, StatisticsAreOverAbsoluteAndSquaredErrors) {
  const RelationsError error = EvaluateRelations(
      {{10.0, 12.0, Pose2(3.0, 0.0, 0.0)}, {10.0, 12.0, Pose2(7.0, 0.0, -0.5)}}, kTrajectory);
  EXPECT_EQ(error.translation.count, 2);
  EXPECT_NEAR(error.translation.min, 1.0, 1e-12);
  EXPECT_NEAR(error.translation_squared.min, 1.0, 1e-12);
  EXPECT_NEAR(error.translation_squared.max, error.translation.max * error.translation.max, 1e-12);
  EXPECT_NEAR(error.rotation.mean, 0.25, 1e-12);
  EXPECT_NEAR(error.rotation_squared.mean, 0.125, 1e-12);
}

}  // namespace
}  // namespace loopscope
