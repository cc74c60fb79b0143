// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/scan_preparation.h"

namespace loopscope {

RangeData PrepareRangeData(const ScanLog& log, int scan, const LocalSlamOptions& options) {
  const LaserScan& laser_scan = log.scans[scan];
  RangeData data = ToRangeData(laser_scan, log.beam_geometries[laser_scan.beam_geometry],
                               log.base_from_laser, options.range);
  data.returns = VoxelFilter(data.returns, options.voxel_filter_size);
  data.misses = VoxelFilter(data.misses, options.voxel_filter_size);
  return data;
}

std::optional<PointCloud> PointsToMatch(const RangeData& range_data,
                                        const LocalSlamOptions& options) {
  PointCloud points = AdaptiveVoxelFilter(range_data.returns, options.adaptive_voxel_filter);
  if (points.empty() || static_cast<int>(points.size()) < options.min_num_matched_points) {
    return std::nullopt;
  }
  return points;
}

RangeData LoopScan(const RangeData& range_data, const LocalSlamOptions& options) {
  return {range_data.origin,
          AdaptiveVoxelFilter(range_data.returns, options.loop_closure_adaptive_voxel_filter),
          {}};
}

}  // namespace loopscope
