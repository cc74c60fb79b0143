// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid/cell.h"
#include "core/matching/search_trace.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// delta_theta of eqs. 6 and 7: a turn by it moves the farthest point by one cell at most.
double AngularStep(const PointCloud& points_in_scan, double resolution);

/// w_x of a window W_x of `linear_window` [m] (eq. 8).
int NumLinearSteps(double linear_window, double resolution);

/// The window of eqs. 8 to 10 in whole steps, half a width of `linear_window` [m] and
/// `angular_window` [rad].
SearchWindow MakeSearchWindow(const PointCloud& points_in_scan, const Pose2& submap_from_scan_guess,
                              double linear_window, double angular_window, double resolution);

/// Number of poses of W.
double NumPoses(const SearchWindow& window);

/// The pose of W at `offset` and `angle_index` (eq. 10).
Pose2 PoseInWindow(const SearchWindow& window, CellIndex offset, int angle_index);

}  // namespace loopscope
