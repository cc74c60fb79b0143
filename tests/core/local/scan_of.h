// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sensor/scan_log.h"

namespace loopscope {

/// All beams come back from `range` [m].
inline LaserScan ScanOf(int num_beams, float range) {
  LaserScan scan;
  scan.ranges.assign(num_beams, range);
  return scan;
}

}  // namespace loopscope
