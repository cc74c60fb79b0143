// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/sensor/voxel_filter.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/geometry/floor_to_int.h"

namespace loopscope {
namespace {

std::uint64_t VoxelKey(const Eigen::Vector2d& point, double voxel_size) {
  const int x = FloorToInt(point.x() / voxel_size);
  const int y = FloorToInt(point.y() / voxel_size);
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) |
         static_cast<std::uint32_t>(y);
}

/// The voxels that were taken, of a known number at most: a table with open addresses, for filters
/// are run a dozen times for each scan.
class VoxelSet {
 public:
  explicit VoxelSet(std::size_t max_size) {
    while ((std::size_t{1} << log_size_) < 2 * max_size) ++log_size_;
    slots_.resize(std::size_t{1} << log_size_, 0);
    keys_.reserve(max_size);
  }

  /// Whether it is new.
  bool Insert(std::uint64_t key) {
    constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = (key * kGoldenRatio) >> (64 - log_size_);; i = (i + 1) & mask) {
      if (slots_[i] == 0) {
        keys_.push_back(key);
        slots_[i] = static_cast<std::uint32_t>(keys_.size());
        return true;
      }
      if (keys_[slots_[i] - 1] == key) return false;
    }
  }

 private:
  int log_size_ = 1;
  std::vector<std::uint32_t> slots_;  ///< number in keys_, from 1 on; 0 if free
  std::vector<std::uint64_t> keys_;
};

PointCloud DropBeyond(const PointCloud& points, double max_range) {
  PointCloud near;
  near.reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    if (point.norm() <= max_range) near.push_back(point);
  }
  return near;
}

/// Whether points lie in at least `count` voxels.
bool HasVoxels(const PointCloud& points, double voxel_size, int count) {
  VoxelSet taken(points.size());
  int num_voxels = 0;
  for (const Eigen::Vector2d& point : points) {
    num_voxels += taken.Insert(VoxelKey(point, voxel_size));
    if (num_voxels >= count) return true;
  }
  return false;
}

}  // namespace

PointCloud VoxelFilter(const PointCloud& points, double voxel_size) {
  VoxelSet taken(points.size());
  PointCloud kept;
  kept.reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    if (taken.Insert(VoxelKey(point, voxel_size))) kept.push_back(point);
  }
  return kept;
}

PointCloud AdaptiveVoxelFilter(const PointCloud& points,
                               const AdaptiveVoxelFilterOptions& options) {
  const PointCloud near = DropBeyond(points, options.max_range);
  const auto enough_voxels_of = [&](double voxel_size) {
    return HasVoxels(near, voxel_size, options.min_num_points);
  };
  if (static_cast<int>(near.size()) < options.min_num_points) return near;
  if (enough_voxels_of(options.max_length)) return VoxelFilter(near, options.max_length);
  for (double high = options.max_length; high > 1e-2 * options.max_length; high /= 2.0) {
    double low = high / 2.0;
    if (!enough_voxels_of(low)) continue;
    for (double top = high; (top - low) / low > 1e-1;) {
      const double middle = (low + top) / 2.0;
      (enough_voxels_of(middle) ? low : top) = middle;
    }
    return VoxelFilter(near, low);
  }
  return near;
}

}  // namespace loopscope
