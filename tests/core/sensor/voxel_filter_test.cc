// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/sensor/voxel_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

PointCloud RandomPoints(int count, double half_width, Random* random) {
  PointCloud points(count);
  for (Eigen::Vector2d& point : points) {
    point = {random->Uniform(-half_width, half_width), random->Uniform(-half_width, half_width)};
  }
  return points;
}

std::pair<double, double> VoxelOf(const Eigen::Vector2d& point, double size) {
  return {std::floor(point.x() / size), std::floor(point.y() / size)};
}

/// The oracle: a point stays if none before it shares its voxel.
PointCloud FirstOfEachVoxel(const PointCloud& points, double size) {
  PointCloud kept;
  for (const Eigen::Vector2d& point : points) {
    const bool taken = std::any_of(kept.begin(), kept.end(), [&](const Eigen::Vector2d& other) {
      return VoxelOf(other, size) == VoxelOf(point, size);
    });
    if (!taken) kept.push_back(point);
  }
  return kept;
}

TEST(VoxelFilter, KeepsTheFirstPointOfEachVoxelInOrder) {
  Random random(1);
  for (const double size : {0.05, 0.3, 1.0}) {
    const PointCloud points = RandomPoints(500, 3.0, &random);
    EXPECT_EQ(VoxelFilter(points, size), FirstOfEachVoxel(points, size));
  }
}

TEST(VoxelFilter, TellsVoxelsAroundZeroApart) {
  const PointCloud points = {{0.1, 0.1}, {-0.1, 0.1}, {0.1, -0.1}, {-0.1, -0.1}};
  EXPECT_EQ(VoxelFilter(points, 1.0), points);
}

TEST(VoxelFilter, OfNothingIsNothing) { EXPECT_TRUE(VoxelFilter({}, 0.1).empty()); }

TEST(AdaptiveVoxelFilter, TakesTheCoarsestVoxelIfThatLeavesEnough) {
  Random random(2);
  const PointCloud points = RandomPoints(2000, 5.0, &random);
  EXPECT_EQ(AdaptiveVoxelFilter(points, {0.5, 100, 50.0}), VoxelFilter(points, 0.5));
}

TEST(AdaptiveVoxelFilter, LeavesEnoughPointsButFewMore) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const PointCloud points = RandomPoints(1000, random.Uniform(0.3, 8.0), &random);
    const AdaptiveVoxelFilterOptions options{4.0, 200, 50.0};
    const PointCloud filtered = AdaptiveVoxelFilter(points, options);
    EXPECT_GE(filtered.size(), 200u);
    // A tenth off the edge is a fifth off the number of voxels; and chance.
    EXPECT_LE(filtered.size(), 300u);
  }
}

TEST(AdaptiveVoxelFilter, KeepsAllPointsIfThereAreTooFew) {
  Random random(4);
  const PointCloud points = RandomPoints(99, 0.01, &random);
  EXPECT_EQ(AdaptiveVoxelFilter(points, {0.5, 100, 50.0}), points);
}

TEST(AdaptiveVoxelFilter, KeepsAllPointsIfNoVoxelIsFineEnough) {
  const PointCloud points(200, Eigen::Vector2d(1.0, 1.0));
  EXPECT_EQ(AdaptiveVoxelFilter(points, {0.5, 100, 50.0}), points);
}

TEST(AdaptiveVoxelFilter, DropsPointsBeyondTheRange) {
  const PointCloud points = {{3.0, 4.0}, {3.0, 4.1}, {-5.0, 0.0}, {0.0, -5.1}};
  EXPECT_EQ(AdaptiveVoxelFilter(points, {0.5, 1, 5.0}), (PointCloud{{3.0, 4.0}, {-5.0, 0.0}}));
}

}  // namespace
}  // namespace loopscope
