// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/search_lattice.h"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

TEST(AngularStep, MovesTheFarthestPointByOneCell) {
  const PointCloud points = {{1.0, 2.0}, {-6.0, 8.0}, {9.0, 0.0}};
  const Eigen::Matrix2d turn = Pose2(0.0, 0.0, AngularStep(points, 0.05)).RotationMatrix();
  EXPECT_NEAR((turn * points[0] - points[0]).norm(), 0.05 * std::sqrt(0.05), 1e-9);
  EXPECT_NEAR((turn * points[1] - points[1]).norm(), 0.05, 1e-9);
}

TEST(AngularStep, IsLimitedForAScanOfAFewCells) {
  const double step = AngularStep({{0.01, 0.0}}, 0.05);
  EXPECT_DOUBLE_EQ(step, AngularStep({{0.15, 0.0}}, 0.05));
  EXPECT_LT(step, DegreesToRadians(20.0));
}

TEST(SearchWindow, HasTheStepsOfEquation8) {
  // 7 m in cells of 5 cm, and 30 degrees in steps of 5 cm at 10 m: 0.52360 / 0.0050000 = 104.7.
  const Pose2 guess(3.0, 4.0, 0.5);
  const SearchWindow window =
      MakeSearchWindow({{0.0, 10.0}, {1.0, 1.0}}, guess, 7.0, DegreesToRadians(30.0), 0.05);
  EXPECT_EQ(window.submap_from_scan_guess, guess);
  EXPECT_EQ(window.num_linear_steps, 140);
  EXPECT_EQ(window.num_angular_steps, 105);
  EXPECT_EQ(window.resolution, 0.05);
  EXPECT_EQ(window.angular_step, AngularStep({{0.0, 10.0}}, 0.05));
}

TEST(SearchWindow, IsRoundedUpToWholeSteps) {
  const PointCloud points = {{10.0, 0.0}};
  const double step = AngularStep(points, 0.05);
  const SearchWindow window = MakeSearchWindow(points, Pose2(), 0.11, 2.01 * step, 0.05);
  EXPECT_EQ(window.num_linear_steps, 3);
  EXPECT_EQ(window.num_angular_steps, 3);
  const SearchWindow none = MakeSearchWindow(points, Pose2(), 0.0, 0.0, 0.05);
  EXPECT_EQ(none.num_linear_steps, 0);
  EXPECT_EQ(none.num_angular_steps, 0);
}

TEST(PoseInWindow, LiesWholeStepsFromTheGuess) {
  const SearchWindow window{Pose2(3.0, 4.0, 3.1), 9, 9, 0.05, 0.01};
  EXPECT_EQ(PoseInWindow(window, {0, 0}, 0), window.submap_from_scan_guess);
  EXPECT_THAT(PoseInWindow(window, {-2, 7}, 5), PoseNear(Pose2(2.9, 4.35, 3.15), 1e-12, 1e-12));
  EXPECT_LT(PoseInWindow(window, {0, 0}, 5).rotation, 0.0);  // normalized
}

}  // namespace
}  // namespace loopscope
