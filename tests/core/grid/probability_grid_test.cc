// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/probability_grid.h"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/ascii_grid.h"

namespace loopscope {
namespace {

TEST(ProbabilityGrid, BeginsUnknownEverywhere) {
  const ProbabilityGrid grid(0.05);
  EXPECT_EQ(grid.resolution(), 0.05);
  EXPECT_TRUE(grid.box().empty());
  EXPECT_FALSE(grid.known({0, 0}));
  EXPECT_EQ(grid.probability({0, 0}), kMinProbability);
}

TEST(ProbabilityGrid, UpdatesTheNamedCellsOnly) {
  ProbabilityGrid grid(0.05);
  grid.GrowToInclude({{-2, -1}, 4, 3});
  grid.Update({{-2, -1}, {1, 1}, {0, 0}}, OddsUpdate(0.7));
  grid.Update({{1, 1}}, OddsUpdate(0.2));
  EXPECT_EQ(Draw(grid, grid.box()), ToText({"   4",  //
                                            "  7 ",  //
                                            "7   "}));
}

TEST(ProbabilityGrid, DoesNotGrowBeyondWhatFitsInMemory) {
  ProbabilityGrid grid(0.05);
  grid.GrowToInclude({{0, 0}, 2, 2});
  for (const CellBox& far : {CellBox{{0, 0}, 100000, 100000}, {{-20000, -20000}, 1, 1}}) {
    EXPECT_THROW(grid.GrowToInclude(far), std::length_error);
  }
  EXPECT_EQ(grid.box(), (CellBox{{0, 0}, 2, 2}));
}

TEST(ProbabilityGrid, KeepsItsCellsRowByRowFromTheLowest) {
  const ProbabilityGrid grid = GridDrawn({"78",  //
                                          "12"},
                                         0.05, {-9, 4});
  ASSERT_EQ(grid.cells().size(), 4u);
  EXPECT_EQ(grid.cells()[0], ToCellValue(0.1));
  EXPECT_EQ(grid.cells()[1], ToCellValue(0.2));
  EXPECT_EQ(grid.cells()[2], ToCellValue(0.1 * 7));
  EXPECT_EQ(grid.cells()[3], ToCellValue(0.1 * 8));
}

TEST(ProbabilityGrid, MovesNoCellWhenItGrows) {
  const Drawing drawing = {"1 3",  //
                           "456"};
  const CellIndex low{10, -20};
  for (const CellIndex to : {CellIndex{7, -20}, {10, -23}, {15, -20}, {10, -15}, {0, 0}}) {
    ProbabilityGrid grid = GridDrawn(drawing, 0.05, low);
    grid.GrowToInclude({to, 1, 1});
    EXPECT_TRUE(grid.box().Contains(to));
    EXPECT_EQ(Draw(grid, {low, 3, 2}), ToText(drawing));
    EXPECT_FALSE(grid.known(to) && !CellBox({low, 3, 2}).Contains(to));
  }
}

TEST(ProbabilityGrid, MovesNoCellWhenItGrowsOverAndOver) {
  Random random(1);
  const OddsUpdate hit(0.7);
  ProbabilityGrid grid(0.05);
  std::vector<CellIndex> updated;
  for (int i = 0; i < 300; ++i) {
    const CellIndex cell{random.Below(200) - 100, random.Below(200) - 100};
    grid.GrowToInclude({cell, 1 + random.Below(5), 1 + random.Below(5)});
    if (grid.known(cell)) continue;
    grid.Update({cell}, hit);
    updated.push_back(cell);
    ASSERT_EQ(grid.cells().size(), static_cast<std::size_t>(grid.box().num_cells()));
  }
  for (const CellIndex cell : updated) EXPECT_EQ(grid.value(cell), hit(kUnknown));
  const auto num_known =
      std::count_if(grid.cells().begin(), grid.cells().end(), [](CellValue v) { return v != 0; });
  EXPECT_EQ(static_cast<std::size_t>(num_known), updated.size());
}

TEST(ProbabilityGrid, DoesNotGrowForABoxThatItHolds) {
  ProbabilityGrid grid = GridDrawn({"123", "456"}, 0.05, {5, 5});
  grid.GrowToInclude({{6, 6}, 1, 1});
  grid.GrowToInclude({});
  EXPECT_EQ(grid.box().min, (CellIndex{5, 5}));
  EXPECT_EQ(grid.box().width, 3);
  EXPECT_EQ(grid.box().height, 2);
}

}  // namespace
}  // namespace loopscope
