// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/robot.h"

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

TEST(RobotOutlineTest, PointsAhead) {
  const auto corners = RobotOutline(Pose2(1.0, 2.0, DegreesToRadians(90.0)), 0.5);
  ASSERT_EQ(corners.size(), 3u);
  EXPECT_TRUE(corners[0].isApprox(Eigen::Vector2d(1.0, 2.3)));
  EXPECT_NEAR(corners[1].y(), 1.8, 1e-9);
  EXPECT_NEAR(corners[2].y(), 1.8, 1e-9);
}

TEST(RobotLayerTest, DrawsTheMarkOverItsEdge) {
  constexpr Color kColor{1, 2, 3};
  const auto layer = RobotLayer(Pose2(), 1.0, 0.1, kColor);
  ASSERT_EQ(DataOf(layer)->GetNumberOfPolys(), 2);
  EXPECT_EQ(ColorOf(layer, 3), kColor);
  EXPECT_GT(PointOf(layer, 0).x(), PointOf(layer, 3).x());
}

}  // namespace
}  // namespace loopscope
