// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/vector_targets.h"

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "core/matching/bicubic_grid.h"
#include "core/matching/block_sums.h"
#include "core/matching/precomputed_grids.h"
#include "core/matching/search_lattice.h"
#include "core/matching/shifted_sums.h"
#include "core/matching/turned_scan.h"
#include "core/matching/wide_walls.h"
#include "tests/support/random_world.h"

namespace loopscope {
namespace {

std::int64_t BitsOf(double number) {
  std::int64_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  return bits;
}

/// What the inner loops compute, with all numbers in a row.
std::vector<std::int64_t> Compute(std::uint64_t seed) {
  Random random(seed);
  const RandomWorld world = MakeRandomWorld(&random);
  const SearchWindow window =
      MakeSearchWindow(world.points_in_scan, world.submap_from_scan, 0.3, 0.2, 0.05);
  const TurnedScan scan(window, world.points_in_scan);
  const PrecomputedGrids grids(world.grid, 4);
  std::vector<std::int64_t> numbers;
  const SmoothValues smooth = BicubicGrid(world.grid).At(world.points_in_scan);
  for (const auto* values : {&smooth.values, &smooth.slopes_x, &smooth.slopes_y,
                             &smooth.curvatures_xx, &smooth.curvatures_xy, &smooth.curvatures_yy}) {
    for (const double value : *values) numbers.push_back(BitsOf(value));
  }
  const ProbabilityGrid wide = WithWideWalls(world.grid, 0.5);
  numbers.insert(numbers.end(), wide.cells().begin(), wide.cells().end());
  for (const CellIndex cell : scan.LowestCells(-3, 3)) {
    numbers.insert(numbers.end(), {cell.x, cell.y});
  }
  for (int angle = -3; angle <= 3; ++angle) {
    const std::vector<CellIndex> cells = scan.CellsAt(angle);
    for (const CellIndex cell : cells) numbers.insert(numbers.end(), {cell.x, cell.y});
    for (const int radius : {2, 3}) {
      std::vector<std::uint32_t> sums((2 * radius + 1) * (2 * radius + 1), 0);
      AddShifted(world.grid, cells.data(), cells.size(), radius, sums.data());
      numbers.insert(numbers.end(), sums.begin(), sums.end());
    }
    for (const int height : {0, 3}) {
      for (const int num_rows : {3, kBlocksPerSide}) {
        const BlockSums sums =
            SumBlocks(grids.at_height(height), cells.data(), cells.size(), {-5, -6}, num_rows);
        numbers.insert(numbers.end(), sums.begin(), sums.begin() + num_rows * kBlocksPerSide);
      }
    }
  }
  return numbers;
}

TEST(VectorTargets, AllComputeTheSame) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<std::int64_t> usual = Compute(seed);
    ForEachVectorTarget([&] { EXPECT_EQ(Compute(seed), usual); });
  }
}

}  // namespace
}  // namespace loopscope
