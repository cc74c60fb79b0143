// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/scan.h"

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

constexpr Color kColor{10, 20, 30};
const PointCloud kPoints{{1.0, 0.0}, {0.0, 2.0}};
const Pose2 kTurned(5.0, 5.0, DegreesToRadians(90.0));

TEST(ScanLayerTest, PutsEveryPointWhereThePoseSays) {
  const auto layer = ScanLayer(kPoints, kTurned, kColor, 3.0);
  EXPECT_EQ(DataOf(layer)->GetNumberOfVerts(), 2);
  EXPECT_TRUE(PointOf(layer, 0).isApprox(Eigen::Vector2d(5.0, 6.0)));
  EXPECT_TRUE(PointOf(layer, 1).isApprox(Eigen::Vector2d(3.0, 5.0)));
  EXPECT_EQ(ColorOf(layer, 1), kColor);
}

TEST(RaysLayerTest, HasALineFromTheScannerForEachReturnAndMiss) {
  const RangeData data{{1.0, 1.0}, kPoints, {{9.0, 9.0}}};
  const auto layer = RaysLayer(data, kColor, 1.0);
  EXPECT_EQ(DataOf(layer)->GetNumberOfLines(), 3);
  for (const vtkIdType begin : {0, 2, 4}) EXPECT_EQ(PointOf(layer, begin), data.origin);
  EXPECT_EQ(PointOf(layer, 5), Eigen::Vector2d(9.0, 9.0));
}

TEST(MovesLayerTest, LeadsFromTheFirstPoseToTheSecond) {
  const auto layer = MovesLayer(kPoints, Pose2(), kTurned, kColor, 1.0);
  EXPECT_EQ(DataOf(layer)->GetNumberOfLines(), 2);
  EXPECT_EQ(PointOf(layer, 0), Eigen::Vector2d(1.0, 0.0));
  EXPECT_TRUE(PointOf(layer, 1).isApprox(Eigen::Vector2d(5.0, 6.0)));
}

}  // namespace
}  // namespace loopscope
