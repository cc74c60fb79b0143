// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/usual_motion.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

/// Of `way` [m] in `direction`, turning by `turn` [deg] meanwhile.
Pose2 Motion(double way, double direction, double turn) {
  const double angle = DegreesToRadians(direction);
  return {way * std::cos(angle), way * std::sin(angle), DegreesToRadians(turn)};
}

double SidewaysOf(double way, double direction, double turn) {
  return SidewaysMotionOf(Motion(way, direction, turn));
}

TEST(SidewaysMotionOf, IsNoneBetweenTheFirstHeadingAndTheLast) {
  for (const double direction : {0.0, 20.0, 40.0, 180.0, -160.0, -140.0}) {
    EXPECT_NEAR(SidewaysOf(2.0, direction, 40.0), 0.0, 1e-12) << direction;
  }
  EXPECT_NEAR(SidewaysOf(2.0, -20.0, -40.0), 0.0, 1e-12);
  EXPECT_NEAR(SidewaysOf(2.0, 175.0, -170.0), 0.0, 1e-12);
}

TEST(SidewaysMotionOf, IsTheDistanceFromTheNearestDirectionThatWheelsTake) {
  EXPECT_NEAR(SidewaysOf(2.0, 90.0, 0.0), 2.0, 1e-12);
  EXPECT_NEAR(SidewaysOf(2.0, -30.0, 40.0), 1.0, 1e-12);
  EXPECT_NEAR(SidewaysOf(2.0, 70.0, 40.0), 1.0, 1e-12);
  EXPECT_NEAR(SidewaysOf(2.0, 150.0, 40.0), 1.0, 1e-12) << "30 deg from straight back";
  EXPECT_NEAR(SidewaysOf(2.0, 110.0, 40.0), 2.0 * std::sin(DegreesToRadians(70.0)), 1e-12);
  EXPECT_EQ(SidewaysMotionOf(Pose2()), 0.0);
}

TEST(UsualMotion, HasBoundsBeforeItLearns) {
  const UsualMotion usual;
  EXPECT_FALSE(usual.IsExceededBy(Motion(1.5, 0.0, 0.0)));
  EXPECT_FALSE(usual.IsExceededBy(Motion(0.19, 90.0, 0.0)));
  EXPECT_TRUE(usual.IsExceededBy(Motion(0.21, 90.0, 0.0)));
  EXPECT_FALSE(usual.IsExceededBy(Motion(0.0, 0.0, -19.0)));
  EXPECT_TRUE(usual.IsExceededBy(Motion(0.0, 0.0, -21.0)));
}

TEST(UsualMotion, LearnsWhatIsUsual) {
  UsualMotion usual;
  for (int i = 0; i < 100; ++i) usual.Learn(Motion(0.1, 90.0, i % 2 == 0 ? 10.0 : -10.0));
  EXPECT_FALSE(usual.IsExceededBy(Motion(0.38, -90.0, 39.0)));
  EXPECT_TRUE(usual.IsExceededBy(Motion(0.42, 90.0, 0.0)));
  EXPECT_TRUE(usual.IsExceededBy(Motion(0.0, 0.0, 41.0)));
}

TEST(UsualMotion, CountsTurnsTheShortWay) {
  UsualMotion usual;
  usual.Learn(Pose2(0.0, 0.0, 2.0 * M_PI + 0.01));
  EXPECT_FALSE(usual.IsExceededBy(Pose2(0.0, 0.0, 2.0 * M_PI - 0.01)));
  EXPECT_TRUE(usual.IsExceededBy(Motion(0.0, 0.0, 21.0)));
}

}  // namespace
}  // namespace loopscope
