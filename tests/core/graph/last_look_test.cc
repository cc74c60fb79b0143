// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/last_look.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

/// Knows the cells (0, 0) to (9, 0).
ProbabilityGrid RowOfCells() {
  ProbabilityGrid grid(1.0);
  grid.GrowToInclude({{0, 0}, 10, 1});
  for (int x = 0; x < 10; ++x) grid.Update({{x, 0}}, OddsUpdate(0.7));
  return grid;
}

/// A point in each cell from (0, 0) on.
PointCloud PointsInARow(int count) {
  PointCloud points;
  for (int x = 0; x < count; ++x) points.emplace_back(x, 0.0);
  return points;
}

double MinScore(int num_points, const Pose2& guess, double min_known_share) {
  return MinScoreOfLastLook(0.5, PointsInARow(num_points), guess, RowOfCells(),
                            {12, 0.8, min_known_share});
}

TEST(MinScoreOfLastLook, IsAShareOfTheOtherOneWhereTheSubmapKnowsAll) {
  EXPECT_DOUBLE_EQ(MinScore(10, Pose2(), 0.35), 0.8 * 0.5);
}

TEST(MinScoreOfLastLook, AsksNothingOfPointsInUnknownCells) {
  EXPECT_DOUBLE_EQ(MinScore(20, Pose2(), 0.35), 0.5 * (0.8 * 0.5) + 0.5 * kMinProbability);
  EXPECT_DOUBLE_EQ(MinScore(10, Pose2(4.0, 0.0, 0.0), 0.35),
                   0.6 * (0.8 * 0.5) + 0.4 * kMinProbability);
}

TEST(MinScoreOfLastLook, AsksForSomePointsAtLeast) {
  EXPECT_DOUBLE_EQ(MinScore(100, Pose2(), 0.35), 0.35 * (0.8 * 0.5) + 0.65 * kMinProbability);
  EXPECT_DOUBLE_EQ(MinScore(100, Pose2(), 1.0), 0.8 * 0.5);
}

double RelativeScore(const PointCloud& points, const Pose2& pose, const Pose2& winner) {
  ProbabilityGrid grid = RowOfCells();
  grid.Update({{0, 0}}, OddsUpdate(0.9));
  return RelativeScoreOfKnown(points, pose, winner, grid, {12, 0.8, 0.35});
}

TEST(RelativeScoreOfKnown, ComparesWhatIsKnownAtEitherPose) {
  const PointCloud points = PointsInARow(4);
  EXPECT_DOUBLE_EQ(RelativeScore(points, Pose2(2.0, 0.0, 0.0), Pose2(5.0, 0.0, 0.0)), 1.0);
  EXPECT_DOUBLE_EQ(RelativeScore(points, Pose2(8.0, 0.0, 0.0), Pose2(5.0, 0.0, 0.0)), 1.0)
      << "two points lie beyond";
  EXPECT_GT(RelativeScore(points, Pose2(0.0, 0.0, 0.0), Pose2(5.0, 0.0, 0.0)), 1.0);
  EXPECT_LT(RelativeScore(points, Pose2(5.0, 0.0, 0.0), Pose2(0.0, 0.0, 0.0)), 1.0);
}

TEST(RelativeScoreOfKnown, IsNothingWhereTooFewPointsAreKnown) {
  const PointCloud points = PointsInARow(4);
  EXPECT_EQ(RelativeScore(points, Pose2(9.0, 0.0, 0.0), Pose2(5.0, 0.0, 0.0)), 0.0);
  EXPECT_EQ(RelativeScore(points, Pose2(5.0, 0.0, 0.0), Pose2(50.0, 0.0, 0.0)), 0.0);
}

}  // namespace
}  // namespace loopscope
