// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/packed_grid.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/simulated_room.h"

namespace loopscope {
namespace {

void ExpectSameBack(const ProbabilityGrid& grid) {
  const ProbabilityGrid back = PackedGrid(grid).Unpack();
  EXPECT_EQ(back.resolution(), grid.resolution());
  EXPECT_EQ(back.box().min, grid.box().min);
  EXPECT_EQ(back.box().width, grid.box().width);
  EXPECT_EQ(back.cells(), grid.cells());
}

TEST(PackedGrid, GivesAnyGridBack) {
  Random random(2);
  for (int round = 0; round < 20; ++round) {
    ProbabilityGrid grid(0.05);
    const int width = 1 + random.Below(80);
    grid.GrowToInclude({{-30, 7}, width, 1 + random.Below(50)});
    const OddsUpdate hit(0.55);
    for (int i = 0; i < 20 * round; ++i) {
      // Runs of known cells, some of them observed more often.
      const int x = random.Below(width);
      std::vector<CellIndex> run;
      for (int k = x; k < std::min(width, x + 7); ++k) run.push_back({k - 30, 7});
      grid.Update(run, hit);
    }
    ExpectSameBack(grid);
  }
}

TEST(PackedGrid, GivesEmptyAndUnknownGridsBack) {
  ExpectSameBack(ProbabilityGrid(0.1));
  ProbabilityGrid unknown(0.1);
  unknown.GrowToInclude({{0, 0}, 400, 300});  // more in a row than a count can say
  ExpectSameBack(unknown);
  EXPECT_LT(PackedGrid(unknown).num_bytes(), 20u);
}

TEST(PackedGrid, GivesMoreCellsOfOneValueBackThanACountCanSay) {
  const CellBox box{{5, -3}, 70000, 1};
  ExpectSameBack(ProbabilityGrid(0.1, box, std::vector<CellValue>(70000, 12345)));
}

TEST(PackedGrid, TakesLessThanTwoBytesForAKnownCell) {
  const SimulatedRoom room;
  const ProbabilityGrid& grid = room.grid();
  const auto num_unknown = std::count(grid.cells().begin(), grid.cells().end(), kUnknown);
  const std::size_t num_known = grid.cells().size() - static_cast<std::size_t>(num_unknown);
  ExpectSameBack(grid);
  EXPECT_LT(PackedGrid(grid).num_bytes(), 2 * num_known);
}

}  // namespace
}  // namespace loopscope
