// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/grid/cell.h"
#include "core/matching/search_trace.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// delta_theta of eqs. 6 and 7: a turn by it moves the farthest point by one cell at most.
double AngularStep(const PointCloud& points_in_scan, double resolution);

/// The window of eqs. 8 to 10 in whole steps, half a width of `linear_window` [m] and
/// `angular_window` [rad].
SearchWindow MakeSearchWindow(const PointCloud& points_in_scan, const Pose2& submap_from_scan_guess,
                              double linear_window, double angular_window, double resolution);

/// The pose of W at `offset` and `angle_index` (eq. 10).
Pose2 PoseInWindow(const SearchWindow& window, CellIndex offset, int angle_index);

/// The cells of the points at the guess turned by `angle_index` steps. Since the window moves in
/// whole cells, they need only be shifted for every other pose of this angle.
std::vector<CellIndex> CellsAtAngle(const SearchWindow& window, const PointCloud& points_in_scan,
                                    int angle_index);

/// Likewise, into `cells`, which has room for a cell of each point.
void CellsAtAngle(const SearchWindow& window, const PointCloud& points_in_scan, int angle_index,
                  CellIndex* cells);

/// Where the points come lowest in x, and where in y, on their way from one angle of the window to
/// another: no cell on it is lower, and none is higher by more than `last_angle` - `first_angle`
/// + 1.
std::vector<CellIndex> LowestCells(const SearchWindow& window, const PointCloud& points_in_scan,
                                   int first_angle, int last_angle);

}  // namespace loopscope
