// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/local/local_slam_options.h"
#include "core/sensor/scan_log.h"

namespace loopscope {

/// Whether odometry measured no motion at all since the scan before, though more than
/// `max_changed_share` of what the scanner sees changed.
bool OdometryHangs(const ScanLog& log, int scan, double max_changed_share);

/// Whether odometry measured a motion since the scan before that IsLeap.
bool OdometryLeaps(const ScanLog& log, int scan);

/// odom_from_base at scan `scan`, if odometry is used, there is any, and it neither hangs nor
/// leaps.
std::optional<Pose2> UsedOdometry(const ScanLog& log, int scan, const LocalSlamOptions& options);

}  // namespace loopscope
