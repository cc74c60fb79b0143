// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/local/local_slam_options.h"
#include "core/sensor/scan_log.h"
#include "core/sensor/slow_odometry.h"

namespace loopscope {

/// Whether odometry measured no motion at all since the scan before, though more than
/// `max_changed_share` of what the scanner sees changed.
bool OdometryHangs(const ScanLog& log, const OdometryOfScans& odometry, int scan,
                   double max_changed_share);

/// Whether odometry measured a motion since the scan before that IsLeap.
bool OdometryLeaps(const OdometryOfScans& odometry, int scan);

/// ReadOdometryOfScans where odometry is used and neither hangs nor leaps; nothing elsewhere.
OdometryOfScans UsedOdometry(const ScanLog& log, const LocalSlamOptions& options);

}  // namespace loopscope
