// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/local/local_slam_options.h"
#include "core/sensor/scan_log.h"

namespace loopscope {

/// The readings of scan `scan` of `log` that are used, voxel filtered, in the frame of the robot.
RangeData PrepareRangeData(const ScanLog& log, int scan, const LocalSlamOptions& options);

/// The returns that local matching uses, in the frame of the robot; nothing if they are too few.
std::optional<PointCloud> PointsToMatch(const RangeData& range_data,
                                        const LocalSlamOptions& options);

/// What loop searches use of a scan: some of its returns, and no misses.
RangeData LoopScan(const RangeData& range_data, const LocalSlamOptions& options);

}  // namespace loopscope
