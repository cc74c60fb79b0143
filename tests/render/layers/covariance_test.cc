// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/covariance.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

/// Deviations of 3 m along a direction 30 degrees from x, and of 1 m across.
UncertainPoint TiltedPoint() {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(M_PI / 6.0).toRotationMatrix();
  const Eigen::Matrix2d covariance =
      turn * Eigen::Vector2d(9.0, 1.0).asDiagonal() * turn.transpose();
  return {{5.0, -2.0}, covariance};
}

TEST(EllipseOfTest, EveryPointIsAsManyDeviationsAway) {
  const UncertainPoint point = TiltedPoint();
  for (const Eigen::Vector2d& corner : EllipseOf(point, 2.0)) {
    const Eigen::Vector2d d = corner - point.mean;
    EXPECT_NEAR(d.dot(point.covariance.inverse() * d), 4.0, 1e-9);
  }
}

TEST(EllipseOfTest, IsLongestInTheLeastCertainDirection) {
  const UncertainPoint point = TiltedPoint();
  EXPECT_NEAR(point.LargestDeviation(), 3.0, 1e-12);
  double farthest = 0.0;
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : EllipseOf(point, 1.0)) {
    if ((corner - point.mean).norm() <= farthest) continue;
    farthest = (corner - point.mean).norm();
    tip = corner - point.mean;
  }
  EXPECT_NEAR(farthest, 3.0, 0.01);
  EXPECT_NEAR(std::abs(tip.normalized().dot(Eigen::Vector2d(std::cos(M_PI / 6.0), 0.5))), 1.0,
              0.01);
}

TEST(EllipseOfTest, OfNoUncertaintyIsAPoint) {
  for (const Eigen::Vector2d& corner : EllipseOf({{1.0, 2.0}, Eigen::Matrix2d::Zero()}, 3.0)) {
    EXPECT_TRUE(corner.isApprox(Eigen::Vector2d(1.0, 2.0)));
  }
}

TEST(EllipsesLayerTest, HasAClosedLineForEachPoint) {
  const auto layer = EllipsesLayer({TiltedPoint(), TiltedPoint()}, 1.0, Color{1, 2, 3}, 1.0);
  EXPECT_EQ(DataOf(layer)->GetNumberOfLines(), 2);
  EXPECT_EQ(ColorOf(layer, 0), (Color{1, 2, 3}));
}

}  // namespace
}  // namespace loopscope
