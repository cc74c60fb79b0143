// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/ray_cast.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/ascii_grid.h"

namespace loopscope {
namespace {

/// The cells of a scan at resolution 1, where the cell (x, y) is the unit square around (x, y).
std::string DrawScan(const RangeData& data, const CellBox& box) {
  return Draw(CastRays(data, 1.0), box);
}

TEST(CastRays, RefusesRaysWhoseCellsDoNotFitInMemory) {
  const RangeData data{{0.0, 0.0}, {{5000.0, 5000.0}}, {}};
  EXPECT_THROW(CastRays(data, 0.05), std::length_error);
  EXPECT_EQ(CastRays(data, 5.0).hits.size(), 1u);
}

/// Whether the segment meets the square of 2 * `half_width` around `center`, edges included; by
/// clipping it (Liang and Barsky 1984).
bool Crosses(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& center,
             double half_width) {
  double begin = 0.0;
  double end = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double along = to[axis] - from[axis];
    const double low = center[axis] - half_width - from[axis];
    const double high = center[axis] + half_width - from[axis];
    if (along == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    begin = std::max(begin, std::min(low / along, high / along));
    end = std::min(end, std::max(low / along, high / along));
  }
  return begin <= end;
}

bool AnyRayCrosses(const RangeData& data, const Eigen::Vector2d& center, double half_width) {
  const auto crosses = [&](const Eigen::Vector2d& to) {
    return Crosses(data.origin, to, center, half_width);
  };
  return std::any_of(data.returns.begin(), data.returns.end(), crosses) ||
         std::any_of(data.misses.begin(), data.misses.end(), crosses);
}

bool AnyReturnIn(const RangeData& data, CellIndex cell, double resolution) {
  return std::any_of(data.returns.begin(), data.returns.end(), [&](const Eigen::Vector2d& point) {
    return CellOf(point, resolution) == cell;
  });
}

/// What the oracle says, drawn; a cell is crossed if its pixel, grown by `margin` [m], is.
std::string DrawByClipping(const RangeData& data, double resolution, const CellBox& box,
                           double margin) {
  ScanCells cells;
  for (int y = box.min.y; y < box.min.y + box.height; ++y) {
    for (int x = box.min.x; x < box.min.x + box.width; ++x) {
      const CellIndex cell{x, y};
      if (AnyReturnIn(data, cell, resolution)) {
        cells.hits.push_back(cell);
      } else if (AnyRayCrosses(data, CenterOf(cell, resolution), 0.5 * resolution + margin)) {
        cells.misses.push_back(cell);
      }
    }
  }
  return Draw(cells, box);
}

PointCloud RandomEnds(int count, const Eigen::Vector2d& origin, Random* random) {
  PointCloud ends;
  for (int i = 0; i < count; ++i) {
    const double angle = random->Uniform(-M_PI, M_PI);
    ends.push_back(origin +
                   random->Uniform(0.0, 1.4) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return ends;
}

TEST(CastRays, DrawsALevelRay) {
  EXPECT_EQ(DrawScan({{0.0, 0.0}, {{4.0, 0.0}}, {}}, {{-1, -1}, 7, 3}), ToText({"       ",  //
                                                                                " ....# ",  //
                                                                                "       "}));
}

TEST(CastRays, DrawsAnUprightRayDownwards) {
  EXPECT_EQ(DrawScan({{0.0, 0.0}, {{0.0, -3.0}}, {}}, {{-1, -3}, 3, 4}), ToText({" . ",  //
                                                                                 " . ",  //
                                                                                 " . ",  //
                                                                                 " # "}));
}

TEST(CastRays, FollowsASteepRayCellByCell) {
  // Leaves the left column at y = 1.25, within the second row.
  EXPECT_EQ(DrawScan({{0.0, 0.0}, {{1.2, 3.0}}, {}}, {{0, 0}, 2, 4}), ToText({" #",  //
                                                                              " .",  //
                                                                              "..",  //
                                                                              ". "}));
}

TEST(CastRays, VisitsBothCellsWhereARayCutsACorner) {
  EXPECT_EQ(DrawScan({{0.3, 0.0}, {{2.3, 2.0}}, {}}, {{0, 0}, 3, 3}), ToText({"  #",  //
                                                                              " ..",  //
                                                                              ".. "}));
}

TEST(CastRays, BeginsAtThePlaceOfTheScannerWithinItsCell) {
  // From the same cell to the same cell, but by other cells on the way.
  EXPECT_EQ(DrawScan({{0.0, 0.4}, {{4.0, 1.4}}, {}}, {{0, 0}, 5, 2}), ToText({"....#",  //
                                                                              ".    "}));
  EXPECT_EQ(DrawScan({{0.0, -0.4}, {{4.0, 0.6}}, {}}, {{0, 0}, 5, 2}), ToText({"    #",  //
                                                                               "....."}));
}

TEST(CastRays, EndsMissesWithAMissedCell) {
  EXPECT_EQ(DrawScan({{0.0, 0.0}, {}, {{3.0, 0.0}}}, {{-1, 0}, 6, 1}), ToText({" .... "}));
}

TEST(CastRays, LetsHitsWinOverRaysThatPass) {
  EXPECT_EQ(DrawScan({{0.0, 0.0}, {{5.0, 0.0}, {2.0, 0.0}}, {{4.0, 0.0}}}, {{0, 0}, 6, 1}),
            ToText({"..#..#"}));
}

TEST(CastRays, ListsACellOnceHoweverManyRaysMeetIt) {
  const RangeData data{{0.0, 0.0}, {{3.0, 0.0}, {3.2, 0.2}, {3.2, -0.2}}, {{0.0, 2.0}}};
  EXPECT_EQ(DrawScan(data, {{0, 0}, 4, 3}), ToText({".   ",  //
                                                    ".   ",  //
                                                    "...#"}));
}

TEST(CastRays, MayHitTheCellOfTheScanner) {
  EXPECT_EQ(DrawScan({{0.1, 0.1}, {{-0.1, 0.2}}, {}}, {{-1, -1}, 3, 3}), ToText({"   ",  //
                                                                                 " # ",  //
                                                                                 "   "}));
}

TEST(CastRays, OfNothingIsNothing) {
  const ScanCells cells = CastRays({{0.3, 0.4}, {}, {}}, 0.05);
  EXPECT_TRUE(cells.hits.empty());
  EXPECT_TRUE(cells.misses.empty());
  EXPECT_TRUE(cells.box.empty());
}

TEST(CastRays, BoxesInWhatItFound) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    RangeData data;
    data.origin = {random.Uniform(-9.0, 9.0), random.Uniform(-9.0, 9.0)};
    data.returns = RandomEnds(random.Below(6), data.origin, &random);
    data.misses = RandomEnds(random.Below(3), data.origin, &random);
    const ScanCells cells = CastRays(data, 0.01);
    const CellBox box = Union(BoxOf(cells.hits), BoxOf(cells.misses));
    EXPECT_EQ(cells.box.min, box.min) << i;
    EXPECT_EQ(cells.box.width, box.width) << i;
    EXPECT_EQ(cells.box.height, box.height) << i;
  }
}

TEST(CastRays, ListsHitsInTheOrderOfTheReturns) {
  const ScanCells cells = CastRays({{0.0, 0.0}, {{3.0, 1.0}, {-2.0, 0.0}, {0.0, 5.0}}, {}}, 1.0);
  EXPECT_EQ(cells.hits, (std::vector<CellIndex>{{3, 1}, {-2, 0}, {0, 5}}));
}

TEST(CastRays, FindsTheCellsThatClippingFinds) {
  Random random(1);
  for (int i = 0; i < 40; ++i) {
    RangeData data;
    data.origin = {random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5)};
    data.returns = RandomEnds(1 + random.Below(30), data.origin, &random);
    data.misses = RandomEnds(random.Below(10), data.origin, &random);
    const CellBox box{{-40, -40}, 81, 81};
    EXPECT_EQ(Draw(CastRays(data, 0.05), box), DrawByClipping(data, 0.05, box, 0.0)) << i;
  }
}

TEST(CastRays, FindsTheCellsThatClippingFindsForRaysNearlyAlongALine) {
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    RangeData data;
    data.origin = {random.Uniform(-9.0, 9.0), 0.5 - 1e-4};
    data.returns = {{random.Uniform(-9.0, 9.0), 0.5 + 1e-4}, {data.origin.x() + 1e-4, 9.0}};
    const CellBox box{{-10, -2}, 21, 14};
    EXPECT_EQ(Draw(CastRays(data, 1.0), box), DrawByClipping(data, 1.0, box, 0.0)) << i;
  }
}

TEST(CastRays, OfRaysThroughCornersTouchesOrCrossesEveryCellThatItLists) {
  // All ends on corners and centres of pixels: what is crossed is in, what is not touched is out.
  Random random(3);
  const auto on_half = [&] { return 0.5 * (random.Below(25) - 12); };
  for (int i = 0; i < 300; ++i) {
    const RangeData data{{on_half(), on_half()}, {}, {{on_half(), on_half()}}};
    const CellBox box{{-8, -8}, 17, 17};
    const std::string drawn = Draw(CastRays(data, 1.0), box);
    const std::string crossed = DrawByClipping(data, 1.0, box, -1e-9);
    const std::string touched = DrawByClipping(data, 1.0, box, 1e-9);
    for (std::size_t c = 0; c < drawn.size(); ++c) {
      if (crossed[c] == '.') {
        EXPECT_EQ(drawn[c], '.') << "scan " << i << "\n" << drawn;
      }
      if (touched[c] == ' ') {
        EXPECT_EQ(drawn[c], ' ') << "scan " << i << "\n" << drawn;
      }
    }
  }
}

}  // namespace
}  // namespace loopscope
