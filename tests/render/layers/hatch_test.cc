// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/hatch.h"

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

Extent Area(double left, double bottom, double right, double top) {
  return {Eigen::Vector2d(left, bottom), Eigen::Vector2d(right, top)};
}

/// x - y of each line.
std::set<double> ShiftsOf(vtkActor* layer) {
  std::set<double> shifts;
  for (vtkIdType i = 0; i < DataOf(layer)->GetNumberOfPoints(); ++i) {
    const Eigen::Vector2d point = PointOf(layer, i);
    shifts.insert(point.x() - point.y());
  }
  return shifts;
}

TEST(HatchLayerTest, DrawsDiagonalsFromEdgeToEdge) {
  const Extent area = Area(0.0, 0.0, 4.0, 2.0);
  const auto layer = HatchLayer({area}, std::sqrt(0.5), Color{}, 1.0);  // x - y in whole metres
  EXPECT_EQ(DataOf(layer)->GetNumberOfLines(), 5);                      // -1, 0, 1, 2, 3
  for (vtkIdType i = 0; i < 10; ++i) {
    const Eigen::Vector2d point = PointOf(layer, i);
    EXPECT_TRUE(area.contains(point));
    EXPECT_NEAR(area.exteriorDistance(point), 0.0, 1e-6);
    const bool at_edge =
        point.x() < 1e-6 || point.y() < 1e-6 || point.x() > 4.0 - 1e-6 || point.y() > 2.0 - 1e-6;
    EXPECT_TRUE(at_edge) << point.transpose();
  }
}

TEST(HatchLayerTest, GoesOnFromOneAreaIntoTheNext) {
  const double spacing = std::sqrt(0.5);
  const auto whole = HatchLayer({Area(0.0, 0.0, 4.0, 4.0)}, spacing, Color{}, 1.0);
  const auto halves =
      HatchLayer({Area(0.0, 0.0, 2.0, 4.0), Area(2.0, 0.0, 4.0, 4.0)}, spacing, Color{}, 1.0);
  EXPECT_EQ(ShiftsOf(halves), ShiftsOf(whole));
}

}  // namespace
}  // namespace loopscope
