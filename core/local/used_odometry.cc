// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/used_odometry.h"

#include <utility>

#include "core/geometry/leap.h"
#include "core/local/changed_ranges.h"

namespace loopscope {
namespace {

/// Where odometry has the robot at the scan before and at `scan`, if it does at both.
std::optional<std::pair<Pose2, Pose2>> OdometryBeforeAndAt(const ScanLog& log, int scan) {
  if (scan == 0) return std::nullopt;
  const auto before = OdometryOfScan(log, scan - 1);
  const auto now = OdometryOfScan(log, scan);
  if (!before || !now) return std::nullopt;
  return std::pair(before->odom_from_base, now->odom_from_base);
}

}  // namespace

bool OdometryHangs(const ScanLog& log, int scan, double max_changed_share) {
  const auto poses = OdometryBeforeAndAt(log, scan);
  return poses && poses->first == poses->second &&
         ShareOfChangedRanges(log.scans[scan - 1], log.scans[scan]) > max_changed_share;
}

bool OdometryLeaps(const ScanLog& log, int scan) {
  const auto poses = OdometryBeforeAndAt(log, scan);
  return poses && IsLeap(poses->first.Inverse() * poses->second);
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
