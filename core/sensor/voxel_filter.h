// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sensor/range_data.h"

namespace loopscope {

/// Keeps the first point of each voxel of edge `voxel_size` [m], in the order of `points`.
PointCloud VoxelFilter(const PointCloud& points, double voxel_size);

/// TRAJECTORY_BUILDER_2D.adaptive_voxel_filter and .loop_closure_adaptive_voxel_filter.
struct AdaptiveVoxelFilterOptions {
  double max_length = 0.5;   ///< [m] edge of the coarsest voxel tried
  int min_num_points = 200;  ///< keep at least so many, if there are
  double max_range = 50.0;   ///< [m] points farther from the origin of the frame are dropped
};

/// Filters with the coarsest voxel (halved, then bisected to 10 %) that leaves min_num_points.
PointCloud AdaptiveVoxelFilter(const PointCloud& points, const AdaptiveVoxelFilterOptions& options);

}  // namespace loopscope
