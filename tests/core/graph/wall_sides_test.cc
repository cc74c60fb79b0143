// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/wall_sides.h"

#include <gtest/gtest.h>

#include "core/grid/ray_cast.h"
#include "core/grid/scan_inserter.h"

namespace loopscope {
namespace {

/// A scanner at (0, `y`) that sees a wall along x, at `wall_y`.
RangeData ScanOfWall(double y, double wall_y) {
  RangeData scan;
  scan.origin = {0.0, y};
  for (int i = -40; i <= 40; ++i) scan.returns.emplace_back(0.04 * i, wall_y);
  return scan;
}

/// What is known of a rack whose near side is at y = 2, seen from below, and of its far side at
/// y = 3.1, if that was seen too.
ProbabilityGrid GridOfRack(bool far_side_seen) {
  ProbabilityGrid grid(0.05);
  const ScanInserter inserter({0.7, 0.4, true});
  for (int i = 0; i < 4; ++i) {
    inserter.Insert(CastRays(ScanOfWall(0.0, 2.02), 0.05), &grid);
    if (far_side_seen) inserter.Insert(CastRays(ScanOfWall(5.0, 3.12), 0.05), &grid);
  }
  return grid;
}

double ShareFromBehind(const RangeData& scan, const Pose2& submap_from_scan,
                       const ProbabilityGrid& grid) {
  return FindReturnsOnWalls(scan, submap_from_scan, grid).ShareFromBehind();
}

TEST(ReturnsOnWalls, IsNoneWhereAWallIsSeenFromTheSameSide) {
  EXPECT_EQ(ShareFromBehind(ScanOfWall(0.5, 2.02), Pose2(), GridOfRack(false)), 0.0);
  EXPECT_EQ(ShareFromBehind(ScanOfWall(4.5, 3.12), Pose2(), GridOfRack(true)), 0.0);
}

TEST(ReturnsOnWalls, IsAllWhereTheFarSideLiesOnTheNearOne) {
  const RangeData far_side = ScanOfWall(4.5, 3.12);
  EXPECT_GT(ShareFromBehind(far_side, Pose2(0.0, -1.1, 0.0), GridOfRack(false)), 0.8);
  EXPECT_GT(ShareFromBehind(far_side, Pose2(0.0, -1.1, 0.0), GridOfRack(true)), 0.8);
}

TEST(ReturnsOnWalls, CountsOnlyWhatLiesOnWalls) {
  EXPECT_EQ(ShareFromBehind(ScanOfWall(4.5, 3.12), Pose2(0.0, -0.6, 0.0), GridOfRack(false)), 0.0);
  RangeData scan = ScanOfWall(4.5, 3.12);
  for (int i = 0; i < 500; ++i) scan.returns.emplace_back(50.0, 50.0);
  EXPECT_GT(ShareFromBehind(scan, Pose2(0.0, -1.1, 0.0), GridOfRack(false)), 0.8);
}

TEST(ReturnsOnWalls, BelievesAThinWallThatIsKnownFromBothSides) {
  ProbabilityGrid grid(0.05);
  const ScanInserter inserter({0.7, 0.4, true});
  for (int i = 0; i < 4; ++i) {
    inserter.Insert(CastRays(ScanOfWall(0.0, 2.02), 0.05), &grid);
    inserter.Insert(CastRays(ScanOfWall(4.0, 2.02), 0.05), &grid);
  }
  EXPECT_EQ(ShareFromBehind(ScanOfWall(3.0, 2.02), Pose2(), grid), 0.0);
}

TEST(ReturnsOnWalls, IsNoneOfAScanWithoutReturns) {
  EXPECT_EQ(ShareFromBehind(RangeData(), Pose2(), GridOfRack(true)), 0.0);
}

}  // namespace
}  // namespace loopscope
