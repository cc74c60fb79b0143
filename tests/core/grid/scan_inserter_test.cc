// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/scan_inserter.h"

#include <gtest/gtest.h>

#include "core/grid/ray_cast.h"
#include "core/simulation/random.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/plain_scan_insertion.h"

namespace loopscope {
namespace {

const CellBox kBox{{0, 0}, 4, 2};
const ScanCells kCells{{{3, 0}, {3, 1}}, {{0, 0}, {1, 0}, {2, 1}}, kBox};

TEST(ScanInserter, MakesHitsLikelierAndMissesUnlikelier) {
  ProbabilityGrid grid(0.05);
  ScanInserter({0.7, 0.4, true}).Insert(kCells, &grid);
  EXPECT_EQ(Draw(grid, kBox), ToText({"  47",  //
                                      "44 7"}));
}

TEST(ScanInserter, MultipliesTheOddsOfScans) {
  ProbabilityGrid grid(0.05);
  const ScanInserter inserter({0.7, 0.4, true});
  inserter.Insert(kCells, &grid);
  inserter.Insert({{{3, 0}}, {{3, 1}, {0, 0}}, kBox}, &grid);
  // Odds 7/3 * 7/3, 7/3 * 2/3 and 2/3 * 2/3.
  EXPECT_NEAR(grid.probability({3, 0}), 49.0 / 58.0, 1e-4);
  EXPECT_NEAR(grid.probability({3, 1}), 14.0 / 23.0, 1e-4);
  EXPECT_NEAR(grid.probability({0, 0}), 4.0 / 13.0, 1e-4);
  EXPECT_NEAR(grid.probability({1, 0}), 0.4, 1e-4);
}

TEST(ScanInserter, GrowsTheGridToTheBoxOfTheCells) {
  ProbabilityGrid grid(0.05);
  ScanInserter({0.7, 0.4, true}).Insert({{{10, 2}}, {{-5, -7}}, {{-5, -7}, 16, 10}}, &grid);
  EXPECT_EQ(grid.box().min, (CellIndex{-5, -7}));
  EXPECT_EQ(grid.box().width, 16);
  EXPECT_EQ(grid.box().height, 10);
}

TEST(ScanInserter, TakesCellsOfAnotherLattice) {
  const ScanCells cells{
      {{-27, 12}, {-27, 13}}, {{-30, 12}, {-29, 12}, {-28, 13}}, {{-30, 12}, 4, 2}};
  ProbabilityGrid grid(0.05);
  const ScanInserter inserter({0.7, 0.4, true});
  inserter.Insert(cells, &grid, {-30, 12});
  EXPECT_EQ(Draw(grid, kBox), ToText({"  47",  //
                                      "44 7"}));
  EXPECT_EQ(grid.box(), kBox);
}

TEST(ScanInserter, LeavesFreeSpaceUnknownIfToldSo) {
  ProbabilityGrid grid(0.05);
  ScanInserter({0.7, 0.4, false}).Insert(kCells, &grid);
  EXPECT_EQ(Draw(grid, kBox), ToText({"   7",  //
                                      "   7"}));
  EXPECT_EQ(grid.box().min, (CellIndex{3, 0})) << "no larger than what is known";
  EXPECT_EQ(grid.box().num_cells(), 2);
}

TEST(ScanInserter, UpdatesACellOnceAScanHoweverManyBeamsMeetIt) {
  // Two beams end in the cell (2, 0), and a third passes through it.
  const RangeData data{{0.0, 0.0}, {{2.0, 0.0}, {2.1, 0.1}, {4.0, 0.0}}, {}};
  ProbabilityGrid grid(1.0);
  ScanInserter({0.7, 0.4, true}).Insert(CastRays(data, 1.0), &grid);
  EXPECT_EQ(Draw(grid, {{0, 0}, 5, 1}), ToText({"44747"}));
}

TEST(ScanInserter, MakesTheMapOfThePlainGrid) {
  Random random(8);
  constexpr double kResolution = 0.05;
  ProbabilityGrid grid(kResolution);
  PlainGrid plain(kResolution);
  for (int scan = 0; scan < 20; ++scan) {
    RangeData data;
    data.origin = {random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0)};
    for (int i = 0; i < 40; ++i) {
      PointCloud& ends = i % 5 == 0 ? data.misses : data.returns;
      ends.emplace_back(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0));
    }
    ScanInserter({0.7, 0.4, true}).Insert(CastRays(data, kResolution), &grid);
    plain.Insert(data, 0.7, 0.4);
  }
  std::size_t num_known = 0;
  for (const CellValue value : grid.cells()) num_known += value == kUnknown ? 0 : 1;
  EXPECT_EQ(num_known, plain.probabilities().size());
  for (const auto& [cell, probability] : plain.probabilities()) {
    EXPECT_NEAR(grid.probability({cell.first, cell.second}), probability, 1e-3);
  }
}

}  // namespace
}  // namespace loopscope
