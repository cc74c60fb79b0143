// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/trajectory.h"

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

const std::vector<Pose2> kPoses{
    {0.0, 0.0, 0.0}, {1.0, 0.0, DegreesToRadians(90.0)}, {1.0, 1.0, 0.0}};

TEST(TrajectoryLayerTest, IsOneLineThroughAllPoses) {
  const auto layer = TrajectoryLayer(kPoses, Color{1, 2, 3}, 2.0);
  EXPECT_EQ(DataOf(layer)->GetNumberOfLines(), 1);
  EXPECT_EQ(DataOf(layer)->GetNumberOfPoints(), 3);
  EXPECT_EQ(PointOf(layer, 2), Eigen::Vector2d(1.0, 1.0));
}

TEST(TrajectoryLayerTest, OfOnePoseIsNothing) {
  EXPECT_EQ(DataOf(TrajectoryLayer({Pose2()}, Color(), 2.0))->GetNumberOfPoints(), 0);
}

TEST(NodesLayerTest, GivesEachNodeItsColor) {
  const auto layer = NodesLayer(kPoses, {Color{1, 0, 0}, Color{2, 0, 0}, Color{3, 0, 0}}, 4.0);
  EXPECT_EQ(DataOf(layer)->GetNumberOfVerts(), 3);
  EXPECT_EQ(ColorOf(layer, 1), (Color{2, 0, 0}));
}

TEST(FramesLayerTest, DrawsXAndYOfEachFrame) {
  const Palette& palette = PaletteOf(Theme::kDefault);
  const auto layer = FramesLayer(kPoses, 0.5, 2.0, palette);
  EXPECT_EQ(DataOf(layer)->GetNumberOfLines(), 6);
  // The second frame looks along y.
  EXPECT_TRUE(PointOf(layer, 5).isApprox(Eigen::Vector2d(1.0, 0.5)));
  EXPECT_EQ(ColorOf(layer, 5), palette.axis_x);
  EXPECT_TRUE(PointOf(layer, 7).isApprox(Eigen::Vector2d(0.5, 0.0)));
  EXPECT_EQ(ColorOf(layer, 7), palette.axis_y);
}

}  // namespace
}  // namespace loopscope
