// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/grid_image.h"

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

constexpr double kResolution = 0.5;

/// Cell (2, 3) almost surely occupied, (3, 3) almost surely free, (4, 4) as likely as not.
ProbabilityGrid SmallGrid() {
  ProbabilityGrid grid(kResolution);
  grid.GrowToInclude({{2, 3}, 3, 2});
  grid.Update({{2, 3}}, OddsUpdate(kMaxProbability));
  grid.Update({{3, 3}}, OddsUpdate(kMinProbability));
  grid.Update({{4, 4}}, OddsUpdate(0.5));
  return grid;
}

MapColors Colors() { return PlainMapColors(PaletteOf(Theme::kDefault)); }

TEST(GridImageTest, IsBlackWhereOccupiedWhiteWhereFreeAndClearWhereUnknown) {
  const CellImage image = GridImage(SmallGrid(), Colors());
  EXPECT_EQ(image.At({2, 3}), (Color{0, 0, 0}));
  EXPECT_EQ(image.At({3, 3}), (Color{255, 255, 255}));
  EXPECT_EQ(image.At({2, 4}).a, 0);
}

TEST(GridImageTest, IsGreyInBetween) {
  const Color grey = GridImage(SmallGrid(), Colors()).At({4, 4});
  EXPECT_NEAR(grey.r, 127, 1);
  EXPECT_EQ(grey.r, grey.g);
  EXPECT_EQ(grey.a, 255);
}

TEST(GridImageTest, HasTheBoxOfTheGrid) {
  const CellBox box = GridImage(SmallGrid(), Colors()).box();
  EXPECT_EQ(box.min, (CellIndex{2, 3}));
  EXPECT_EQ(box.width, 3);
  EXPECT_EQ(box.height, 2);
}

TEST(CellImageLayerTest, EndsHalfACellBeyondTheOuterGridPoints) {
  const auto layer = CellImageLayer(GridImage(SmallGrid(), Colors()), Pose2(), kResolution);
  EXPECT_EQ(PointOf(layer, 0), Eigen::Vector2d(0.75, 1.25));
  EXPECT_EQ(PointOf(layer, 2), Eigen::Vector2d(2.25, 2.25));
}

TEST(CellImageLayerTest, LiesAtThePoseOfItsGrid) {
  const Pose2 map_from_grid(100.0, 50.0, DegreesToRadians(90.0));
  const auto layer = CellImageLayer(GridImage(SmallGrid(), Colors()), map_from_grid, kResolution);
  EXPECT_TRUE(PointOf(layer, 0).isApprox(Eigen::Vector2d(98.75, 50.75)));
  EXPECT_TRUE(PointOf(layer, 2).isApprox(Eigen::Vector2d(97.75, 52.25)));
}

TEST(CellImageLayerTest, HasTheLowestRowFirstAndNoInterpolation) {
  const auto layer = CellImageLayer(GridImage(SmallGrid(), Colors()), Pose2(), kResolution);
  vtkImageData* const image = ImageOf(layer);
  EXPECT_EQ(ColorOf(image->GetPointData()->GetScalars(), 0), (Color{0, 0, 0}));
  EXPECT_EQ(ColorOf(image->GetPointData()->GetScalars(), 1), (Color{255, 255, 255}));
  EXPECT_FALSE(layer->GetTexture()->GetInterpolate());
  EXPECT_FALSE(layer->GetTexture()->GetMipmap());
}

TEST(CellImageLayerTest, OfNothingIsNothing) {
  const auto layer = CellImageLayer(CellImage(CellBox()), Pose2(), kResolution);
  EXPECT_EQ(DataOf(layer)->GetNumberOfPoints(), 0);
}

TEST(OddsScaleTest, IsEvenInTheLogarithmOfTheOdds) {
  EXPECT_NEAR(PlaceOnOddsScale(kMinProbability), 0.0, 1e-12);
  EXPECT_NEAR(PlaceOnOddsScale(0.5), 0.5, 1e-12);
  EXPECT_NEAR(PlaceOnOddsScale(kMaxProbability), 1.0, 1e-12);
  EXPECT_NEAR(PlaceOnOddsScale(0.75), 0.75, 1e-12);  // odds 3 are half the way to odds 9
}

TEST(OddsImageTest, ShowsOnlyTheCellsAskedFor) {
  const Palette& palette = PaletteOf(Theme::kDefault);
  const CellImage image = OddsImage(SmallGrid(), {{2, 3}, {4, 4}, {3, 5}}, palette);
  EXPECT_EQ(image.At({2, 3}), palette.odds.At(1.0));
  EXPECT_EQ(image.At({4, 4}).a, 255);
  EXPECT_EQ(image.At({3, 5}), palette.never_seen);
  EXPECT_EQ(image.At({3, 3}).a, 0);
}

TEST(CellsImageTest, PaintsTheCellsAndNothingElse) {
  constexpr Color kMiss{1, 2, 3, 100};
  const CellImage image = CellsImage({{-1, 0}, {1, 1}}, kMiss);
  EXPECT_EQ(image.At({-1, 0}), kMiss);
  EXPECT_EQ(image.At({1, 1}), kMiss);
  EXPECT_EQ(image.At({0, 0}).a, 0);
}

}  // namespace
}  // namespace loopscope
