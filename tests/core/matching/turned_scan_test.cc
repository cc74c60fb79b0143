// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/turned_scan.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/matching/search_lattice.h"
#include "tests/support/random_world.h"

namespace loopscope {
namespace {

PointCloud Scaled(PointCloud points, double factor) {
  for (Eigen::Vector2d& point : points) point *= factor;
  return points;
}

TEST(TurnedScan, CellsNeedOnlyBeShiftedForTheOtherPosesOfTheAngle) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const RandomWorld world = MakeRandomWorld(&random);
    const SearchWindow window =
        MakeSearchWindow(world.points_in_scan, world.submap_from_scan, 0.3, 0.2, 0.05);
    const CellIndex offset{random.Below(13) - 6, random.Below(13) - 6};
    const int angle = random.Below(7) - 3;
    const std::vector<CellIndex> cells = TurnedScan(window, world.points_in_scan).CellsAt(angle);
    ASSERT_EQ(cells.size(), world.points_in_scan.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      EXPECT_EQ((CellIndex{cells[k].x + offset.x, cells[k].y + offset.y}),
                CellOf(PoseInWindow(window, offset, angle) * world.points_in_scan[k], 0.05));
    }
  }
}

TEST(TurnedScan, CellsAreExactNextToTheirBorders) {
  Random random(2);
  constexpr double kResolution = 0.05;
  PointCloud points;
  for (int k = 0; k < 1000; ++k) {
    const double beside = random.Below(2) == 0 ? 0.0 : random.Uniform(-1e-6, 1e-6);
    const double border = (random.Below(4000) - 2000 + 0.5) * kResolution + beside;
    const double within = random.Uniform(-100.0, 100.0);
    points.push_back(random.Below(2) == 0 ? Eigen::Vector2d(border, within)
                                          : Eigen::Vector2d(within, border));
  }
  const Pose2 guess(0.15, -60.0, 0.0);  // whole cells
  const SearchWindow window = MakeSearchWindow(points, guess, 0.0, 0.0, kResolution);
  const std::vector<CellIndex> cells = TurnedScan(window, points).CellsAt(0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(cells[k], CellOf(guess * points[k], kResolution)) << points[k].transpose();
  }
}

TEST(TurnedScan, LowestCellsBoundThePointsAtAllAnglesBetween) {
  Random random(3);
  int num_tried = 0;
  for (int i = 0; i < 200; ++i) {
    const RandomWorld world = MakeRandomWorld(&random);
    const PointCloud points =
        Scaled(world.points_in_scan, i % 2 == 0 ? 1.0 : random.Uniform(0.1, 3.0));
    const SearchWindow window = MakeSearchWindow(points, world.submap_from_scan, 0.3, M_PI, 0.05);
    const int num_steps = i % 4 < 2 ? 7 : 15;
    if (!TurnedScan::HasLowestCells(window, num_steps + 1)) continue;
    ++num_tried;
    const int first = random.Below(window.num_angular_steps) - window.num_angular_steps / 2;
    const auto lowest = TurnedScan(window, points).LowestCells(first, first + num_steps);
    ASSERT_EQ(lowest.size(), points.size());
    for (int angle = first; angle <= first + num_steps; ++angle) {
      const std::vector<CellIndex> cells = TurnedScan(window, points).CellsAt(angle);
      for (std::size_t k = 0; k < cells.size(); ++k) {
        const CellIndex above{cells[k].x - lowest[k].x, cells[k].y - lowest[k].y};
        EXPECT_GE(std::min(above.x, above.y), 0);
        EXPECT_LE(std::max(above.x, above.y), num_steps + 1);
      }
    }
  }
  EXPECT_GT(num_tried, 120);
}

}  // namespace
}  // namespace loopscope
