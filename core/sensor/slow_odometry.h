// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/sensor/scan_log.h"

namespace loopscope {

/// odom_from_base at each scan of a log; nothing before the first reading.
using OdometryOfScans = std::vector<std::optional<Pose2>>;

/// How many scans there are for a reading of odometry. More than 1 if odometry is read more seldom
/// than the scanner, so that it tells the same at several scans in a row and then all of their
/// motion at once; a robot that rests now and then does not make it so.
int NumScansPerReading(const ScanLog& log);

/// OdometryOfScan of each. If odometry is slow as above, the motion that it tells at a scan is
/// spread evenly over the scans since the reading before.
OdometryOfScans ReadOdometryOfScans(const ScanLog& log);

}  // namespace loopscope
