// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/outline.h"

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

TEST(OutlineLayerTest, GoesAlongTheEdgeOfTheExtent) {
  const Extent extent(Eigen::Vector2d(1.0, 2.0), Eigen::Vector2d(4.0, 6.0));
  const auto layer = OutlineLayer(extent, Color{1, 2, 3}, 2.0);
  EXPECT_EQ(DataOf(layer)->GetNumberOfLines(), 1);
  EXPECT_EQ(PointOf(layer, 0), extent.min());
  EXPECT_EQ(PointOf(layer, 2), extent.max());
  EXPECT_EQ(PointOf(layer, 4), extent.min());
}

TEST(CircleLayerTest, IsALineAtTheRadius) {
  const auto layer = CircleLayer({1.0, 2.0}, 0.5, Color{1, 2, 3}, 2.0);
  EXPECT_EQ(DataOf(layer)->GetNumberOfLines(), 1);
  for (vtkIdType i = 0; i < DataOf(layer)->GetNumberOfPoints(); ++i) {
    EXPECT_NEAR((PointOf(layer, i) - Eigen::Vector2d(1.0, 2.0)).norm(), 0.5, 1e-6);
  }
}

}  // namespace
}  // namespace loopscope
