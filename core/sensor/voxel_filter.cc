// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/sensor/voxel_filter.h"

#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace loopscope {
namespace {

std::uint64_t VoxelKey(const Eigen::Vector2d& point, double voxel_size) {
  const auto x = static_cast<std::int32_t>(std::floor(point.x() / voxel_size));
  const auto y = static_cast<std::int32_t>(std::floor(point.y() / voxel_size));
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) |
         static_cast<std::uint32_t>(y);
}

PointCloud DropBeyond(const PointCloud& points, double max_range) {
  PointCloud near;
  near.reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    if (point.norm() <= max_range) near.push_back(point);
  }
  return near;
}

}  // namespace

PointCloud VoxelFilter(const PointCloud& points, double voxel_size) {
  std::unordered_set<std::uint64_t> taken;
  taken.reserve(2 * points.size());
  PointCloud kept;
  kept.reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    if (taken.insert(VoxelKey(point, voxel_size)).second) kept.push_back(point);
  }
  return kept;
}

PointCloud AdaptiveVoxelFilter(const PointCloud& points,
                               const AdaptiveVoxelFilterOptions& options) {
  const PointCloud near = DropBeyond(points, options.max_range);
  const auto enough = [&](const PointCloud& filtered) {
    return static_cast<int>(filtered.size()) >= options.min_num_points;
  };
  if (!enough(near)) return near;
  PointCloud filtered = VoxelFilter(near, options.max_length);
  if (enough(filtered)) return filtered;
  for (double high = options.max_length; high > 1e-2 * options.max_length; high /= 2.0) {
    double low = high / 2.0;
    filtered = VoxelFilter(near, low);
    if (!enough(filtered)) continue;
    for (double top = high; (top - low) / low > 1e-1;) {
      const double middle = (low + top) / 2.0;
      PointCloud candidate = VoxelFilter(near, middle);
      if (enough(candidate)) {
        low = middle;
        filtered = std::move(candidate);
      } else {
        top = middle;
      }
    }
    return filtered;
  }
  return near;
}

}  // namespace loopscope
