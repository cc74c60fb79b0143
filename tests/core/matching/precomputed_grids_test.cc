// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/precomputed_grids.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/random_world.h"

namespace loopscope {
namespace {

/// The oracle of eq. 17: looks at all cells of the block of `side` cells that begins at `low`.
int MaximumOfBlock(const PrecomputedGrid& finest, CellIndex low, int side) {
  int maximum = 0;
  for (int y = low.y; y < low.y + side; ++y) {
    for (int x = low.x; x < low.x + side; ++x) {
      maximum = std::max<int>(maximum, finest.value({x, y}));
    }
  }
  return maximum;
}

TEST(PrecomputedGrid, RoundsProbabilitiesTo256Steps) {
  Random random(1);
  const ProbabilityGrid grid = RandomGrid(&random);
  const PrecomputedGrid finest(grid);
  const CellBox& box = grid.box();
  for (int y = box.min.y - 2; y < box.min.y + box.height + 2; ++y) {
    for (int x = box.min.x - 2; x < box.min.x + box.width + 2; ++x) {
      EXPECT_NEAR(PrecomputedGrids::MeanProbability(finest.value({x, y}), 1),
                  grid.probability({x, y}), 0.5 * 0.8 / 255.0 + 1e-9);
    }
  }
}

TEST(PrecomputedGrid, GivesTheEndsOfTheScaleToTheEndsOfProbability) {
  const PrecomputedGrid finest(GridDrawn({"1 9"}, 0.05));
  EXPECT_EQ(finest.value({0, 0}), 0);
  EXPECT_EQ(finest.value({1, 0}), 0);
  EXPECT_EQ(finest.value({2, 0}), 255);
}

TEST(PrecomputedGrid, IsTheMaximumOfTheBlockThatBeginsAtTheCell) {
  Random random(2);
  for (int i = 0; i < 8; ++i) {
    const ProbabilityGrid grid = RandomGrid(&random);
    const PrecomputedGrids grids(grid, 7);
    const PrecomputedGrid& finest = grids.at_height(0);
    for (int height = 0; height <= grids.max_height(); ++height) {
      // Beyond the border by a block and one cell more.
      const int margin = (1 << height) + 1;
      const CellBox box{{grid.box().min.x - margin, grid.box().min.y - margin},
                        grid.box().width + 2 * margin,
                        grid.box().height + 2 * margin};
      for (int y = box.min.y; y < box.min.y + box.height; y += 3) {
        for (int x = box.min.x; x < box.min.x + box.width; x += 2) {
          ASSERT_EQ(grids.at_height(height).value({x, y}),
                    MaximumOfBlock(finest, {x, y}, 1 << height))
              << "height " << height << " at (" << x << ", " << y << ")";
        }
      }
    }
  }
}

TEST(PrecomputedGrid, LooksFartherByTheSweep) {
  Random random(3);
  const PrecomputedGrids grids(RandomGrid(&random), 5);
  for (const int height : {3, 4}) {
    const PrecomputedGrid& swept = grids.swept_at_height(height);
    const int side = 2 << height;
    const CellBox known = grids.at_height(0).box();
    for (int y = known.min.y - side - 1; y <= known.min.y + known.height; ++y) {
      for (int x = known.min.x - side - 1; x <= known.min.x + known.width; ++x) {
        ASSERT_EQ(swept.value({x, y}), MaximumOfBlock(grids.at_height(0), {x, y}, side));
      }
    }
  }
}

TEST(PrecomputedGrid, ReachesBelowTheLowBorderButNotAboveTheHigh) {
  const PrecomputedGrids grids(GridDrawn({"9"}, 0.05, {5, -3}), 4);
  const PrecomputedGrid& grid = grids.at_height(3);
  for (const CellIndex inside : {CellIndex{5, -3}, {-2, -3}, {5, -10}, {-2, -10}}) {
    EXPECT_EQ(grid.value(inside), 255) << inside.x << ", " << inside.y;
  }
  for (const CellIndex outside : {CellIndex{6, -3}, {5, -2}, {-3, -3}, {5, -11}}) {
    EXPECT_EQ(grid.value(outside), 0) << outside.x << ", " << outside.y;
  }
  EXPECT_EQ(grid.box().min, (CellIndex{-2, -10}));
  EXPECT_EQ(grid.box().width, 8);
  EXPECT_EQ(grid.box().height, 8);
}

TEST(PrecomputedGrids, HoldOneGridForEachHeight) {
  const PrecomputedGrids grids(GridDrawn({"123"}, 0.2), 5);
  EXPECT_EQ(grids.resolution(), 0.2);
  EXPECT_EQ(grids.max_height(), 4);
  for (int height = 0; height <= 4; ++height) EXPECT_EQ(grids.at_height(height).height(), height);
}

TEST(PrecomputedGrids, AverageSumsOfTheirValuesToProbabilities) {
  EXPECT_DOUBLE_EQ(PrecomputedGrids::MeanProbability(0, 3), 0.1);
  EXPECT_DOUBLE_EQ(PrecomputedGrids::MeanProbability(3 * 255, 3), 0.9);
  EXPECT_DOUBLE_EQ(PrecomputedGrids::MeanProbability(255, 2), 0.5);
}

}  // namespace
}  // namespace loopscope
