// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/sensor/scan_log.h"

namespace loopscope {

/// What is in a log.
struct LogReport {
  double duration = 0.0;          ///< [s] from the smallest stamp of a scan to the largest
  double scan_period = 0.0;       ///< [s] median from scan to scan
  double longest_pause = 0.0;     ///< [s] from scan to scan
  int scan_after_pause = 0;       ///< index
  double odometry_length = 0.0;   ///< [m] way by odometry; 0 without
  double scan_distance = 0.0;     ///< [m] median way by odometry from scan to scan; 0 without
  double share_of_returns = 0.0;  ///< of all readings, in [0, 1]
  double share_of_nothing = 0.0;  ///< +infinity: nothing came back
  double share_of_invalid = 0.0;  ///< NaN
  double median_range = 0.0;      ///< [m] of the returns
  double largest_range = 0.0;     ///< [m] likewise
  /// What is unusual about the data, and what follows from it; a sentence or two each.
  std::vector<std::string> advice;
};

LogReport ReportOn(const ScanLog& log);

}  // namespace loopscope
