// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/pose2.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/simulation/random.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

constexpr int kNumRandomCases = 1000;

Pose2 RandomPose(Random& random) {
  return Pose2{random.Uniform(-50.0, 50.0), random.Uniform(-50.0, 50.0),
               random.Uniform(-M_PI, M_PI)};
}

/// The oracle of all algebra: homogeneous matrices.
Eigen::Matrix3d MatrixOf(const Pose2& pose) {
  Eigen::Matrix3d matrix;
  matrix << std::cos(pose.rotation), -std::sin(pose.rotation), pose.x(),  //
      std::sin(pose.rotation), std::cos(pose.rotation), pose.y(),         //
      0.0, 0.0, 1.0;
  return matrix;
}

TEST(NormalizeAngle, LeavesAnglesOfItsRangeAlone) {
  for (const double angle : {0.0, 1.5, -1.5, 3.14159, -3.14159, M_PI}) {
    EXPECT_EQ(NormalizeAngle(angle), angle);
  }
}

TEST(NormalizeAngle, TakesHalfATurnToPlusPi) {
  EXPECT_EQ(NormalizeAngle(-M_PI), M_PI);
  EXPECT_EQ(NormalizeAngle(3.0 * M_PI), M_PI);
}

TEST(NormalizeAngle, ChangesAnAngleByWholeTurns) {
  Random random(1);
  for (int i = 0; i < kNumRandomCases; ++i) {
    const double angle = random.Uniform(-100.0, 100.0);
    const double normalized = NormalizeAngle(angle);
    EXPECT_GT(normalized, -M_PI);
    EXPECT_LE(normalized, M_PI);
    const double turns = (angle - normalized) / (2.0 * M_PI);
    EXPECT_NEAR(turns, std::round(turns), 1e-12);
  }
}

TEST(Degrees, AreThereAndBackTheSame) {
  EXPECT_DOUBLE_EQ(DegreesToRadians(180.0), M_PI);
  EXPECT_DOUBLE_EQ(RadiansToDegrees(M_PI / 2.0), 90.0);
}

TEST(Pose2, IsTheIdentityByDefault) {
  EXPECT_EQ(Pose2(), Pose2(0.0, 0.0, 0.0));
  EXPECT_EQ(Pose2() * Eigen::Vector2d(3.0, 4.0), Eigen::Vector2d(3.0, 4.0));
}

TEST(Pose2, TurnsCounterClockwiseAndThenShifts) {
  const Eigen::Vector2d point = Pose2(10.0, 20.0, M_PI / 2.0) * Eigen::Vector2d(1.0, 0.0);
  EXPECT_NEAR(point.x(), 10.0, 1e-12);
  EXPECT_NEAR(point.y(), 21.0, 1e-12);
}

TEST(Pose2, DiffersInEachOfItsParts) {
  const Pose2 pose(1.0, 2.0, 3.0);
  EXPECT_EQ(pose, Pose2(Eigen::Vector2d(1.0, 2.0), 3.0));
  EXPECT_NE(pose, Pose2(1.5, 2.0, 3.0));
  EXPECT_NE(pose, Pose2(1.0, 2.5, 3.0));
  EXPECT_NE(pose, Pose2(1.0, 2.0, 3.1));
}

TEST(Pose2, MultipliesAsHomogeneousMatricesDo) {
  Random random(2);
  for (int i = 0; i < kNumRandomCases; ++i) {
    const Pose2 c_from_b = RandomPose(random);
    const Pose2 b_from_a = RandomPose(random);
    const Eigen::Vector2d in_a{random.Uniform(-9.0, 9.0), random.Uniform(-9.0, 9.0)};
    const Eigen::Matrix3d product = MatrixOf(c_from_b) * MatrixOf(b_from_a);
    EXPECT_TRUE(MatrixOf(c_from_b * b_from_a).isApprox(product, 1e-12));
    const Eigen::Vector3d in_b = MatrixOf(b_from_a) * Eigen::Vector3d(in_a.x(), in_a.y(), 1.0);
    EXPECT_TRUE((b_from_a * in_a).isApprox(in_b.head<2>(), 1e-12));
  }
}

