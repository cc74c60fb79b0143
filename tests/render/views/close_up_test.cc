// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/close_up.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(SquareOfMostInterestTest, IsAroundTheHeavyPointsNotTheMany) {
  std::vector<PointOfInterest> points;
  for (int i = 0; i < 50; ++i) points.push_back({{10.0, 10.0 + 0.01 * i}, 0.01});
  points.push_back({{-4.0, 2.0}, 1.0});
  const Extent square = SquareOfMostInterest(points, 2.0);
  EXPECT_TRUE(square.contains(Eigen::Vector2d(-4.0, 2.0)));
  EXPECT_TRUE(square.sizes().isApprox(Eigen::Vector2d(2.0, 2.0)));
}

TEST(SquareOfMostInterestTest, HasTheWeightInItsMiddleWhereverTheLatticeIs) {
  for (double x = 0.0; x < 3.0; x += 0.13) {
    const Extent square = SquareOfMostInterest({{{x, 1.0}, 1.0}, {{x + 0.8, 1.0}, 1.0}}, 2.0);
    EXPECT_NEAR(square.center().x(), x + 0.4, 1e-9) << x;
  }
}

TEST(SquareOfMostInterestTest, FindsThePointsEvenIfNoneWeighsAnything) {
  EXPECT_TRUE(SquareOfMostInterest({{{5.0, 5.0}, 0.0}}, 1.0).contains(Eigen::Vector2d(5.0, 5.0)));
  EXPECT_TRUE(SquareOfMostInterest({}, 1.0).isEmpty());
}

}  // namespace
}  // namespace loopscope
