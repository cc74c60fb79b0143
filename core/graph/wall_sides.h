// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"
#include "core/grid/probability_grid.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// POSE_GRAPH.constraint_builder.wall_sides, not in Cartographer: a grid has no normals, so that a
/// scan of one side of a rack or of a wall matches what a submap has of its other side, and the
/// loop is off by its thickness.
struct WallSidesOptions {
  double max_share_from_behind = 1.0;  ///< of the returns on walls of the submap, [0, 1]; 1: off
};

/// The returns of a scan that lie on walls of a submap.
struct ReturnsOnWalls {
  int count = 0;
  /// Those that end on a side that the submap has not seen: free space is not in front of the wall,
  /// where the beam came through, but behind it. In the frame of the submap.
  PointCloud from_behind;

  double ShareFromBehind() const {
    return count > 0 ? static_cast<double>(from_behind.size()) / count : 0.0;
  }
};

ReturnsOnWalls FindReturnsOnWalls(const RangeData& scan, const Pose2& submap_from_scan,
                                  const ProbabilityGrid& grid);

}  // namespace loopscope
