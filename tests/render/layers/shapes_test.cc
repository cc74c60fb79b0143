// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/shapes.h"

#include <vtkProperty.h>

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

constexpr Color kRed{255, 0, 0};
constexpr Color kBlue{0, 0, 255, 128};

TEST(ShapesTest, EveryShapeKeepsItsColorAndPlace) {
  Shapes shapes;
  shapes.AddPoint({1.0, 2.0}, kRed);
  shapes.AddLine({3.0, 4.0}, {5.0, 6.0}, kBlue);
  const auto actor = MakeActor(shapes.Build());
  EXPECT_EQ(DataOf(actor)->GetNumberOfVerts(), 1);
  EXPECT_EQ(DataOf(actor)->GetNumberOfLines(), 1);
  EXPECT_EQ(PointOf(actor, 0), Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(ColorOf(actor, 0), kRed);
  EXPECT_EQ(PointOf(actor, 2), Eigen::Vector2d(5.0, 6.0));
  EXPECT_EQ(ColorOf(actor, 2), kBlue);
}

TEST(ShapesTest, LieAtTheHeightThatWasSet) {
  Shapes shapes;
  shapes.AddPoint({1.0, 2.0}, kRed);
  shapes.SetHeight(7.0);
  shapes.AddPoint({1.0, 2.0}, kRed);
  shapes.AddSlope({1.0, 2.0}, 3.0, {1.0, 2.0}, 4.0, kRed);
  shapes.AddPoint({1.0, 2.0}, kRed);
  const auto data = shapes.Build();
  const double expected[] = {0.0, 7.0, 3.0, 4.0, 7.0};
  ASSERT_EQ(data->GetNumberOfPoints(), 5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(data->GetPoint(i)[2], expected[i]) << i;
}

TEST(ShapesTest, AnOutlineIsClosed) {
  Shapes shapes;
  shapes.AddOutline({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}, kRed);
  const auto actor = MakeActor(shapes.Build());
  EXPECT_EQ(DataOf(actor)->GetNumberOfLines(), 1);
  ASSERT_EQ(DataOf(actor)->GetNumberOfPoints(), 4);
  EXPECT_EQ(PointOf(actor, 3), PointOf(actor, 0));
}

TEST(ShapesTest, ALineThroughOnePointIsNothing) {
  Shapes shapes;
  shapes.AddPolyline({{1.0, 1.0}}, kRed);
  EXPECT_TRUE(shapes.empty());
}

TEST(ShapesTest, ADiscReachesItsRadiusOnAllSides) {
  Shapes shapes;
  shapes.AddDisc({2.0, 3.0}, 0.5, kRed);
  const auto data = shapes.Build();
  const double* const bounds = data->GetBounds();
  EXPECT_NEAR(bounds[0], 1.5, 1e-6);
  EXPECT_NEAR(bounds[1], 2.5, 1e-6);
  EXPECT_NEAR(bounds[2], 2.5, 1e-6);
  EXPECT_NEAR(bounds[3], 3.5, 1e-6);
}

TEST(ShapesTest, ActorsAreBlendedInTheirOrder) {
  const auto actor = MakeActor(Shapes().Build(), {2.5, 4.0, false});
  EXPECT_TRUE(actor->HasTranslucentPolygonalGeometry());
  EXPECT_FALSE(actor->GetProperty()->GetLighting());
  EXPECT_FLOAT_EQ(actor->GetProperty()->GetLineWidth(), 2.5f);
  EXPECT_FLOAT_EQ(actor->GetProperty()->GetPointSize(), 4.0f);
}

TEST(RectangleCornersTest, AreTurnedWithTheirFrame) {
  const auto corners =
      RectangleCorners(Pose2(10.0, 0.0, DegreesToRadians(90.0)), {0.0, 0.0}, {2.0, 1.0});
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_TRUE(corners[0].isApprox(Eigen::Vector2d(10.0, 0.0)));
  EXPECT_TRUE(corners[1].isApprox(Eigen::Vector2d(10.0, 2.0)));
  EXPECT_TRUE(corners[2].isApprox(Eigen::Vector2d(9.0, 2.0)));
  EXPECT_TRUE(corners[3].isApprox(Eigen::Vector2d(9.0, 0.0)));
}

}  // namespace
}  // namespace loopscope
