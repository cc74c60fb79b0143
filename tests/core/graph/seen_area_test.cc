// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/seen_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

constexpr double kResolution = 0.05;
constexpr double kBlock = 4 * kResolution;

void Observe(const std::vector<CellIndex>& cells, double probability, ProbabilityGrid* grid) {
  grid->GrowToInclude(BoxOf(cells));
  grid->Update(cells, OddsUpdate(probability));
}

TEST(SeenArea, IsWhereCellsAreKnownToBeFree) {
  ProbabilityGrid grid(kResolution);
  Observe({{10, 10}, {11, 10}}, 0.4, &grid);
  const SeenArea seen(grid);
  EXPECT_EQ(seen.DistanceTo({0.5, 0.5}), 0.0);
  EXPECT_NEAR(seen.DistanceTo({2.5, 0.5}), 2.0, 1.5 * kBlock);
  EXPECT_NEAR(seen.DistanceTo({0.5, -3.5}), 4.0, 1.5 * kBlock);
}

TEST(SeenArea, DoesNotHoldWalls) {
  ProbabilityGrid grid(kResolution);
  Observe({{0, 0}}, 0.4, &grid);
  Observe({{100, 0}}, 0.7, &grid);
  EXPECT_NEAR(SeenArea(grid).DistanceTo({5.0, 0.0}), 5.0, 0.05 * 5.0 + kBlock);
}

TEST(SeenArea, IsInfinitelyFarIfNothingIsKnown) {
  EXPECT_TRUE(std::isinf(SeenArea(ProbabilityGrid(kResolution)).DistanceTo({0.0, 0.0})));
}

TEST(SeenArea, TellsTheDistanceToTheNearestOfManyCells) {
  Random random(7);
  for (int i = 0; i < 20; ++i) {
    ProbabilityGrid grid(kResolution);
    std::vector<CellIndex> free;
    for (int k = 0; k < 5; ++k) free.push_back({random.Below(160) - 80, random.Below(120) - 60});
    Observe(free, 0.4, &grid);
    const SeenArea seen(grid);
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector2d place(random.Uniform(-4.0, 4.0), random.Uniform(-3.0, 3.0));
      double nearest = std::numeric_limits<double>::infinity();
      for (const CellIndex cell : free) {
        nearest = std::min(nearest, (CenterOf(cell, kResolution) - place).norm());
      }
      const Eigen::AlignedBox2d known = [&] {
        Eigen::AlignedBox2d box;
        for (const CellIndex cell : free) box.extend(CenterOf(cell, kResolution));
        return box;
      }();
      if (!known.contains(place)) continue;
      EXPECT_NEAR(seen.DistanceTo(place), nearest, 0.04 * nearest + std::sqrt(2.0) * kBlock);
    }
  }
}

}  // namespace
}  // namespace loopscope
