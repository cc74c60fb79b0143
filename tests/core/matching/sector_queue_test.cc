// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/sector_queue.h"

#include <limits>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "core/matching/block_sums.h"
#include "core/matching/search_lattice.h"
#include "tests/support/random_world.h"

namespace loopscope {
namespace {

constexpr int kStartHeight = 3;
constexpr int kStep = 1 << kStartHeight;

/// A scan of points at all distances, some of which sweep many cells as it turns.
struct Setting {
  Setting(int seed, double linear_window)
      : random(seed),
        world(MakeRandomWorld(&random)),
        window(MakeSearchWindow(world.points_in_scan, world.submap_from_scan, linear_window, 0.7,
                                world.grid.resolution())),
        scan(window, world.points_in_scan) {}
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

  Random random;
  RandomWorld world;
  SearchWindow window;
  TurnedScan scan;
};

/// Of start nodes by offset and angle: how often they were in a sector.
using Coverage = std::map<std::tuple<int, int, int>, int>;

/// Counts the start nodes of `sector`, and expects none of them to have a greater sum.
void Visit(const Sector& sector, const Setting& setting, const PrecomputedGrids& grids,
           Coverage* coverage) {
  for (int angle = sector.first_angle; angle <= sector.last_angle; ++angle) {
    const auto cells = setting.scan.CellsAt(angle);
    for (int y = sector.first.y; y <= sector.last.y; y += kStep) {
      for (int x = sector.first.x; x <= sector.last.x; x += kStep) {
        ++(*coverage)[{x, y, angle}];
        EXPECT_LE(
            SumBlocks(grids.at_height(kStartHeight), cells.data(), cells.size(), {x, y}, 1)[0],
            sector.bound);
      }
    }
  }
}

TEST(SectorQueue, HoldsEveryStartNodeOnceWithABound) {
  for (const double linear_window : {2.0, 3.3, 4.0}) {
    for (int seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(seed);
      const Setting setting(seed, linear_window);
      const PrecomputedGrids grids(setting.world.grid, 7);
      SectorQueue sectors(grids, setting.window, setting.scan, kStartHeight, true);
      Coverage coverage;
      int last_bound = std::numeric_limits<int>::max();
      while (const auto sector = sectors.Pop(0)) {
        EXPECT_EQ(sector->level, 0);
        EXPECT_LE(sector->bound, last_bound);
        last_bound = sector->bound;
        Visit(*sector, setting, grids, &coverage);
      }
      const int w = setting.window.num_linear_steps;
      const int nodes_per_side = 2 * w / kStep + 1;
      EXPECT_EQ(static_cast<int>(coverage.size()),
                nodes_per_side * nodes_per_side * (2 * setting.window.num_angular_steps + 1));
      for (const auto& [node, count] : coverage) EXPECT_EQ(count, 1);
    }
  }
}

TEST(SectorQueue, GivesNoneBelowTheBoundAskedFor) {
  const Setting setting(1, 4.0);
  const PrecomputedGrids grids(setting.world.grid, 7);
  SectorQueue sectors(grids, setting.window, setting.scan, kStartHeight, true);
  const int best = sectors.Pop(0)->bound;
  while (const auto sector = sectors.Pop(best)) EXPECT_EQ(sector->bound, best);
  EXPECT_TRUE(sectors.Pop(0)) << "the others are still there";
}

TEST(SectorQueue, HoldsEveryStartNodeOnceWithoutBounds) {
  const Setting setting(1, 1.0);
  const PrecomputedGrids grids(setting.world.grid, 7);
  SectorQueue sectors(grids, setting.window, setting.scan, kStartHeight, false);
  Coverage coverage;
  while (const auto sector = sectors.Pop(0)) Visit(*sector, setting, grids, &coverage);
  const int nodes_per_side = 2 * setting.window.num_linear_steps / kStep + 1;
  EXPECT_EQ(static_cast<int>(coverage.size()),
            nodes_per_side * nodes_per_side * (2 * setting.window.num_angular_steps + 1));
}

}  // namespace
}  // namespace loopscope
