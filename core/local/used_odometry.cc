// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/used_odometry.h"

#include "core/geometry/leap.h"
#include "core/local/changed_ranges.h"

namespace loopscope {

bool OdometryHangs(const ScanLog& log, int scan, double max_changed_share) {
  if (scan == 0) return false;
  const auto before = OdometryOfScan(log, scan - 1);
  const auto now = OdometryOfScan(log, scan);
  return before && now && before->odom_from_base == now->odom_from_base &&
         ShareOfChangedRanges(log.scans[scan - 1], log.scans[scan]) > max_changed_share;
}

bool OdometryLeaps(const ScanLog& log, int scan) {
  if (scan == 0) return false;
  const auto before = OdometryOfScan(log, scan - 1);
  const auto now = OdometryOfScan(log, scan);
  return before && now && IsLeap(before->odom_from_base.Inverse() * now->odom_from_base);
}

std::optional<Pose2> UsedOdometry(const ScanLog& log, int scan, const LocalSlamOptions& options) {
  if (!options.use_odometry) return std::nullopt;
  const auto reading = OdometryOfScan(log, scan);
  if (!reading || OdometryLeaps(log, scan) ||
      OdometryHangs(log, scan, options.max_changed_share_at_standstill)) {
    return std::nullopt;
  }
  return reading->odom_from_base;
}

}  // namespace loopscope
