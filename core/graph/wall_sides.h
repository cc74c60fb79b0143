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

/// Of the returns of `scan` that lie on walls of `grid`, the share that ends on a side that the
/// submap has not seen: free space is not in front of the wall, where the beam came through, but
/// behind it. 0 if no return lies on a wall.
double ShareFromBehind(const RangeData& scan, const Pose2& submap_from_scan,
                       const ProbabilityGrid& grid);

}  // namespace loopscope
