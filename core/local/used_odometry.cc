// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/used_odometry.h"

#include "core/geometry/leap.h"
#include "core/local/changed_ranges.h"

namespace loopscope {
namespace {

bool IsKnownAtAndBefore(const OdometryOfScans& odometry, int scan) {
  return scan > 0 && odometry[scan - 1] && odometry[scan];
}

}  // namespace

bool OdometryHangs(const ScanLog& log, const OdometryOfScans& odometry, int scan,
                   double max_changed_share) {
  return IsKnownAtAndBefore(odometry, scan) && *odometry[scan - 1] == *odometry[scan] &&
         ShareOfChangedRanges(log.scans[scan - 1], log.scans[scan]) > max_changed_share;
}

bool OdometryLeaps(const OdometryOfScans& odometry, int scan) {
  return IsKnownAtAndBefore(odometry, scan) &&
         IsLeap(odometry[scan - 1]->Inverse() * *odometry[scan]);
}

OdometryOfScans UsedOdometry(const ScanLog& log, const LocalSlamOptions& options) {
  if (!options.use_odometry) return OdometryOfScans(log.scans.size());
  const OdometryOfScans odometry = ReadOdometryOfScans(log);
  OdometryOfScans used = odometry;
  for (int scan = 0; scan < static_cast<int>(odometry.size()); ++scan) {
    if (OdometryLeaps(odometry, scan) ||
        OdometryHangs(log, odometry, scan, options.max_changed_share_at_standstill)) {
      used[scan].reset();
    }
  }
  return used;
}

}  // namespace loopscope
