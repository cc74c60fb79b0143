// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sensor/scan_log.h"

namespace loopscope {

/// Whether odometry measured no motion at all since the scan before, though more than
/// `max_changed_share` of what the scanner sees changed.
bool OdometryHangs(const ScanLog& log, int scan, double max_changed_share);

}  // namespace loopscope
