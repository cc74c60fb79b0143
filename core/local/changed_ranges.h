// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sensor/scan_log.h"

namespace loopscope {

/// Of the beams that came back in both scans, the share that came back from elsewhere: from more
/// than 0.1 m or 2 % of the distance away. Of a robot that rests it is some percent, for noise at
/// edges and for people; 0 if there are too few such beams to tell.
double ShareOfChangedRanges(const LaserScan& before, const LaserScan& now);

/// Whether so much changed since the scan before that the robot moved by a metre or turned by some
/// 20 deg meanwhile.
bool ShowsAnotherPlace(const ScanLog& log, int scan);

}  // namespace loopscope
