// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/map_image.h"

#include <vtkTexture.h>

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

constexpr double kResolution = 0.05;
const MapColors kColors = PlainMapColors(PaletteOf(Theme::kDefault));

/// A square of 2 m of free cells with a wall, one cell thick, along its middle (y = 0).
std::shared_ptr<ProbabilityGrid> WallGrid() {
  auto grid = std::make_shared<ProbabilityGrid>(kResolution);
  std::vector<CellIndex> wall;
  std::vector<CellIndex> free;
  for (int x = -20; x <= 20; ++x) {
    for (int y = -20; y <= 20; ++y) (y == 0 ? wall : free).push_back({x, y});
  }
  grid->GrowToInclude({{-20, -20}, 41, 41});
  grid->Update(wall, OddsUpdate(0.8));
  grid->Update(free, OddsUpdate(0.2));
  return grid;
}

/// A raster around the origin.
Raster RasterOf(double size, double pixel_size) {
  const int count = static_cast<int>(size / pixel_size);
  return {Eigen::Vector2d::Constant(-0.5 * pixel_size * (count - 1)), pixel_size, count, count};
}

int NumDark(const CellImage& image) {
  int count = 0;
  const CellBox& box = image.box();
  for (int y = box.min.y; y < box.min.y + box.height; ++y) {
    for (int x = box.min.x; x < box.min.x + box.width; ++x) {
      const Color color = image.At({x, y});
      count += color.a > 0 && color.r < 128;
    }
  }
  return count;
}

class MapComposerTest : public testing::TestWithParam<double> {};

TEST_P(MapComposerTest, NoTurnBreaksAWallOrTearsAHole) {
  const double pixel_size = GetParam() * kResolution;
  for (double turn = 0.0; turn < M_PI; turn += 0.1) {
    const Pose2 map_from_grid(0.01, -0.02, turn);
    const Raster raster = RasterOf(1.2, pixel_size);
    const auto image = MapComposer().Compose({{WallGrid(), map_from_grid}}, raster, kColors);
    for (int y = 0; y < raster.height; ++y) {
      for (int x = 0; x < raster.width; ++x) ASSERT_EQ(image->At({x, y}).a, 255) << turn;
    }
    // Along the wall every pixel is dark: at least one for each step of the raster.
    EXPECT_GE(NumDark(*image), 1.2 / pixel_size - 2.0) << turn;
  }
}

INSTANTIATE_TEST_SUITE_P(CellsAPixel, MapComposerTest,
                         testing::Values(0.3, 0.5, 0.7, 0.72, 1.0, 1.4, 1.42, 2.0, 3.5, 8.0));

TEST(MapComposerSingleTest, PutsAGridAtItsPose) {
  auto grid = std::make_shared<ProbabilityGrid>(kResolution);
  grid->GrowToInclude({{0, 0}, 1, 1});
  grid->Update({{0, 0}}, OddsUpdate(kMaxProbability));
  const Raster raster{{0.0, 0.0}, kResolution, 40, 40};
  const auto image = MapComposer().Compose({{grid, Pose2(1.0, 0.5, 0.3)}}, raster, kColors);
  EXPECT_EQ(image->At({20, 10}), (Color{0, 0, 0}));
  EXPECT_EQ(image->At({21, 12}).a, 0);
  EXPECT_EQ(NumDark(*image), 1);
}

TEST(MapComposerSingleTest, MultipliesTheOddsOfOverlappingGrids) {
  const std::vector<PlacedGrid> one{{WallGrid(), Pose2()}};
  const std::vector<PlacedGrid> two{{WallGrid(), Pose2()}, {WallGrid(), Pose2()}};
  const std::vector<PlacedGrid> crossed{{WallGrid(), Pose2()},
                                        {WallGrid(), Pose2(0.0, 0.0, DegreesToRadians(90.0))}};
  const Raster raster = RasterOf(1.05, kResolution);
  const CellIndex on_wall{3, 10};
  EXPECT_LT(MapComposer().Compose(two, raster, kColors)->At(on_wall).r,
            MapComposer().Compose(one, raster, kColors)->At(on_wall).r);
  // Odds of 4 and of 1/4 cancel.
  EXPECT_NEAR(MapComposer().Compose(crossed, raster, kColors)->At(on_wall).r, 127, 2);
}

TEST(MapComposerSingleTest, LooksTheSameHoweverManyGridsThereAreElsewhere) {
  std::vector<PlacedGrid> grids;
  for (int i = 0; i < 10; ++i) grids.push_back({WallGrid(), Pose2(5.0 * i, 0.0, 0.2 * i)});
  const Raster raster = RasterOf(1.5, kResolution);
  const auto all = MapComposer().Compose(grids, raster, kColors);
  const auto one = MapComposer().Compose({grids[0]}, raster, kColors);
  for (int y = 0; y < raster.height; ++y) {
    for (int x = 0; x < raster.width; ++x) ASSERT_EQ(all->At({x, y}), one->At({x, y}));
  }
}

