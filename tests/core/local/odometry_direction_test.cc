// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/odometry_direction.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

constexpr double kMemory = 100.0;                 // [m]
constexpr double kAngle = DegreesToRadians(0.5);  // by which the scanner looks to the right

/// What scans show when odometry measures `motion`.
Pose2 SeenByTheScanner(const Pose2& motion) {
  return {Eigen::Rotation2Dd(kAngle) * motion.translation, motion.rotation};
}

/// `way` metres ahead, 20 cm from scan to scan.
OdometryDirection AfterWay(double way, double memory) {
  OdometryDirection direction(memory);
  const Pose2 motion(0.2, 0.0, 0.01);
  for (double gone = 0.0; gone < way; gone += 0.2) {
    direction.Learn(motion, SeenByTheScanner(motion));
  }
  return direction;
}

TEST(OdometryDirection, ChangesNothingBeforeItHasLearned) {
  EXPECT_EQ(OdometryDirection(kMemory).Corrected(Pose2(1.0, 0.1, 0.2)), Pose2(1.0, 0.1, 0.2));
}

TEST(OdometryDirection, LearnsToWhichSideTheRobotMoves) {
  const OdometryDirection direction = AfterWay(60.0, kMemory);
  EXPECT_NEAR(direction.angle(), kAngle, 0.1 * kAngle);
  const Pose2 motion(2.0, 0.3, -0.4);
  EXPECT_THAT(direction.Corrected(motion), PoseNear(SeenByTheScanner(motion), 0.002, 1e-12));
}

TEST(OdometryDirection, LearnsTheSameFromGoingBackwards) {
  OdometryDirection direction(kMemory);
  const Pose2 back(-0.2, 0.0, 0.0);
  for (int i = 0; i < 300; ++i) direction.Learn(back, SeenByTheScanner(back));
  EXPECT_NEAR(direction.angle(), kAngle, 0.1 * kAngle);
}

TEST(OdometryDirection, BelievesLittleAfterAShortWay) {
  EXPECT_LT(AfterWay(1.0, kMemory).angle(), 0.2 * kAngle);
}

TEST(OdometryDirection, ForgetsWhatWasLongAgo) {
  OdometryDirection direction = AfterWay(60.0, kMemory);
  const Pose2 straight(0.2, 0.0, 0.0);
  for (double gone = 0.0; gone < 5.0 * kMemory; gone += 0.2) direction.Learn(straight, straight);
  EXPECT_LT(direction.angle(), 0.01 * kAngle);
}

TEST(OdometryDirection, LearnsNothingWhereOneOfTheTwoFailed) {
  OdometryDirection direction(kMemory);
  for (int i = 0; i < 100; ++i) {
    direction.Learn(Pose2(0.2, 0.0, 0.0), Pose2(0.2, 0.31, 0.0));
    direction.Learn(Pose2(0.2, 0.0, 0.0), Pose2(0.2, 0.05, DegreesToRadians(85.0)));
  }
  EXPECT_EQ(direction.angle(), 0.0);
}

TEST(OdometryDirection, LearnsNothingWithoutMemory) { EXPECT_EQ(AfterWay(60.0, 0.0).angle(), 0.0); }

}  // namespace
}  // namespace loopscope