TEST(Pose2, IsUndoneByItsInverse) {
  Random random(3);
  for (int i = 0; i < kNumRandomCases; ++i) {
    const Pose2 pose = RandomPose(random);
    EXPECT_THAT(pose * pose.Inverse(), PoseNear(Pose2(), 1e-12, 1e-12));
    EXPECT_THAT(pose.Inverse() * pose, PoseNear(Pose2(), 1e-12, 1e-12));
  }
}

TEST(Pose2, KeepsRotationsNormalized) {
  EXPECT_NEAR((Pose2(0.0, 0.0, 3.0) * Pose2(0.0, 0.0, 3.0)).rotation, 6.0 - 2.0 * M_PI, 1e-12);
  EXPECT_EQ(Pose2(0.0, 0.0, M_PI).Inverse().rotation, M_PI);
}

TEST(Interpolate, BeginsAtTheFirstAndEndsAtTheSecond) {
  Random random(4);
  for (int i = 0; i < kNumRandomCases; ++i) {
    const Pose2 a = RandomPose(random);
    const Pose2 b = RandomPose(random);
    EXPECT_THAT(Interpolate(a, b, 0.0), PoseNear(a, 0.0, 0.0));
    EXPECT_THAT(Interpolate(a, b, 1.0), PoseNear(b, 1e-12, 1e-12));
  }
}

TEST(Interpolate, GoesEvenlyInBetween) {
  EXPECT_THAT(Interpolate(Pose2(1.0, 2.0, 0.2), Pose2(5.0, -6.0, 0.6), 0.25),
              PoseNear(Pose2(2.0, 0.0, 0.3), 1e-12, 1e-12));
}

TEST(Interpolate, TurnsTheShorterWay) {
  const Pose2 a(0.0, 0.0, DegreesToRadians(170.0));
  const Pose2 b(0.0, 0.0, DegreesToRadians(-150.0));
  EXPECT_NEAR(Interpolate(a, b, 0.25).rotation, M_PI, 1e-12);
  EXPECT_NEAR(Interpolate(a, b, 0.5).rotation, DegreesToRadians(-170.0), 1e-12);
  EXPECT_NEAR(Interpolate(b, a, 0.25).rotation, DegreesToRadians(-160.0), 1e-12);
}

TEST(IsInMap, WithinAThousandKilometres) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(IsInMap(Pose2(1e6, -1e6, 3.0)));
  EXPECT_FALSE(IsInMap(Pose2(1.1e6, 0.0, 0.0)));
  EXPECT_FALSE(IsInMap(Pose2(0.0, -1.1e6, 0.0)));
  EXPECT_FALSE(IsInMap(Pose2(kNan, 0.0, 0.0)));
  EXPECT_FALSE(IsInMap(Pose2(0.0, kNan, 0.0)));
  EXPECT_FALSE(IsInMap(Pose2(0.0, 0.0, kNan)));
}

TEST(Rounded, KeepsSixDecimals) {
  EXPECT_EQ(Rounded(0.55), 0.55);
  EXPECT_EQ(Rounded(-1.0000004), -1.0);
  EXPECT_EQ(Rounded(Pose2(1.23456789, -2.0000006, 0.1234567)),
            Pose2(1.234568, -2.000001, 0.123457));
}

TEST(Rounded, ChangesNothingThatIsRounded) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 rounded = Rounded(RandomPose(random));
    EXPECT_EQ(Rounded(rounded), rounded);
  }
}

TEST(Rounded, StaysWithinHalfATurn) {
  EXPECT_LE(Rounded(Pose2(0.0, 0.0, M_PI)).rotation, M_PI);
  EXPECT_GT(Rounded(Pose2(0.0, 0.0, -3.1415926535)).rotation, -M_PI);
}

TEST(PoseNear, TellsHowFarOffAPoseIs) {
  testing::StringMatchResultListener listener;
  EXPECT_FALSE(testing::ExplainMatchResult(PoseNear(Pose2(0.0, 0.0, M_PI), 1.0, 0.1),
                                           Pose2(3.0, 4.0, -0.5 * M_PI), &listener));
  EXPECT_EQ(listener.str(), "which is 5 m and 90 deg off");
  EXPECT_THAT(Pose2(), testing::Not(PoseNear(Pose2(0.0, 0.0, 0.2), 1.0, 0.1)));
}

}  // namespace
}  // namespace loopscope