TEST(MapComposerSingleTest, RemembersNothingThatIsNotSoAnyMore) {
  std::vector<PlacedGrid> grids;
  for (int i = 0; i < 6; ++i) grids.push_back({WallGrid(), Pose2(0.1 * i, 0.0, 0.2 * i)});
  std::vector<PlacedGrid> moved = grids;
  moved[1].map_from_grid = Pose2(0.0, 0.3, 0.1);
  std::vector<PlacedGrid> grown = grids;
  grown.back().grid = WallGrid();
  grown.push_back({WallGrid(), Pose2(0.3, 0.1, 0.0)});
  const std::vector<PlacedGrid> fewer(grids.begin(), grids.begin() + 3);
  MapComposer composer;
  for (const double cells_per_pixel : {0.5, 1.0}) {
    const Raster raster = RasterOf(1.5, cells_per_pixel * kResolution);
    for (const auto& next : {fewer, grids, grids, grown, moved, fewer, {}, grids}) {
      const auto image = composer.Compose(next, raster, kColors);
      const auto expected = MapComposer().Compose(next, raster, kColors);
      for (int y = 0; y < raster.height; ++y) {
        for (int x = 0; x < raster.width; ++x) ASSERT_EQ(image->At({x, y}), expected->At({x, y}));
      }
    }
  }
}

TEST(MapComposerSingleTest, IsEmptyWhereThereIsNoGrid) {
  const std::vector<PlacedGrid> elsewhere{{WallGrid(), Pose2(50.0, 0.0, 0.3)}};
  for (const double cells_per_pixel : {0.5, 1.0}) {
    MapComposer composer;
    for (int image = 0; image < 3; ++image) {
      EXPECT_TRUE(
          composer.Compose(elsewhere, RasterOf(1.5, cells_per_pixel * kResolution), kColors)
              ->box()
              .empty());
    }
  }
}

TEST(MapComposerSingleTest, ChangesNoImageThatSomebodyHas) {
  std::vector<PlacedGrid> grids{{WallGrid(), Pose2()}};
  const Raster raster = RasterOf(1.5, kResolution);
  MapComposer composer;
  composer.Compose(grids, raster, kColors);
  const auto image = composer.Compose(grids, raster, kColors);
  const auto layer =
      CellImageLayer(*composer.Compose(grids, raster, kColors), Pose2(), kResolution);
  vtkImageData* const shown = layer->GetTexture()->GetInput();
  const auto* const pixel = static_cast<const Color*>(shown->GetScalarPointer(15, 15, 0));
  const Color before = *pixel;
  EXPECT_EQ(image->At({15, 15}), before);
  grids[0].map_from_grid = Pose2(0.0, 0.3, 0.0);
  composer.Compose(grids, raster, kColors);
  EXPECT_EQ(*pixel, before);
  EXPECT_EQ(image->At({15, 15}), before);
}

TEST(RasterForTest, HasThePixelsOfThePanelWhereTheyAreLarge) {
  const Raster raster = RasterFor({{3.0, 4.0}, 0.2}, {0.0, 0.0, 100.0, 50.0}, kResolution);
  EXPECT_EQ(raster.width, 100);
  EXPECT_EQ(raster.height, 50);
  EXPECT_DOUBLE_EQ(raster.pixel_size, 0.2);
  EXPECT_TRUE(raster.origin.isApprox(Eigen::Vector2d(3.0 - 9.9, 4.0 - 4.9)));
}

TEST(RasterForTest, HasHalfCellsInACloseUp) {
  const Raster raster = RasterFor({{0.0, 0.0}, 0.001}, {0.0, 0.0, 1000.0, 500.0}, kResolution);
  EXPECT_DOUBLE_EQ(raster.pixel_size, 0.025);
  EXPECT_EQ(raster.width, 40);
  EXPECT_EQ(raster.height, 20);
}

TEST(ExtentOfTest, HoldsTheTurnedGrid) {
  const Extent extent = ExtentOf(PlacedGrid{WallGrid(), Pose2(7.0, 0.0, DegreesToRadians(45.0))});
  EXPECT_NEAR(extent.center().x(), 7.0, 1e-9);
  EXPECT_NEAR(extent.sizes().x(), 2.0 * std::sqrt(2.0), 1e-9);
  EXPECT_TRUE(ExtentOf(PlacedGrid{std::make_shared<ProbabilityGrid>(0.05), Pose2()}).isEmpty());
}

}  // namespace
}  // namespace loopscope
