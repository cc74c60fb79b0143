// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/odometry_calibration.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

constexpr double kMemory = 100.0;                 // [m]
constexpr double kAngle = DegreesToRadians(0.5);  // by which the scanner looks to the right
constexpr double kScale = 1.04;                   // for wheels that are larger than believed

/// What scans show when odometry measures `motion`.
Pose2 SeenByTheScanner(const Pose2& motion) {
  return {kScale * (Eigen::Rotation2Dd(kAngle) * motion.translation), motion.rotation};
}

/// Likewise when it measures a metre ahead.
Eigen::Vector2d SeenPerMeter() { return SeenByTheScanner(Pose2(1.0, 0.0, 0.0)).translation; }

/// How much of what there is to learn is not learned yet; 1 at the beginning.
double ShareNotLearned(const OdometryCalibration& calibration) {
  return (calibration.MotionPerMeter() - SeenPerMeter()).norm() /
         (Eigen::Vector2d::UnitX() - SeenPerMeter()).norm();
}

/// `way` metres ahead, 20 cm from scan to scan.
OdometryCalibration AfterWay(double way, double memory) {
  OdometryCalibration calibration(memory);
  const Pose2 motion(0.2, 0.0, 0.01);
  for (double gone = 0.0; gone < way; gone += 0.2) {
    calibration.Learn(motion, SeenByTheScanner(motion), true);
  }
  return calibration;
}

TEST(OdometryCalibration, ChangesNothingBeforeItHasLearned) {
  EXPECT_EQ(OdometryCalibration(kMemory).Corrected(Pose2(1.0, 0.1, 0.2)), Pose2(1.0, 0.1, 0.2));
}

TEST(OdometryCalibration, LearnsHowFarAndToWhichSideTheRobotMoves) {
  const OdometryCalibration calibration = AfterWay(60.0, kMemory);
  EXPECT_NEAR(calibration.MotionPerMeter().x(), kScale * std::cos(kAngle), 0.15 * (kScale - 1.0));
  EXPECT_NEAR(calibration.MotionPerMeter().y(), kScale * std::sin(kAngle), 0.15 * kAngle);
  const Pose2 motion(2.0, 0.3, -0.4);
  EXPECT_THAT(calibration.Corrected(motion), PoseNear(SeenByTheScanner(motion), 0.01, 1e-12));
}

TEST(OdometryCalibration, LearnsOnlyTheSideFromMatchesThatDoNotHoldTheWay) {
  OdometryCalibration calibration(kMemory);
  const Pose2 motion(0.2, 0.0, 0.0);
  for (int i = 0; i < 300; ++i) calibration.Learn(motion, SeenByTheScanner(motion), false);
  EXPECT_EQ(calibration.MotionPerMeter().x(), 1.0);
  EXPECT_NEAR(calibration.MotionPerMeter().y(), kScale * std::sin(kAngle), 0.15 * kAngle);
}

TEST(OdometryCalibration, LearnsTheSameFromGoingBackwards) {
  OdometryCalibration calibration(kMemory);
  const Pose2 back(-0.2, 0.0, 0.0);
  for (int i = 0; i < 300; ++i) calibration.Learn(back, SeenByTheScanner(back), true);
  EXPECT_LT(ShareNotLearned(calibration), 0.1);
}

TEST(OdometryCalibration, BelievesLittleAfterAShortWay) {
  EXPECT_GT(ShareNotLearned(AfterWay(1.0, kMemory)), 0.8);
}

TEST(OdometryCalibration, ForgetsWhatWasLongAgo) {
  OdometryCalibration calibration = AfterWay(60.0, kMemory);
  const Pose2 straight(0.2, 0.0, 0.0);
  for (double gone = 0.0; gone < 5.0 * kMemory; gone += 0.2)
    calibration.Learn(straight, straight, true);
  EXPECT_GT(ShareNotLearned(calibration), 0.99);
}

TEST(OdometryCalibration, LearnsNothingWhereOneOfTheTwoFailed) {
  OdometryCalibration calibration(kMemory);
  for (int i = 0; i < 100; ++i) {
    calibration.Learn(Pose2(0.2, 0.0, 0.0), Pose2(0.2, 0.31, 0.0), true);
    calibration.Learn(Pose2(0.2, 0.0, 0.0), Pose2(0.2, 0.05, DegreesToRadians(85.0)), true);
  }
  EXPECT_EQ(calibration.MotionPerMeter(), Eigen::Vector2d(1.0, 0.0));
}

TEST(OdometryCalibration, LearnsNothingWithoutMemory) {
  EXPECT_EQ(AfterWay(60.0, 0.0).MotionPerMeter(), Eigen::Vector2d(1.0, 0.0));
}

}  // namespace
}  // namespace loopscope
