// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/sensor/scan_log.h"

namespace loopscope {

bool operator==(const BeamGeometry& a, const BeamGeometry& b) {
  return a.num_beams == b.num_beams && a.first_angle == b.first_angle &&
         a.angle_increment == b.angle_increment;
}

std::optional<OdometryReading> OdometryOfScan(const ScanLog& log, int scan) {
  const int num_before = log.scans[scan].num_odometry_before;
  if (num_before == 0) return std::nullopt;
  return log.odometry[num_before - 1];
}

}  // namespace loopscope
