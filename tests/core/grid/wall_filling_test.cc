// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/wall_filling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/grid/ray_cast.h"

namespace loopscope {
namespace {

using ::testing::IsEmpty;

/// Of a straight wall, `gap` [m] apart.
PointCloud Wall(int num_returns, double gap) {
  PointCloud returns;
  for (int i = 0; i < num_returns; ++i) returns.emplace_back(2.0, gap * i);
  return returns;
}

TEST(PointsBetween, FillTheGapsThatHaveReturnsOnBothSides) {
  const PointCloud points = PointsBetween(Wall(4, 1.0), 1.5, 0.25);
  ASSERT_EQ(points.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(points[i], Eigen::Vector2d(2.0, 1.25 + 0.25 * i)) << "between the second and third";
  }
}

TEST(PointsBetween, LeaveWiderGapsOpen) {
  EXPECT_THAT(PointsBetween(Wall(4, 1.0), 0.9, 0.25), IsEmpty());
  EXPECT_THAT(PointsBetween(Wall(4, 1.0), 0.0, 0.25), IsEmpty()) << "off";
}

TEST(PointsBetween, LeaveADoorOpenWhoseOtherSideIsSeen) {
  PointCloud returns = Wall(8, 0.5);
  returns.insert(returns.begin() + 4, Eigen::Vector2d(5.0, 1.75));  // through the door
  for (const Eigen::Vector2d& point : PointsBetween(returns, 2.0, 0.1)) {
    EXPECT_TRUE(point.y() < 1.0 + 1e-9 || point.y() > 2.5 - 1e-9) << point.transpose();
  }
}

TEST(PointsBetween, NeedAStraightWall) {
  PointCloud bent = Wall(4, 1.0);
  bent[3].x() += 0.2;  // a turn of 11 deg
  EXPECT_THAT(PointsBetween(bent, 1.5, 0.25), IsEmpty());
  bent[3].x() -= 0.15;  // of 3 deg
  EXPECT_EQ(PointsBetween(bent, 1.5, 0.25).size(), 3u);
}

TEST(PointsBetween, ThinkNoWallIntoTwoOrThreeReturns) {
  for (int num_returns = 0; num_returns <= 3; ++num_returns) {
    EXPECT_THAT(PointsBetween(Wall(num_returns, 1.0), 1.5, 0.25), IsEmpty()) << num_returns;
  }
}

TEST(PointsBetween, AreHitsWithoutRaysOfTheirOwn) {
  const RangeData data{{0.0, 0.0}, Wall(4, 1.0), {}};
  const ScanCells dots = CastRays(data, 0.1);
  const ScanCells wall = CastRays(data, 0.1, 1.5);
  EXPECT_EQ(dots.hits.size(), 4u);
  EXPECT_EQ(wall.hits.size(), 4u + 9u);
  for (const CellIndex miss : wall.misses) {
    EXPECT_THAT(dots.misses, ::testing::Contains(miss)) << miss.x << ", " << miss.y;
  }
}

}  // namespace
}  // namespace loopscope
