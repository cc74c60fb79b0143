// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/match_score.h"

#include <gtest/gtest.h>

#include "tests/support/ascii_grid.h"

namespace loopscope {
namespace {

TEST(MeanProbability, IsTheMeanOfTheNearestCells) {
  const ProbabilityGrid grid = GridDrawn({"2 8",  //
                                          "146"},
                                         1.0);
  const PointCloud points = {{0.4, 0.4}, {1.6, 0.6}, {2.4, -0.4}};  // cells of 0.1, 0.8 and 0.6
  EXPECT_NEAR(MeanProbability(points, Pose2(), grid), 0.5, 1e-4);
}

TEST(MeanProbability, CountsUnknownCellsAsTheLeast) {
  const ProbabilityGrid grid = GridDrawn({"9 "}, 1.0);
  EXPECT_NEAR(MeanProbability({{0.0, 0.0}, {1.0, 0.0}}, Pose2(), grid), 0.5, 1e-4);
  EXPECT_NEAR(MeanProbability({{0.0, 0.0}, {50.0, 0.0}}, Pose2(), grid), 0.5, 1e-4);
}

TEST(MeanProbability, MovesTheScanToTheFrameOfTheSubmap) {
  const ProbabilityGrid grid = GridDrawn({"7",  //
                                          "1"},
                                         1.0, {4, 5});
  // The point two ahead of a scanner that looks to the upper side of the map.
  EXPECT_NEAR(MeanProbability({{2.0, 0.0}}, Pose2(4.0, 4.0, M_PI / 2.0), grid), 0.7, 1e-4);
}

TEST(ScoreOfKnown, LeavesOutPointsInUnknownCells) {
  const ProbabilityGrid grid = GridDrawn({"9 4"}, 1.0);
  const KnownScore score =
      ScoreOfKnown({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {50.0, 0.0}}, Pose2(), grid);
  EXPECT_EQ(score.num_points, 2);
  EXPECT_NEAR(score.mean_probability, 0.65, 1e-4);
  EXPECT_EQ(ScoreOfKnown({{1.0, 0.0}}, Pose2(), grid).num_points, 0);
  EXPECT_EQ(ScoreOfKnown({{1.0, 0.0}}, Pose2(), grid).mean_probability, 0.0);
}

TEST(HoldsAhead, AlongAWallOnlyIfSomethingStandsAcross) {
  const ProbabilityGrid grid = GridDrawn({"9999999",  //
                                          "1111911",  //
                                          "9999999"},
                                         0.1);
  const PointCloud walls = {{0.2, 0.0}, {0.3, 0.0}, {0.4, 0.0}, {0.2, 0.2}, {0.3, 0.2}};
  PointCloud walls_and_post = walls;
  for (int i = 0; i < 4; ++i) walls_and_post.emplace_back(0.4, 0.1);
  EXPECT_FALSE(HoldsAhead(walls, Pose2(), grid));
  EXPECT_TRUE(HoldsAhead(walls_and_post, Pose2(), grid));
}

TEST(HoldsAhead, NotIfTheScanFitsAsWellOnOneOfTheTwoSides) {
  const ProbabilityGrid grid = GridDrawn({"1991"}, 0.1);
  EXPECT_FALSE(HoldsAhead({{0.1, 0.0}}, Pose2(), grid));
  EXPECT_FALSE(HoldsAhead({{0.2, 0.0}}, Pose2(), grid));
  EXPECT_TRUE(HoldsAhead({{0.1, 0.0}, {0.2, 0.0}}, Pose2(), grid));
}

TEST(HoldsAhead, IsAskedInTheDirectionOfTheRobot) {
  const ProbabilityGrid grid = GridDrawn({"111",  //
                                          "999",  //
                                          "111"},
                                         0.1);
  EXPECT_FALSE(HoldsAhead({{0.0, 0.0}}, Pose2(0.1, 0.1, 0.0), grid));
  EXPECT_TRUE(HoldsAhead({{0.0, 0.0}}, Pose2(0.1, 0.1, M_PI / 2.0), grid));
}

}  // namespace
}  // namespace loopscope
