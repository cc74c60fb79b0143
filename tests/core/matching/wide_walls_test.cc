// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/wide_walls.h"

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/ascii_grid.h"

namespace loopscope {
namespace {

TEST(WithWideWalls, WallsAreACellWiderAndAllElseIsFree) {
  const ProbabilityGrid grid = GridDrawn(Drawing({"44444",  //
                                                  "49444",  //
                                                  "44444",  //
                                                  "   47"}),
                                         0.05, {10, 20});
  const ProbabilityGrid wide = WithWideWalls(grid, 0.5);
  EXPECT_EQ(wide.box(), (CellBox{{9, 19}, 7, 6}));
  // Half the way from 0.1 to 0.9, and to 0.7.
  EXPECT_EQ(Draw(wide, wide.box()), ToText(Drawing({"       ",  //
                                                    " 55511 ",  //
                                                    " 59511 ",  //
                                                    " 555444",  //
                                                    "    474",  //
                                                    "    444"})));
}

/// The definition, cell by cell.
CellValue PlainWideValue(const ProbabilityGrid& grid, CellIndex cell, double share_beside) {
  const auto wall = [&](CellIndex at) { return grid.value(at) > kMaxCellValue / 2; };
  double value = wall(cell) ? grid.value(cell) : grid.known(cell) ? 1 : 0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const CellIndex beside{cell.x + x, cell.y + y};
      if (wall(beside)) value = std::max(value, share_beside * grid.value(beside));
    }
  }
  return static_cast<CellValue>(value);
}

TEST(WithWideWalls, IsAsDefinedInGridsOfAnyWidth) {
  Random random(1);
  for (const int width : {1, 2, 7, 8, 33, 70}) {
    const CellBox box{{-3, 5}, width, 9};
    std::vector<CellValue> cells(box.num_cells());
    for (CellValue& cell : cells) {
      cell = static_cast<CellValue>(random.Below(3) == 0 ? 0 : random.Below(kMaxCellValue + 1));
    }
    const ProbabilityGrid grid(0.05, box, cells);
    for (const double share : {0.25, 1.0}) {
      const ProbabilityGrid wide = WithWideWalls(grid, share);
      for (int y = 3; y < 16; ++y) {
        for (int x = -5; x < width; ++x) {
          const CellIndex cell{x, y};
          ASSERT_EQ(wide.value(cell), PlainWideValue(grid, cell, share))
              << width << ": " << x << ", " << y;
        }
      }
    }
  }
}

TEST(WithWideWalls, OfNothingIsNothing) {
  EXPECT_TRUE(WithWideWalls(ProbabilityGrid(0.05), 0.5).box().empty());
}

}  // namespace
}  // namespace loopscope
